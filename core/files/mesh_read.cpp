// Reads a mesh from glTF 2.0 (gltf_file.h). Counts are capped and every accessor is checked against its buffer before a
// vertex is read.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <glm/geometric.hpp>

#include "base/caught.h"
#include "base/text.h"
#include "files/files.h"
#include "files/gltf_file.h"

namespace weftlight::files {

using base::arg, base::fill, base::tr;
using drape::Mesh, drape::Vec2, drape::Vec3, drape::compute_frames;

namespace {

constexpr size_t kMaxVertices = 8'000'000, kMaxIndices = 48'000'000;
constexpr float kMmPerMetre = 1000.0f;
// Beyond a kilometre of cloth and ten kilometres of texture coordinates a float cannot resolve threads, and sums of
// squared areas overflow.
constexpr double kMaxPositionMm = 1e6, kMaxUvMm = 1e7;

template <class T>
const T& item(const std::vector<T>& list, int index, const char* what) {
  if (index < 0 || static_cast<size_t>(index) >= list.size())
    refuse(fill(tr("it refers to a missing {part}; export it again"), arg("part", what)));
  return list[static_cast<size_t>(index)];
}

/// An accessor with all its elements inside its buffer.
struct Elements {
  const unsigned char* data = nullptr;
  size_t count = 0, stride = 0;
  int component = 0, components = 0;
  bool normalised = false;

  double value(size_t i, int k) const {
    const unsigned char* at = data + i * stride;
    auto as = [at, k]<class T>(T) {
      T v;
      std::memcpy(&v, at + sizeof(T) * static_cast<size_t>(k), sizeof v);
      return static_cast<double>(v);
    };
    switch (component) {
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return as(float{});
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return as(uint32_t{});
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return as(uint16_t{}) / (normalised ? 65535.0 : 1.0);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return as(uint8_t{}) / (normalised ? 255.0 : 1.0);
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return normalised ? std::max(as(int16_t{}) / 32767.0, -1.0) : as(int16_t{});
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return normalised ? std::max(as(int8_t{}) / 127.0, -1.0) : as(int8_t{});
      default:
        return 0;
    }
  }
};

Elements elements(const tinygltf::Model& model, int index, int type, size_t most) {
  const tinygltf::Accessor& accessor = item(model.accessors, index, "accessor");
  if (accessor.type != type) refuse(tr("an accessor has the wrong number of components; export it again"));
  if (accessor.sparse.isSparse)
    refuse(tr("sparse accessors are not supported; export without morph targets or sparse data"));
  if (accessor.count < 1 || accessor.count > most)
    refuse(fill(tr("an accessor has {count} elements; 1 to {most} are read; export a lighter mesh"),
                arg("count", accessor.count), arg("most", most)));
  const tinygltf::BufferView& view = item(model.bufferViews, accessor.bufferView, "buffer view");
  const tinygltf::Buffer& buffer = item(model.buffers, view.buffer, "buffer");
  const int component = tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(accessor.componentType));
  if (component < 1 || accessor.componentType == TINYGLTF_COMPONENT_TYPE_DOUBLE)
    refuse(tr("an accessor's component type is unknown; export it again"));
  Elements out;
  out.count = accessor.count;
  out.component = accessor.componentType;
  out.components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(type));
  out.normalised = accessor.normalized;
  const size_t element = static_cast<size_t>(component) * static_cast<size_t>(out.components);
  out.stride = view.byteStride ? view.byteStride : element;
  const size_t total = buffer.data.size();
  const bool fits = out.stride >= element && out.stride <= 252 + element && view.byteOffset <= total &&
                    view.byteLength <= total - view.byteOffset && accessor.byteOffset <= view.byteLength &&
                    element <= view.byteLength - accessor.byteOffset &&
                    out.count - 1 <= (view.byteLength - accessor.byteOffset - element) / out.stride;
  if (!fits)
    refuse(tr("an accessor reaches past the end of its buffer: the file is cut short or damaged; export it again"));
  out.data = buffer.data.data() + view.byteOffset + accessor.byteOffset;
  return out;
}

float finite(double v, const char* what) {
  if (!std::isfinite(v) || std::abs(v) > 1e9)
    refuse(fill(tr("a {value} is not a usable number; export it again"), arg("value", what)));
  return static_cast<float>(v);
}

