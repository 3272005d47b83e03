#include "preview/rung_shares.h"

#include <algorithm>
#include <cmath>

#include "light/formulas.h"

namespace weftlight {

RungShares rung_shares(const PreparedMesh& prepared, const Camera& camera, int width, int height, float spacing_mm,
                       const std::array<float, 3>& edges) {
  const Mesh& mesh = prepared.mesh;
  std::vector<glm::vec3> pixel;   // z: 1 where the vertex lies before the eye
  pixel.reserve(mesh.position_mm.size());
  for (const Vec3& p : mesh.position_mm) {
    const glm::vec4 c = camera.world_to_clip * glm::vec4(p[0], p[1], p[2], 1);
    const float w = std::max(c.w, 1e-6f);
    pixel.push_back({(c.x / w * 0.5f + 0.5f) * static_cast<float>(width), (c.y / w * 0.5f + 0.5f) * static_cast<float>(height),
                     c.w > 0 ? 1.0f : 0.0f});
  }
  RungShares shares;
  float all = 0, octaves = 0;
  const std::vector<uint32_t>& index = prepared.coarse.empty() ? mesh.index : prepared.coarse;
  for (size_t i = 0; i + 2 < index.size(); i += 3) {
    const glm::vec3 &a = pixel[index[i]], &b = pixel[index[i + 1]], &c = pixel[index[i + 2]];
    const glm::vec2 middle = glm::vec2(a + b + c) / 3.0f;
    const bool off = middle.x < 0 || middle.y < 0 || middle.x > static_cast<float>(width) || middle.y > static_cast<float>(height);
    if (off || a.z * b.z * c.z <= 0) continue;
    const Vec2 &ua = mesh.uv_mm[index[i]], &ub = mesh.uv_mm[index[i + 1]], &uc = mesh.uv_mm[index[i + 2]];
    const float on_screen = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    const float on_cloth = std::abs((ub[0] - ua[0]) * (uc[1] - ua[1]) - (ub[1] - ua[1]) * (uc[0] - ua[0]));
    if (on_screen <= 1e-6f) continue;
    const float yarns = std::sqrt(on_cloth / on_screen) / std::max(spacing_mm, 1e-6f);
    const glm::vec4 weight = formulas::rung_weights(yarns, {edges[0], edges[1], edges[2]});
    for (int k = 0; k < 4; ++k) shares.of[static_cast<size_t>(k)] += weight[k] * on_screen;
    octaves += std::log2(std::max(yarns, 1e-6f)) * on_screen;
    all += on_screen;
  }
  if (all <= 0) return shares;
  for (float& s : shares.of) s /= all;
  shares.yarns_per_pixel = std::exp2(octaves / all);
  return shares;
}

}  // namespace weftlight
