#include "render_data/curved_mesh.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace weftlight::render_data {

namespace {

constexpr float kTurn = 0.9976f;  // cosine of 4 degrees: an edge whose normals differ by more is split
constexpr uint32_t kWhole = UINT32_MAX;

class EdgeSplitter {
 public:
  explicit EdgeSplitter(PreparedMesh& prepared) : mesh_(prepared.mesh), sky_(prepared.sky) {}

  std::vector<uint32_t> split(const std::vector<uint32_t>& index) {
    std::vector<uint32_t> out;
    out.reserve(index.size());
    for (size_t i = 0; i + 2 < index.size(); i += 3) add_parts({index[i], index[i + 1], index[i + 2]}, out);
    return out;
  }

 private:
  /// Vertex in the middle of an edge; kWhole where the edge is not split.
  uint32_t middle_of(uint32_t a, uint32_t b) {
    const auto [known, added] = middles_.try_emplace(uint64_t{std::min(a, b)} << 32 | std::max(a, b), kWhole);
    if (added && glm::dot(mesh_.normal[a], mesh_.normal[b]) < kTurn) known->second = make_middle(a, b);
    return known->second;
  }

  uint32_t make_middle(uint32_t a, uint32_t b) {
    const glm::vec3 p = mesh_.position_mm[a], q = mesh_.position_mm[b], n = mesh_.normal[a], m = mesh_.normal[b];
    const glm::vec3 lift = (glm::dot(p - q, n) * n + glm::dot(q - p, m) * m) * 0.125f;
    const glm::vec3 normal = glm::normalize(n + m);
    const glm::vec3 along = mesh_.tangent[a] + mesh_.tangent[b];
    const glm::vec3 tangent = along - normal * glm::dot(along, normal);
    const float length = glm::length(tangent);
    mesh_.position_mm.push_back(0.5f * (p + q) + lift);
    mesh_.normal.push_back(normal);
    mesh_.tangent.push_back(length > 0 ? tangent / length : mesh_.tangent[a]);
    mesh_.uv_mm.push_back(0.5f * (mesh_.uv_mm[a] + mesh_.uv_mm[b]));
    sky_.push_back({0.5f * (sky_[a].front + sky_[b].front), 0.5f * (sky_[a].back + sky_[b].back)});
    return static_cast<uint32_t>(mesh_.position_mm.size() - 1);
  }

  void add_parts(std::array<uint32_t, 3> c, std::vector<uint32_t>& out) {
    std::array<uint32_t, 3> mid{middle_of(c[0], c[1]), middle_of(c[1], c[2]), middle_of(c[2], c[0])};
    // Turned so that the first edge is split, and the last whole if any is.
    for (int k = 0; k < 2 && (mid[0] == kWhole || (mid[1] == kWhole && mid[2] != kWhole)); ++k) {
      c = {c[1], c[2], c[0]};
      mid = {mid[1], mid[2], mid[0]};
    }
    const auto add = [&](uint32_t a, uint32_t b, uint32_t d) { out.insert(out.end(), {a, b, d}); };
    if (mid[0] == kWhole) return add(c[0], c[1], c[2]);
    if (mid[1] == kWhole) {
      add(c[0], mid[0], c[2]);
      return add(mid[0], c[1], c[2]);
    }
    add(mid[0], c[1], mid[1]);
    if (mid[2] == kWhole) {
      add(c[0], mid[0], mid[1]);
      return add(c[0], mid[1], c[2]);
    }
    add(c[0], mid[0], mid[2]);
    add(mid[0], mid[1], mid[2]);
    add(mid[2], mid[1], c[2]);
  }

  Mesh& mesh_;
  std::vector<SkyVisibility>& sky_;
  std::unordered_map<uint64_t, uint32_t> middles_;
};

}  // namespace

void split_curved_edges(PreparedMesh& prepared) {
  constexpr int kTimes = 2;
  for (int i = 0; i < kTimes; ++i) prepared.fine = EdgeSplitter(prepared).split(prepared.fine);
}

}  // namespace weftlight::render_data