/// Column-major 4 x 4, as in glTF.
using Matrix = std::array<double, 16>;
constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix out{};
  for (size_t c = 0; c < 4; ++c) {
    for (size_t r = 0; r < 4; ++r) {
      for (size_t k = 0; k < 4; ++k) out[c * 4 + r] += a[k * 4 + r] * b[c * 4 + k];
    }
  }
  return out;
}

Matrix local_matrix(const tinygltf::Node& node) {
  Matrix m = kIdentity;
  if (node.matrix.size() == 16) {
    std::copy(node.matrix.begin(), node.matrix.end(), m.begin());
    return m;
  }
  const std::array<double, 3> s =
      node.scale.size() == 3 ? std::array{node.scale[0], node.scale[1], node.scale[2]} : std::array{1.0, 1.0, 1.0};
  if (node.rotation.size() == 4) {
    const double x = node.rotation[0], y = node.rotation[1], z = node.rotation[2], w = node.rotation[3];
    m = {1 - 2 * (y * y + z * z),
         2 * (x * y + z * w),
         2 * (x * z - y * w),
         0,
         2 * (x * y - z * w),
         1 - 2 * (x * x + z * z),
         2 * (y * z + x * w),
         0,
         2 * (x * z + y * w),
         2 * (y * z - x * w),
         1 - 2 * (x * x + y * y),
         0,
         0,
         0,
         0,
         1};
  }
  for (size_t c = 0; c < 3; ++c) {
    for (size_t r = 0; r < 3; ++r) m[c * 4 + r] *= s[c];
  }
  if (node.translation.size() == 3) std::copy(node.translation.begin(), node.translation.end(), m.begin() + 12);
  return m;
}

/// The matrix that transforms normals.
std::array<double, 9> cofactors(const Matrix& m) {
  return {m[5] * m[10] - m[6] * m[9], m[6] * m[8] - m[4] * m[10], m[4] * m[9] - m[5] * m[8],
          m[2] * m[9] - m[1] * m[10], m[0] * m[10] - m[2] * m[8], m[1] * m[8] - m[0] * m[9],
          m[1] * m[6] - m[2] * m[5],  m[2] * m[4] - m[0] * m[6],  m[0] * m[5] - m[1] * m[4]};
}

Vec3 transformed_normal(const std::array<double, 9>& m, const Elements& e, size_t i) {
  std::array<double, 3> v{};
  for (size_t c = 0; c < 3; ++c) {
    for (size_t r = 0; r < 3; ++r) v[r] += m[c * 3 + r] * e.value(i, static_cast<int>(c));
  }
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0};
  return {static_cast<float>(v[0] / length), static_cast<float>(v[1] / length), static_cast<float>(v[2] / length)};
}

/// The mesh while primitives are added. `normals_given`: all of them so far have normals.
struct Gathered {
  Mesh mesh;
  bool normals_given = true;
};

void add_triangles(Gathered& out, std::vector<uint32_t> corner, int mode, uint32_t base, bool mirrored) {
  const size_t n = corner.size();
  if (n < 3) return;
  const size_t count = mode == TINYGLTF_MODE_TRIANGLES ? n / 3 : n - 2;
  if (out.mesh.index.size() + 3 * count > kMaxIndices) refuse(tr("it has too many triangles; export a lighter mesh"));
  for (size_t t = 0; t < count; ++t) {
    size_t a = 3 * t, b = a + 1, c = a + 2;
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) a = t, b = t + 1 + t % 2, c = t + 2 - t % 2;
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) a = 0, b = t + 1, c = t + 2;
    if (mirrored) std::swap(b, c);
    for (size_t k : {a, b, c}) out.mesh.index.push_back(base + corner[k]);
  }
}

int attribute(const tinygltf::Primitive& primitive, const char* name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? -1 : found->second;
}

std::vector<uint32_t> corners(const tinygltf::Model& model, const tinygltf::Primitive& primitive, size_t vertices) {
  std::vector<uint32_t> out;
  if (primitive.indices < 0) {
    out.resize(vertices);
    for (size_t i = 0; i < vertices; ++i) out[i] = static_cast<uint32_t>(i);
    return out;
  }
  const Elements e = elements(model, primitive.indices, TINYGLTF_TYPE_SCALAR, kMaxIndices);
  if (e.component == TINYGLTF_COMPONENT_TYPE_FLOAT) refuse(tr("its indices are not whole numbers; export it again"));
  out.resize(e.count);
  for (size_t i = 0; i < e.count; ++i) {
    const double v = e.value(i, 0);
    if (v < 0 || v >= static_cast<double>(vertices))
      refuse(tr("a triangle refers to a missing vertex; export it again"));
    out[i] = static_cast<uint32_t>(v);
  }
  return out;
}

