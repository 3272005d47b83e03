// Meshes of the bodies: surfaces of revolution, rings, and the zero set of a signed distance.
// Based on: Gibson, "Constrained Elastic Surface Nets", MICCAI 1998 (one vertex per cell).
// Differs: the vertex is then moved onto the surface along the gradient of the distance.

#include <algorithm>

#include "drape/bodies.h"
#include "drape/vec.h"

namespace weftlight::drape {

namespace {

void append_quad(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  mesh.index.insert(mesh.index.end(), {a, b, c, a, c, d});
}

/// Revolves a profile of (radius, height), outside from the bottom up, about the y axis.
/// `ahead`: angle of the first column, in columns.
void append_revolved(Mesh& mesh, const std::vector<Vec2>& profile, uint32_t around, float ahead = 0) {
  const auto first = static_cast<uint32_t>(mesh.position_mm.size());
  for (const Vec2& point : profile) {
    for (uint32_t k = 0; k < around; ++k) {
      const float phi = 2 * kPi * (static_cast<float>(k) + ahead) / static_cast<float>(around);
      mesh.position_mm.push_back({point[0] * std::sin(phi), point[1], point[0] * std::cos(phi)});
    }
  }
  for (uint32_t row = 0; row + 1 < profile.size(); ++row) {
    for (uint32_t k = 0; k < around; ++k) {
      const uint32_t a = first + row * around + k, b = first + row * around + (k + 1) % around;
      append_quad(mesh, a, b, b + around, a + around);
    }
  }
}

/// Appends a quarter circle about `centre` to the profile, starting at angle `from` in quarter turns (0: outwards, 1:
/// up).
void append_round(std::vector<Vec2>& profile, Vec2 centre, float radius, float from) {
  constexpr int kSteps = 5;
  for (int k = 0; k <= kSteps; ++k) {
    const float angle = (from + static_cast<float>(k) / kSteps) * kPi / 2;
    profile.push_back({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
  }
}

/// A disc with rounded edges.
std::vector<Vec2> disc(float radius, float bottom, float top, float edge) {
  std::vector<Vec2> profile{{0, bottom}};
  append_round(profile, {radius - edge, bottom + edge}, edge, -1);
  append_round(profile, {radius - edge, top - edge}, edge, 0);
  profile.push_back({0, top});
  return profile;
}

/// A small ball whose eight octants are moved apart to the corners of the box.
void append_box(Mesh& mesh, const RoundedBox& box) {
  constexpr int kRows = 6;
  constexpr uint32_t kAround = 4 * kRows;
  const auto first = mesh.position_mm.size();
  std::vector<Vec2> profile;
  for (const float from : {-1.0f, 0.0f}) append_round(profile, {0, from < 0 ? -1.0f : 1.0f}, box.edge, from);
  profile.front()[0] = profile.back()[0] = 0;
  append_revolved(mesh, profile, kAround, 0.5f);
  const Vec3 core = box.half - box.edge;
  for (size_t i = first; i < mesh.position_mm.size(); ++i) {
    Vec3& p = mesh.position_mm[i];
    const size_t around = (i - first) % kAround;
    const bool upper = i - first >= (mesh.position_mm.size() - first) / 2;
    p[1] += upper ? -1.0f : 1.0f;  // the profile separated its halves by this much
    p += core * Vec3{around < kAround / 2 ? 1.0f : -1.0f, upper ? 1.0f : -1.0f,
                     around < kAround / 4 || around >= 3 * kAround / 4 ? 1.0f : -1.0f};
    p = box.centre + lean_back(p, box.lean_rad);
  }
  const auto corner = [&](size_t row, uint32_t quarter) {
    return static_cast<uint32_t>(first + row * kAround + quarter * kAround / 4);
  };
  const size_t top = profile.size() - 1;
  append_quad(mesh, corner(top, 0), corner(top, 1), corner(top, 2), corner(top, 3));
  append_quad(mesh, corner(0, 3), corner(0, 2), corner(0, 1), corner(0, 0));
}

void append_ball(Mesh& mesh) {
  std::vector<Vec2> profile;
  for (int k = 0; k <= 48; ++k) {
    const float angle = kPi * static_cast<float>(k) / 48;
    profile.push_back({kBallRadius * std::sin(angle), kBallRadius * (1 - std::cos(angle))});
  }
  append_revolved(mesh, profile, 96);
}

void append_table(Mesh& mesh) {
  append_revolved(mesh, disc(kTableRadius, kTableHeight - 28, kTableHeight, 13), 128);
  append_revolved(mesh, {{62, 18}, {48, 40}, {38, 90}, {36, 560}, {44, 650}, {90, kTableHeight - 28}}, 48);
  append_revolved(mesh, disc(260, 0, 20, 9), 96);
}

/// Lowers the form and puts a stand under it.
void append_stand(Mesh& mesh, float lowered) {
  for (Vec3& p : mesh.position_mm) p[1] -= lowered;
  append_revolved(mesh, {{15, 14}, {13, 40}, {13, 800 - lowered}}, 32);
  append_revolved(mesh, disc(165, 0, 16, 7), 96);
}

/// A ring about the rod at x.
void append_ring(Mesh& mesh, float x) {
  constexpr uint32_t kAround = 40, kAcross = 10;
  const auto first = static_cast<uint32_t>(mesh.position_mm.size());
  const float middle = kRodHeight + kRodRadius - kRingRadius + 3;
  for (uint32_t i = 0; i < kAround; ++i) {
    for (uint32_t k = 0; k < kAcross; ++k) {
      const float phi = 2 * kPi * static_cast<float>(i) / kAround;
      const float theta = 2 * kPi * static_cast<float>(k) / kAcross;
      const float out = kRingRadius + 2.6f * std::cos(theta);
      mesh.position_mm.push_back({x + 2.6f * std::sin(theta), middle + out * std::sin(phi), out * std::cos(phi)});
    }
  }
  for (uint32_t i = 0; i < kAround; ++i) {
    for (uint32_t k = 0; k < kAcross; ++k) {
      const uint32_t i1 = (i + 1) % kAround, k1 = (k + 1) % kAcross;
      append_quad(mesh, first + i * kAcross + k, first + i * kAcross + k1, first + i1 * kAcross + k1,
                  first + i1 * kAcross + k);
    }
  }
}

void append_rod(Mesh& mesh) {
  constexpr float kKnob = 14;
  std::vector<Vec2> profile{{0, -kRodHalfLength - 2 * kKnob}};
  for (const float from : {-1.0f, 0.0f}) append_round(profile, {kRodRadius, -kRodHalfLength - kKnob}, kKnob, from);
  // The normals at the corner between knob and rod lean to both: a ring beside it keeps them off the rod's long faces.
  profile.push_back({kRodRadius, -kRodHalfLength + 2});
  const size_t half = profile.size();
  for (size_t k = half; k-- > 0;) profile.push_back({profile[k][0], -profile[k][1]});
  append_revolved(mesh, profile, 40);
  // Revolved about y; the rod runs along x.
  for (Vec3& p : mesh.position_mm) p = {p[1], kRodHeight - p[0], p[2]};
  for (int ring = 0; ring < kRings; ++ring) append_ring(mesh, ring_x(ring));
}

/// Samples of a distance on a grid of cubes.
struct Samples {
  std::array<int, 3> count;
  Vec3 origin;
  float width;
  std::vector<float> value;

  size_t at(int x, int y, int z) const {
    return (static_cast<size_t>(z) * static_cast<size_t>(count[1]) + static_cast<size_t>(y)) *
               static_cast<size_t>(count[0]) +
           static_cast<size_t>(x);
  }
  Vec3 position(int x, int y, int z) const {
    return origin + Vec3{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)} * width;
  }
};

Samples sample(const Distance& distance, Vec3 low, Vec3 high, float width) {
  Samples s{{}, low, width, {}};
  for (size_t k = 0; k < 3; ++k) s.count[k] = static_cast<int>((high[k] - low[k]) / width) + 1;
  for (int z = 0; z < s.count[2]; ++z) {
    for (int y = 0; y < s.count[1]; ++y) {
      for (int x = 0; x < s.count[0]; ++x) s.value.push_back(distance(s.position(x, y, z)));
    }
  }
  return s;
}

/// Number of corners of a cell that are inside the body, 0 to 8.
int corners_inside(const Samples& s, int x, int y, int z) {
  int inside = 0;
  for (int k = 0; k < 8; ++k) inside += s.value[s.at(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2))] < 0;
  return inside;
}

/// The mean of the points where the edges of a cell cross the surface.
Vec3 middle_of_crossings(const Samples& s, int x, int y, int z) {
  Vec3 sum{};
  int crossings = 0;
  for (int k = 0; k < 8; ++k) {
    const std::array corner{x + (k & 1), y + (k >> 1 & 1), z + (k >> 2)};
    const float here = s.value[s.at(corner[0], corner[1], corner[2])];
    for (int axis = 0; axis < 3; ++axis) {
      if (k >> axis & 1) continue;
      std::array to = corner;
      ++to[static_cast<size_t>(axis)];
      const float there = s.value[s.at(to[0], to[1], to[2])];
      if ((here < 0) == (there < 0)) continue;
      sum += mix(s.position(corner[0], corner[1], corner[2]), s.position(to[0], to[1], to[2]), here / (here - there));
      ++crossings;
    }
  }
  return sum / static_cast<float>(crossings);
}

void append_zero_set(Mesh& mesh, const Distance& distance, const Samples& s) {
  std::vector<uint32_t> vertex(s.value.size(), 0);
  const auto [nx, ny, nz] = s.count;
  for (int z = 0; z + 1 < nz; ++z) {
    for (int y = 0; y + 1 < ny; ++y) {
      for (int x = 0; x + 1 < nx; ++x) {
        const int inside = corners_inside(s, x, y, z);
        if (inside == 0 || inside == 8) continue;
        vertex[s.at(x, y, z)] = static_cast<uint32_t>(mesh.position_mm.size());
        mesh.position_mm.push_back(project_to_surface(distance, middle_of_crossings(s, x, y, z)));
      }
    }
  }
  // One quad for each grid edge that crosses the surface, from the four cells around the edge.
  const auto quad = [&](bool out, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    out ? append_quad(mesh, a, b, c, d) : append_quad(mesh, d, c, b, a);
  };
  for (int z = 1; z + 1 < nz; ++z) {
    for (int y = 1; y + 1 < ny; ++y) {
      for (int x = 1; x + 1 < nx; ++x) {
        const bool here = s.value[s.at(x, y, z)] < 0;
        const auto v = [&](int dx, int dy, int dz) { return vertex[s.at(x - dx, y - dy, z - dz)]; };
        if (here != (s.value[s.at(x + 1, y, z)] < 0)) quad(here, v(0, 1, 1), v(0, 0, 1), v(0, 0, 0), v(0, 1, 0));
        if (here != (s.value[s.at(x, y + 1, z)] < 0)) quad(here, v(1, 0, 1), v(1, 0, 0), v(0, 0, 0), v(0, 0, 1));
        if (here != (s.value[s.at(x, y, z + 1)] < 0)) quad(here, v(1, 1, 0), v(0, 1, 0), v(0, 0, 0), v(1, 0, 0));
      }
    }
  }
}

}  // namespace

Mesh mesh_of_body(const std::string& name) {
  Mesh mesh;
  mesh.name = name + "_body";
  if (name == "sphere") append_ball(mesh);
  if (name == "tablecloth") append_table(mesh);
  if (name == "curtain") append_rod(mesh);
  if (name == "skirt") {
    // Vertices stand in planes of the grid, one of which is just above the cloth's edge: shade ends there in a line.
    constexpr float kCell = 8, kLowest = kWaistHeight + 1 - 41 * kCell;
    append_zero_set(mesh, taped_skirt_form, sample(taped_skirt_form, {-200, kLowest, -160}, {200, 1160, 160}, kCell));
    append_stand(mesh, kSkirtLowered);
  }
  if (name == "cushion") {
    for (const RoundedBox& box : board_boxes()) append_box(mesh, box);
  }
  if (name == "scarf") {
    append_zero_set(mesh, dress_form, sample(dress_form, {-520, 730, -160}, {520, 1545, 160}, 11));
    append_stand(mesh, kTunicLowered);
  }
  if (name == "tunic" || name == "shirt") {
    const auto form = [arm = lowered_arm(1)](Vec3 p) { return form_with(arm, p); };
    append_zero_set(mesh, form, sample(form, {-340, 730, -180}, {340, 1545, 220}, 11));
    append_stand(mesh, kTunicLowered);
  }
  mesh.uv_mm.assign(mesh.position_mm.size(), Vec2{});
  compute_frames(mesh);
  return mesh;
}

}  // namespace weftlight::drape
