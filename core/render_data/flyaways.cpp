// Roots are scattered at random over the parts of the surface that are seen edge-on. At a silhouette with radius of
// curvature R, a fibre whose root is turned by phi from the edge reaches past it if it is longer than h = R phi^2 / 2.
// Lengths fall off exponentially, so exp(-h / mean) of the fibres do, and those are distributed beyond h as all are
// beyond 0: only these are scattered.
//
// Based on: Cook, Halstead, Planck, Ryu 2007, "Stochastic simplification of aggregate detail" (fewer and wider, by
// size on screen, for the same coverage); O'Neill 2014, "PCG" (random numbers).

#include "render_data/flyaways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "light/formulas.h"

namespace weftlight::render_data {

using drape::PositionOrder, drape::Vec3;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kSparse = 0.5f;  // largest total width, in pixels, of the fibres that one stands for
// Mean length at which fibres start to appear, and are there in full. Shorter ones would be dots, not fibres.
constexpr float kMinPixels = 1.5f, kFullPixels = 4;
constexpr float kMinBend = 1.0f / 300;  // 1/mm, so that a plane seen edge-on has fibres, too
constexpr float kPolygon = 0.35f;       // distance of the mesh's silhouette from the true one, in triangles
constexpr float kMinChance = 0.01f;
constexpr float kFlat = 0.02f;   // radians by which the normals of a flat triangle turn at most
constexpr float kHemRadius = 8;  // in mean lengths: the background of a hem is seldom the cloth itself
constexpr float kPerPiece = 24;  // fibres in a triangle that is not subdivided
constexpr int kMaxDivisions = 14;

uint32_t stepped(uint32_t state) { return state * 747796405u + 2891336453u; }

uint32_t scrambled(uint32_t state) {
  const uint32_t word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

uint32_t hashed(uint32_t x) { return scrambled(stepped(x)); }

class Random {
 public:
  explicit Random(uint32_t seed) : state_(seed) {}
  float operator()() {
    state_ = stepped(state_);
    return static_cast<float>(scrambled(state_) >> 8) / 16777216.0f;
  }

 private:
  uint32_t state_;
};

struct Corner {
  glm::vec3 at{0}, normal{0};
  glm::vec2 uv_mm{0}, sky{1};
};

Corner between(const Corner& a, const Corner& b, float t) {
  return {glm::mix(a.at, b.at, t), glm::mix(a.normal, b.normal, t), glm::mix(a.uv_mm, b.uv_mm, t),
          glm::mix(a.sky, b.sky, t)};
}

Corner middle(const Corner& a, const Corner& b) { return between(a, b, 0.5f); }

Corner inside(const std::array<Corner, 3>& c, float u, float v) {
  const Corner edge = between(c[1], c[2], v);
  return between(c[0], edge, std::sqrt(u));
}

class FlyawayScatterer {
 public:
  /// `kept`: fraction of the fibres that fits the budget; 0 only counts.
  FlyawayScatterer(const FlyawayGrowth& growth, const FlyawayView& view, float kept, std::vector<Flyaway>& flyaways)
      : growth_(growth), view_(view), rows_(glm::transpose(view.world_to_clip)), kept_(kept), flyaways_(flyaways) {
    pixel_scale_ = 2 / (view.height * std::max(glm::length(glm::vec3(rows_[1])), 1e-12f));
    reach_mm_ = 4.5f * std::max(growth.length_mm[0], growth.length_mm[1]);
  }

  float expected() const { return expected_; }

  void triangle(const std::array<Corner, 3>& corners, uint32_t seed) {
    const glm::vec3 ab = corners[1].at - corners[0].at, ac = corners[2].at - corners[0].at;
    const glm::vec3 area2 = glm::cross(ab, ac);
    const float twice = glm::length(area2);
    if (!(twice > 1e-12f)) return;
    const glm::vec3 n = glm::normalize(corners[0].normal + corners[1].normal + corners[2].normal);
    const glm::vec3 to_eye = view_.eye - corners[0].at;
    glm::vec3 along = to_eye - n * glm::dot(to_eye, n);
    along /= std::max(glm::length(along), 1e-9f);
    // Change of the normal along the line of sight; linear over the triangle.
    const float b = glm::dot(glm::cross(along, ac), area2) / (twice * twice);
    const float c = glm::dot(glm::cross(ab, along), area2) / (twice * twice);
    const glm::vec3 turn = corners[0].normal * (-b - c) + corners[1].normal * b + corners[2].normal * c;
    const float bend = glm::dot(turn, along);  // > 0: the front bulges
    const float x = glm::dot(ab, along), y = glm::dot(ac, along);
    const float turned = std::abs(bend) * std::max({std::abs(x), std::abs(y), std::abs(x - y)});
    slack_ = kPolygon * turned;
    radius_mm_ = 1 / std::max(std::abs(bend), kMinBend);
    // At a concave side the silhouette is hidden behind the cloth.
    const bool flat = turned < kFlat;
    open_ = {growth_.per_mm2[0] > 0 && (flat || bend > 0), growth_.per_mm2[1] > 0 && (flat || bend < 0)};
    divide(corners, 0.5f * twice, seed, 0);
  }

  void hem(const Corner& from, const Corner& to, glm::vec3 outward, uint32_t seed) {
    const std::array<Corner, 2> ends{from, to};
    if (outside(ends)) return;
    const Corner mid = middle(from, to);
    const float each = 0.5f * (growth_.per_mm2[0] + growth_.per_mm2[1]);
    const float area = glm::length(to.at - from.at) * kPi * growth_.hem_mm;
    radius_mm_ = kHemRadius * std::max(growth_.length_mm[0], growth_.length_mm[1]);
    Random random(seed);
    const float fraction = drawn_fraction(mid.at, std::max(growth_.length_mm[0], growth_.length_mm[1]));
    const int count = counted(area * each * fraction, random());
    for (int i = 0; i < count; ++i) {
      const float t = random(), turn = kPi * (random() - 0.5f), kept = random(), which = random();
      Corner root = between(from, to, t);
      const glm::vec3 n = glm::normalize(root.normal);
      const float side = turn >= 0 ? 1.0f : -1.0f;
      root.normal = side * (outward * std::cos(turn) + n * std::sin(turn));
      keep(root, side, 0, 1, kept, which, fraction);
    }
  }

 private:
  template <size_t N>
  bool outside(const std::array<Corner, N>& corners) const {
    std::array<bool, 5> all{true, true, true, true, true};
    for (const Corner& c : corners) {
      const glm::vec4 p = view_.world_to_clip * glm::vec4(c.at, 1);
      const float x = reach_mm_ * glm::length(glm::vec3(rows_[0])), y = reach_mm_ * glm::length(glm::vec3(rows_[1]));
      all[0] &= p.x > p.w + x, all[1] &= p.x<-p.w - x, all[2] &= p.y> p.w + y, all[3] &= p.y < -p.w - y;
      all[4] &= p.w <= 0;
    }
    return all[0] || all[1] || all[2] || all[3] || all[4];
  }

  /// Fraction of the fibres that is drawn at this pixel size.
  float drawn_fraction(glm::vec3 at, float length_mm) const {
    const float w = glm::dot(rows_[3], glm::vec4(at, 1));
    if (!(w > 0)) return 0;
    const float pixel_mm = w * pixel_scale_;
    if (length_mm <= kMinPixels * pixel_mm) return 0;
    const float few = std::min(1.0f, formulas::kFlyawayWidth / (pixel_mm * kSparse));
    return few * (kept_ > 0 ? kept_ : 1.0f);
  }

  /// An integer whose mean is `expected`.
  int counted(float expected, float random) {
    expected_ += expected;
    return kept_ > 0 ? static_cast<int>(std::floor(expected + random)) : 0;
  }

  void divide(const std::array<Corner, 3>& c, float area, uint32_t seed, int depth) {
    if (outside(c)) return;
    std::array<float, 3> facing;
    for (size_t i = 0; i < 3; ++i)
      facing[i] = glm::dot(glm::normalize(c[i].normal), glm::normalize(view_.eye - c[i].at));
    const auto [low, high] = std::minmax_element(facing.begin(), facing.end());
    const float least = *low > 0 ? *low : (*high < 0 ? -*high : 0.0f);
    const Corner mid = middle(middle(c[0], c[1]), c[2]);
    std::array<float, 2> fraction{}, chance{}, expected{};
    for (size_t side = 0; side < 2; ++side) {
      chance[side] = open_[side] ? chance_of(needed_mm(least), side) : 0;
      if (chance[side] < kMinChance) continue;
      fraction[side] = drawn_fraction(mid.at, growth_.length_mm[side]);
      expected[side] = area * growth_.per_mm2[side] * fraction[side] * chance[side];
    }
    if (std::max(expected[0], expected[1]) > kPerPiece && depth < kMaxDivisions) {
      const Corner ab = middle(c[0], c[1]), bc = middle(c[1], c[2]), ca = middle(c[2], c[0]);
      divide({c[0], ab, ca}, area / 4, hashed(seed), depth + 1);
      divide({ab, c[1], bc}, area / 4, hashed(seed + 1), depth + 1);
      divide({ca, bc, c[2]}, area / 4, hashed(seed + 2), depth + 1);
      divide({ab, bc, ca}, area / 4, hashed(seed + 3), depth + 1);
      return;
    }
    for (size_t side = 0; side < 2; ++side)
      scatter_in(c, expected[side], side, chance[side], fraction[side], hashed(seed ^ (side ? 0x9e3779b9u : 0u)));
  }

  void scatter_in(const std::array<Corner, 3>& c, float expected, size_t side, float chance, float fraction,
                  uint32_t seed) {
    Random random(seed);
    const int count = counted(expected, random());
    for (int i = 0; i < count; ++i) {
      const float u = random(), v = random(), kept = random(), which = random();
      Corner root = inside(c, u, v);
      root.normal = glm::normalize(root.normal);
      const float facing = glm::dot(root.normal, glm::normalize(view_.eye - root.at));
      keep(root, side ? -1.0f : 1.0f, needed_mm(std::abs(facing)), chance, kept, which, fraction);
    }
  }

  /// Length that reaches past the silhouette from where |n.v| is `facing`.
  float needed_mm(float facing) const {
    const float beyond = std::max(facing - slack_, 0.0f);
    return 0.5f * radius_mm_ * beyond * beyond;
  }

  float chance_of(float needed_mm, size_t side) const { return std::exp(-needed_mm / growth_.length_mm[side]); }

  /// `chance`: that of the patch, already in the number of roots; `kept`: random.
  void keep(const Corner& root, float side, float needed_mm, float chance, float kept, float which, float fraction) {
    const size_t s = side > 0 ? 0 : 1;
    if (!(growth_.length_mm[s] > 0)) return;
    const float pixel_mm = glm::dot(rows_[3], glm::vec4(root.at, 1)) * pixel_scale_;
    const float pixels = growth_.length_mm[s] / std::max(pixel_mm, 1e-9f);
    const float come = std::clamp((pixels - kMinPixels) / (kFullPixels - kMinPixels), 0.0f, 1.0f);
    if (kept * chance >= chance_of(needed_mm, s)) return;
    // A limit, so that they do not form a ribbon; on a mesh with few triangles some are left out instead.
    const float most = std::max(1.0f, pixel_mm / formulas::kFlyawayWidth);
    // They appear all together and faintly: few at full strength would be dots.
    const float stands_for = come * std::min(1 / std::max(fraction, 1e-9f), most);
    flyaways_.push_back({root.at, root.normal * side, root.uv_mm, s ? root.sky.y : root.sky.x, side, which, stands_for,
                         needed_mm, radius_mm_});
  }

  const FlyawayGrowth& growth_;
  const FlyawayView& view_;
  glm::mat4 rows_;
  float kept_;
  std::vector<Flyaway>& flyaways_;
  float pixel_scale_ = 0;  // size of a pixel in mm over its distance
  float reach_mm_ = 0;
  float expected_ = 0;
  float radius_mm_ = 1;  // radius of curvature along the line of sight
  float slack_ = 0;      // sine
  std::array<bool, 2> open_{};
};

Corner corner_of(const PreparedMesh& p, uint32_t v, std::array<double, 2> origin) {
  Corner c{p.mesh.position_mm[v], p.mesh.normal[v], {}, {}};
  if (v < p.mesh.uv_mm.size()) {
    for (int a = 0; a < 2; ++a) {
      const size_t i = static_cast<size_t>(a);
      c.uv_mm[a] = static_cast<float>(static_cast<double>(p.mesh.uv_mm[v][i]) - origin[i]);
    }
  }
  if (v < p.sky.size()) c.sky = {p.sky[v].front, p.sky[v].back};
  return c;
}

void scatter(FlyawayScatterer& scatterer, const PreparedMesh& p, const std::vector<Hem>& hems,
             std::array<double, 2> origin) {
  const std::vector<uint32_t>& index = p.fine;
  for (size_t i = 0; i + 2 < index.size(); i += 3) {
    scatterer.triangle(
        {corner_of(p, index[i], origin), corner_of(p, index[i + 1], origin), corner_of(p, index[i + 2], origin)},
        hashed(static_cast<uint32_t>(i)));
  }
  for (size_t i = 0; i < hems.size(); ++i) {
    scatterer.hem(corner_of(p, hems[i].from, origin), corner_of(p, hems[i].to, origin), hems[i].outward,
                  hashed(static_cast<uint32_t>(i) ^ 0x5bd1e995u));
  }
}

}  // namespace

FlyawayGrowth flyaway_growth(const interop::ClothData& cloth, Face front) {
  FlyawayGrowth growth;
  growth.hem_mm = 0.5f * cloth.spacing_mm;
  for (size_t side = 0; side < 2; ++side) {
    const size_t face = front == Face::kFront ? side : 1 - side;
    float standing = 0, deep = 0;
    for (size_t system = 0; system < 2; ++system) {
      const interop::SystemData& s = cloth.systems[face * 2 + system];
      const float fraction = std::clamp(s.coverage, 0.0f, 1.0f) * formulas::flyaway_fraction(s.yarn.fuzz);
      standing += fraction, deep += fraction * s.yarn.fuzz_depth;
    }
    if (!(standing > 0)) continue;
    growth.per_mm2[side] = standing * formulas::kFlyawaysPerMm2;
    growth.length_mm[side] = deep / standing * formulas::kFlyawayLength;
  }
  return growth;
}

std::vector<Hem> hems_of(const Mesh& mesh, const std::vector<uint32_t>& index) {
  // The two sides of a seam share positions, not vertices.
  std::map<Vec3, uint32_t, PositionOrder> vertices;
  std::vector<uint32_t> vertex(mesh.position_mm.size());
  for (uint32_t v = 0; v < vertex.size(); ++v) vertex[v] = vertices.try_emplace(mesh.position_mm[v], v).first->second;
  struct Edge {
    uint32_t from, to, beyond;
    int count = 0;
  };
  std::map<std::pair<uint32_t, uint32_t>, Edge> edges;
  for (size_t i = 0; i + 2 < index.size(); i += 3) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = index[i + k], b = index[i + (k + 1) % 3], c = index[i + (k + 2) % 3];
      const auto key = std::minmax(vertex[a], vertex[b]);
      Edge& edge = edges.try_emplace({key.first, key.second}, Edge{a, b, c}).first->second;
      ++edge.count;
    }
  }
  std::vector<Hem> hems;
  for (const auto& [key, edge] : edges) {
    const glm::vec3 a = mesh.position_mm[edge.from], along = mesh.position_mm[edge.to] - a;
    const glm::vec3 in = mesh.position_mm[edge.beyond] - a;
    const float square = glm::dot(along, along);
    if (edge.count != 1 || !(square > 0)) continue;
    const glm::vec3 out = along * (glm::dot(in, along) / square) - in;
    const float length = glm::length(out);
    if (length > 1e-6f) hems.push_back({edge.from, edge.to, out / length});
  }
  return hems;
}

std::vector<Flyaway> scatter_flyaways(const PreparedMesh& prepared, const std::vector<Hem>& hems,
                                      std::array<double, 2> uv_origin_mm, const FlyawayGrowth& growth,
                                      const FlyawayView& view) {
  std::vector<Flyaway> flyaways;
  if (growth.per_mm2[0] + growth.per_mm2[1] <= 0 || prepared.mesh.normal.size() != prepared.mesh.position_mm.size())
    return flyaways;
  FlyawayScatterer count(growth, view, 0, flyaways);
  scatter(count, prepared, hems, uv_origin_mm);
  if (count.expected() <= 0) return flyaways;
  FlyawayScatterer scatterer(growth, view, std::min(1.0f, kMaxFlyaways / count.expected()), flyaways);
  scatter(scatterer, prepared, hems, uv_origin_mm);
  return flyaways;
}

}  // namespace weftlight::render_data