void add_primitive(Gathered& out, const tinygltf::Model& model, const tinygltf::Primitive& primitive, const Matrix& m) {
  const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  if (mode < TINYGLTF_MODE_TRIANGLES || mode > TINYGLTF_MODE_TRIANGLE_FAN) return;  // points and lines are not cloth
  const Elements position = elements(model, attribute(primitive, "POSITION"), TINYGLTF_TYPE_VEC3, kMaxVertices);
  if (attribute(primitive, "TEXCOORD_0") < 0) {
    refuse(
        tr("it has no texture coordinates (TEXCOORD_0), so the threads have no direction; unwrap it along the grain of "
           "the cloth and export again"));
  }
  const Elements uv = elements(model, attribute(primitive, "TEXCOORD_0"), TINYGLTF_TYPE_VEC2, kMaxVertices);
  const int normal_at = attribute(primitive, "NORMAL");
  const Elements normal = normal_at < 0 ? Elements{} : elements(model, normal_at, TINYGLTF_TYPE_VEC3, kMaxVertices);
  if (uv.count != position.count || (normal_at >= 0 && normal.count != position.count))
    refuse(tr("its attributes differ in length; export it again"));
  const size_t base = out.mesh.position_mm.size();
  if (base + position.count > kMaxVertices) refuse(tr("it has too many vertices; export a lighter mesh"));
  const std::array<double, 9> normal_matrix = cofactors(m);
  out.normals_given = out.normals_given && normal_at >= 0;
  for (size_t i = 0; i < position.count; ++i) {
    const double x = position.value(i, 0), y = position.value(i, 1), z = position.value(i, 2);
    Vec3 p;
    for (size_t r = 0; r < 3; ++r) {
      p[r] = finite((m[r] * x + m[4 + r] * y + m[8 + r] * z + m[12 + r]) * double{kMmPerMetre}, "position");
      if (std::abs(double{p[r]}) > kMaxPositionMm)
        refuse(tr("it is larger than a kilometre; glTF counts in metres: scale it and export again"));
    }
    out.mesh.position_mm.push_back(p);
    // glTF's second coordinate points down in the image, v points up along the warp.
    out.mesh.uv_mm.push_back(
        {-finite(uv.value(i, 0), "texture coordinate"), finite(uv.value(i, 1), "texture coordinate")});
    out.mesh.normal.push_back(normal_at >= 0 ? transformed_normal(normal_matrix, normal, i) : Vec3{});
  }
  const double determinant = m[0] * normal_matrix[0] + m[1] * normal_matrix[1] + m[2] * normal_matrix[2];
  if (determinant < 0) {
    for (size_t i = base; i < out.mesh.normal.size(); ++i) out.mesh.normal[i] = -out.mesh.normal[i];
  }
  add_triangles(out, corners(model, primitive, position.count), mode, static_cast<uint32_t>(base), determinant < 0);
}

void add_mesh(Gathered& out, const tinygltf::Model& model, int index, const Matrix& m) {
  const tinygltf::Mesh& mesh = item(model.meshes, index, "mesh");
  if (out.mesh.name.empty()) out.mesh.name = mesh.name;
  for (const tinygltf::Primitive& primitive : mesh.primitives) add_primitive(out, model, primitive, m);
}

std::vector<int> root_nodes(const tinygltf::Model& model) {
  if (!model.scenes.empty()) return item(model.scenes, std::max(model.defaultScene, 0), "scene").nodes;
  std::vector<bool> child(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes) {
    for (int c : node.children) {
      if (c >= 0 && static_cast<size_t>(c) < child.size()) child[static_cast<size_t>(c)] = true;
    }
  }
  std::vector<int> roots;
  for (size_t i = 0; i < child.size(); ++i) {
    if (!child[i]) roots.push_back(static_cast<int>(i));
  }
  return roots;
}

