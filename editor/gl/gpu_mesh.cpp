#include "gl/gpu_mesh.h"

#include <algorithm>
#include <utility>

#include "shaders/interop.h"

namespace weftlight::gl {

using drape::Vec2, drape::Vec3;

namespace {

struct Vertex {
  Vec3 position, normal, tangent;
  Vec2 uv_mm;
  SkyVisibility sky;
};

void attribute(Attribute slot, int size, size_t offset) {
  glEnableVertexAttribArray(slot);
  glVertexAttribPointer(slot, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(offset));
}

}  // namespace

void GpuMesh::fill(Part& part, const Mesh& mesh, const std::vector<SkyVisibility>& sky,
                   const std::vector<uint32_t>& index) {
  std::vector<Vertex> vertices(mesh.position_mm.size());
  for (size_t i = 0; i < vertices.size(); ++i) {
    Vertex& v = vertices[i];
    v.position = mesh.position_mm[i];
    v.normal = mesh.normal[i];
    v.tangent = i < mesh.tangent.size() ? mesh.tangent[i] : Vec3{1, 0, 0};
    if (i < mesh.uv_mm.size()) {
      for (size_t a = 0; a < 2; ++a)
        v.uv_mm[a] = static_cast<float>(static_cast<double>(mesh.uv_mm[i][a]) - uv_origin_[a]);
    }
    v.sky = sky[i];
  }
  part.count = static_cast<int>(index.size());
  glBindVertexArray(part.array.get());
  glBindBuffer(GL_ARRAY_BUFFER, part.vertices.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)), vertices.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, part.indices.get());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(index.size() * 4), index.data(), GL_STREAM_DRAW);
  attribute(kPosition, 3, offsetof(Vertex, position));
  attribute(kNormal, 3, offsetof(Vertex, normal));
  attribute(kTangent, 3, offsetof(Vertex, tangent));
  attribute(kUv, 2, offsetof(Vertex, uv_mm));
  attribute(kSky, 2, offsetof(Vertex, sky));
  glBindVertexArray(0);
}

void GpuMesh::upload(PreparedMesh mesh) {
  prepared_ = std::move(mesh);
  if (prepared_.fine.empty()) prepared_.fine = prepared_.coarse = prepared_.mesh.index;
  uv_origin_ = {};
  for (size_t i = 0; i < prepared_.mesh.uv_mm.size(); ++i) {
    for (size_t a = 0; a < 2; ++a) {
      const double at = static_cast<double>(prepared_.mesh.uv_mm[i][a]);
      uv_origin_[a] = i ? std::min(uv_origin_[a], at) : at;
    }
  }
  fill(cloth_, prepared_.mesh, prepared_.sky, prepared_.fine);
  fill(body_, prepared_.body, prepared_.body_sky, prepared_.body_fine);
  sorted_ = false;
  const int n = prepared_.ground_size;
  glBindTexture(GL_TEXTURE_2D, ground_sky_.get());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, n, n, 0, GL_RED, GL_UNSIGNED_BYTE, prepared_.ground_sky.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void GpuMesh::sort(glm::vec3 eye, TriangleOrder order, bool coarse) {
  if (sorted_ && eye == sorted_for_ && order == order_ && coarse == coarse_) return;
  sorted_ = true, sorted_for_ = eye, order_ = order, coarse_ = coarse;
  const std::vector<uint32_t>& index = coarse ? prepared_.coarse : prepared_.fine;
  const auto position = [&](size_t i) {
    const Vec3& p = prepared_.mesh.position_mm[index[i]];
    return glm::vec3(p[0], p[1], p[2]);
  };
  const float sign = order == TriangleOrder::kFrontToBack ? 1.0f : -1.0f;
  std::vector<std::pair<float, uint32_t>> triangles(index.size() / 3);
  for (size_t t = 0; t < triangles.size(); ++t) {
    const glm::vec3 d = (position(3 * t) + position(3 * t + 1) + position(3 * t + 2)) / 3.0f - eye;
    triangles[t] = {sign * glm::dot(d, d), static_cast<uint32_t>(t)};
  }
  std::sort(triangles.begin(), triangles.end());
  std::vector<uint32_t> sorted;
  sorted.reserve(index.size());
  for (const auto& [distance, t] : triangles) {
    for (size_t k = 0; k < 3; ++k) sorted.push_back(index[3 * static_cast<size_t>(t) + k]);
  }
  cloth_.count = static_cast<int>(sorted.size());
  glBindVertexArray(cloth_.array.get());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, cloth_.indices.get());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(sorted.size() * 4), sorted.data(), GL_STREAM_DRAW);
  glBindVertexArray(0);
}

void GpuMesh::draw_cloth() {
  if (!cloth_.count) return;
  glBindVertexArray(cloth_.array.get());
  glDrawElements(GL_TRIANGLES, cloth_.count, GL_UNSIGNED_INT, nullptr);
}

void GpuMesh::draw_body() {
  if (!body_.count) return;
  glBindVertexArray(body_.array.get());
  glDrawElements(GL_TRIANGLES, body_.count, GL_UNSIGNED_INT, nullptr);
}

}  // namespace weftlight::gl
