// Normalisations and shadowing of the seed paper's BRDF.
// Based on: Ashikhmin, Premoze, Shirley 2000, "A microfacet-based BRDF generator", eq. 2.
// A cylindrical Gaussian is constant along great circles through its axis: with
// h = (cos b sin a, sin b, cos b cos a) it depends on a alone, and every integral over b is closed.

#include "light/cloth_brdf.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "cloth/layers.h"

namespace weftlight::light {

using cloth::ThreadBody, cloth::front_layer, cloth::one_layer;
using draft::BitMatrix, draft::differences;

namespace {

constexpr int kCosines = 32, kAzimuths = 24;  // entries of the table of g
constexpr int kNodes = 96;

struct Node {
  float sine, cosine, weight;  // of a; weight holds exp(-tan^2 a / sigma^2) da
};
using Nodes = std::array<Node, kNodes>;

/// Nodes over a in -90..90 degrees: uniform in tan a / sigma for narrow Gaussians, uniform in a for wide ones.
Nodes nodes_of(float sigma) {
  Nodes nodes;
  for (int i = 0; i < kNodes; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / kNodes * 2 - 1;
    float a = 0, weight = 0;
    if (sigma < 0.5f) {
      const float t = 4.5f * u, tangent = sigma * t;
      a = std::atan(tangent);
      weight = std::exp(-t * t) * sigma / (1 + tangent * tangent) * (9.0f / kNodes);
    } else {
      a = u * (formulas::kPi / 2);
      const float t = std::tan(a) / sigma;
      weight = std::exp(-std::min(t * t, 80.0f)) * (formulas::kPi / kNodes);
    }
    nodes[static_cast<size_t>(i)] = {std::sin(a), std::cos(a), weight};
  }
  return nodes;
}

/// Integral of (h.w)+ over one thread's Gaussian; `along` and `across` are the components of w along and across the
/// thread. Over b: the positive half of R cos(b - c) cos b, (|across| + (pi - |c|) R cos c) / 2.
float thread_area(const Nodes& nodes, float c, float along, float across, float z) {
  float sum = 0;
  const float side = std::abs(across);
  for (const Node& n : nodes) {
    const float front = along * n.sine + z * n.cosine;
    sum += n.weight * (side + (formulas::kPi - std::atan2(side, front)) * front);
  }
  return 0.5f * c * sum;
}

struct Both {
  Nodes warp, weft;
};

float area_of(const formulas::Vrst03& p, const Both& nodes, const glm::vec3& w) {
  return p.f_warp * thread_area(nodes.warp, p.c_warp, w.y, w.x, w.z) +
         p.f_weft * thread_area(nodes.weft, p.c_weft, w.x, w.y, w.z);
}

Table table_of_g(const formulas::Vrst03& p, const Both& nodes) {
  Table g(kCosines, kAzimuths, 1, 1);
  for (int y = 0; y < kAzimuths; ++y)
    for (int x = 0; x < kCosines; ++x) {
      const float v = static_cast<float>(y) / (kAzimuths - 1), z = static_cast<float>(x) / (kCosines - 1);
      const float r = std::sqrt(std::max(1 - z * z, 0.0f)) / std::sqrt(v * v + (1 - v) * (1 - v));
      g.at(x, y)[0] = area_of(p, nodes, {r * (1 - v), r * v, z});
    }
  return g;
}

struct Runs {
  int64_t cells = 0, runs = 0;
  float mean(float whole) const { return runs > 0 ? static_cast<float>(cells) / static_cast<float>(runs) : whole; }
};

/// Bit c of the result: whether cell c and its right neighbour (cyclic) differ.
int64_t changes_along(const BitMatrix& m, int row) {
  const auto words = m.row(row);
  const int last = m.cols() - 1;
  int64_t changes = m.get(row, 0) != m.get(row, last);
  for (int w = 0; w < m.words(); ++w) {
    const uint64_t here = words[static_cast<size_t>(w)];
    const uint64_t next = w + 1 < m.words() ? words[static_cast<size_t>(w) + 1] : 0;
    const int cols = std::min(64, last - 64 * w);  // pairs that begin in this word
    const uint64_t mask = cols >= 64 ? ~uint64_t{0} : (uint64_t{1} << std::max(cols, 0)) - 1;
    changes += std::popcount((here ^ (here >> 1 | next << 63)) & mask);
  }
  return changes;
}

struct Mean {
  float spacing = 0, height = 0;
  glm::vec3 colour{0};
};
Mean mean_of(const std::vector<ThreadBody>& threads) {
  Mean m;
  for (const ThreadBody& t : threads) {
    m.spacing += t.spacing_mm;
    m.height += t.height_mm;
    m.colour += glm::vec3(t.colour.r, t.colour.g, t.colour.b);
  }
  const float n = static_cast<float>(std::max<size_t>(threads.size(), 1));
  return {m.spacing / n, m.height / n, m.colour / n};
}

/// sigma of exp(-slope^2 / sigma^2) for a wave that rises by half of both threads' heights within half a float: its
/// amplitude pi / length is sqrt 2 of the RMS slope.
float sigma_of(float rise_mm, float float_mm) {
  return std::clamp(formulas::kPi * rise_mm / std::max(float_mm, 1e-3f), 0.1f, 1.5f);
}

}  // namespace

ClothBrdf make_cloth_brdf(float f_warp, float f_weft, float sigma_warp, float sigma_weft, Linear warp, Linear weft) {
  const float total = f_warp + f_weft;
  formulas::Vrst03 p;
  p.f_warp = total > 0 ? f_warp / total : 0.5f;
  p.f_weft = 1 - p.f_warp;
  p.sigma_warp = std::clamp(sigma_warp, 0.01f, 4.0f);
  p.sigma_weft = std::clamp(sigma_weft, 0.01f, 4.0f);
  p.warp_colour = {warp.r, warp.g, warp.b};
  p.weft_colour = {weft.r, weft.g, weft.b};
  const Both nodes{nodes_of(p.sigma_warp), nodes_of(p.sigma_weft)};
  const auto normalise = [](const Nodes& n, float& c) {
    float area = 0, height = 0;
    for (const Node& a : n) area += a.weight, height += a.weight * a.cosine;
    c = 0.5f / area;                          // integral of cos b over b is 2
    return c * height * (formulas::kPi / 2);  // integral of cos^2 b is pi / 2
  };
  const float warp_hn = normalise(nodes.warp, p.c_warp), weft_hn = normalise(nodes.weft, p.c_weft);
  p.mean_hn = p.f_warp * warp_hn + p.f_weft * weft_hn;
  return {p, table_of_g(p, nodes)};
}

ClothBrdf cloth_brdf(const Cloth& whole) {
  const Cloth cloth = one_layer(whole, front_layer(whole));
  const BitMatrix& up = cloth.up;
  const int picks = up.rows(), ends = up.cols();
  const Mean warp = mean_of(cloth.ends), weft = mean_of(cloth.picks);
  const auto colour = [](const glm::vec3& c) { return Linear{c.x, c.y, c.z}; };
  if (picks == 0 || ends == 0) return make_cloth_brdf(1, 1, 1, 1, colour(warp.colour), colour(weft.colour));
  Runs over_picks, over_ends;  // floats of the warp run over picks, those of the weft over ends
  over_picks.cells = up.count();
  over_ends.cells = int64_t{picks} * ends - over_picks.cells;
  for (int r = 0; r < picks; ++r) {
    over_picks.runs += differences(up.row(r), up.row((r + 1) % picks));
    over_ends.runs += changes_along(up, r);
  }
  over_picks.runs /= 2;  // a run begins and ends
  over_ends.runs /= 2;
  const float rise = 0.25f * (warp.height + weft.height);
  const float warp_float = over_picks.mean(static_cast<float>(picks)) * weft.spacing;
  const float weft_float = over_ends.mean(static_cast<float>(ends)) * warp.spacing;
  return make_cloth_brdf(static_cast<float>(over_picks.cells), static_cast<float>(over_ends.cells),
                         sigma_of(rise, warp_float), sigma_of(rise, weft_float), colour(warp.colour),
                         colour(weft.colour));
}

float shadowing(const ClothBrdf& brdf, const glm::vec3& w) {
  const glm::vec2 at = formulas::vrst03_g_coord(w);
  const float x = at.x * (kCosines - 1), y = at.y * (kAzimuths - 1);
  const int i = std::min(static_cast<int>(x), kCosines - 2), j = std::min(static_cast<int>(y), kAzimuths - 2);
  const float s = x - static_cast<float>(i), t = y - static_cast<float>(j);
  const float* low = brdf.g.at(i, j);
  const float* high = brdf.g.at(i, j + 1);
  return (low[0] * (1 - s) + low[1] * s) * (1 - t) + (high[0] * (1 - s) + high[1] * s) * t;
}

glm::vec3 evaluate(const ClothBrdf& brdf, const glm::vec3& wi, const glm::vec3& wo) {
  if (wi.z <= 0 || wo.z <= 0) return glm::vec3(0);
  return formulas::vrst03_brdf(brdf.p, shadowing(brdf, wi), shadowing(brdf, wo), wi, wo);
}

}  // namespace weftlight::light