Gathered gather(const tinygltf::Model& model) {
  Gathered out;
  struct Visit {
    int node;
    Matrix above;
  };
  std::vector<Visit> stack;
  const std::vector<int> roots = root_nodes(model);
  for (auto r = roots.rbegin(); r != roots.rend(); ++r) stack.push_back({*r, kIdentity});
  std::vector<bool> seen(model.nodes.size(), false);
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    const tinygltf::Node& node = item(model.nodes, visit.node, "node");
    if (seen[static_cast<size_t>(visit.node)])
      refuse(tr("its nodes have a cycle, or one has two parents; export it again"));
    seen[static_cast<size_t>(visit.node)] = true;
    const Matrix m = product(visit.above, local_matrix(node));
    if (node.mesh >= 0) add_mesh(out, model, node.mesh, m);
    for (auto c = node.children.rbegin(); c != node.children.rend(); ++c) stack.push_back({*c, m});
  }
  if (model.nodes.empty()) {
    for (size_t i = 0; i < model.meshes.size(); ++i) add_mesh(out, model, static_cast<int>(i), kIdentity);
  }
  if (out.mesh.index.empty()) refuse(tr("it has no triangles in its scene; export a triangle mesh"));
  return out;
}

/// Scales the UVs so that texture area equals surface area.
void scale_uv(Mesh& mesh) {
  double surface = 0, texture = 0;
  for (size_t t = 0; t + 2 < mesh.index.size(); t += 3) {
    const Vec3 &a = mesh.position_mm[mesh.index[t]], &b = mesh.position_mm[mesh.index[t + 1]],
               &c = mesh.position_mm[mesh.index[t + 2]];
    const Vec2 &p = mesh.uv_mm[mesh.index[t]], &q = mesh.uv_mm[mesh.index[t + 1]], &r = mesh.uv_mm[mesh.index[t + 2]];
    std::array<double, 3> e{}, f{};
    for (size_t k = 0; k < 3; ++k) e[k] = double{b[k]} - double{a[k]}, f[k] = double{c[k]} - double{a[k]};
    surface += std::hypot(e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]);
    texture += std::abs((double{q[0]} - double{p[0]}) * (double{r[1]} - double{p[1]}) -
                        (double{q[1]} - double{p[1]}) * (double{r[0]} - double{p[0]}));
  }
  if (!(texture > 1e-12) || !(surface > 0))
    refuse(tr("its texture coordinates cover no area, so the threads have no direction; unwrap it and export again"));
  const float scale = static_cast<float>(std::sqrt(surface / texture));
  for (Vec2& uv : mesh.uv_mm) uv *= scale;
}

void check_uv(const Mesh& mesh) {
  for (const Vec2& uv : mesh.uv_mm) {
    if (!(std::abs(double{uv[0]}) <= kMaxUvMm && std::abs(double{uv[1]}) <= kMaxUvMm)) {
      refuse(
          tr("its texture coordinates run over ten kilometres of cloth; move the islands near the origin and export "
             "again"));
    }
  }
}

/// Computes tangents from the millimetre coordinates; normals of the file are kept if it has them.
void complete_frames(Gathered& gathered) {
  const std::vector<Vec3> given = gathered.mesh.normal;
  compute_frames(gathered.mesh);
  if (!gathered.normals_given) return;
  Mesh& mesh = gathered.mesh;
  for (size_t i = 0; i < given.size(); ++i) {
    const Vec3& n = given[i];
    Vec3& t = mesh.tangent[i];
    const Vec3 flat = t - glm::dot(n, t) * n;
    const float length = glm::length(flat);
    if (n == Vec3{} || !(length > 1e-6f)) continue;
    mesh.normal[i] = n;
    t = flat / length;
  }
}

Mesh read_checked(const std::string& path) {
  const GltfFile file = read_gltf(path);
  Gathered gathered = gather(file.model);
  if (!file.uv_mm) scale_uv(gathered.mesh);
  check_uv(gathered.mesh);
  complete_frames(gathered);
  if (gathered.mesh.name.empty()) gathered.mesh.name = std::filesystem::path(path).stem().string();
  return std::move(gathered.mesh);
}

}  // namespace

base::Result<Mesh> read_mesh(const std::string& path) {
  try {
    return read_checked(path);
  } catch (...) {
    return base::thrown(base::ErrorKind::kInput, path);
  }
}

}  // namespace weftlight::files
