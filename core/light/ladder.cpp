#include "light/ladder.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

namespace weftlight::light {
namespace {

float error_of(const LadderPoint& p) { return std::max(p.filtering_error, p.model_error); }
float cost_of(const LadderPoint& p) { return p.cost_ns; }

float interpolate(const Ladder& ladder, Method method, float yarns, float (*value)(const LadderPoint&)) {
  const LadderPoint *below = nullptr, *above = nullptr;
  for (const LadderPoint& p : ladder) {
    if (p.method != method) continue;
    if (p.yarns_per_pixel <= yarns && (!below || p.yarns_per_pixel > below->yarns_per_pixel)) below = &p;
    if (p.yarns_per_pixel >= yarns && (!above || p.yarns_per_pixel < above->yarns_per_pixel)) above = &p;
  }
  if (!below && !above) return std::numeric_limits<float>::infinity();
  if (!below || !above) return value(below ? *below : *above);
  const float from = std::log2(below->yarns_per_pixel), span = std::log2(above->yarns_per_pixel) - from;
  const float t = span > 0 ? (std::log2(yarns) - from) / span : 0.0f;
  return value(*below) + (value(*above) - value(*below)) * t;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const size_t at = text.find(separator);
    std::string_view part = text.substr(0, at);
    if (!part.empty() && part.back() == '\r') part.remove_suffix(1);
    parts.push_back(part);
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

/// What was measured lies far within 1e12; beyond, sums would leave a float's range.
std::optional<float> number(std::string_view text) {
  constexpr float kMost = 1e12f;
  float v = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), v);
  if (error != std::errc() || end != text.data() + text.size() || !(std::abs(v) <= kMost)) return std::nullopt;
  return v;
}

/// Several scenes and views of one method and footprint become one point: worst errors, mean cost.
struct Gathered {
  LadderPoint worst;
  int rows = 0;
};
using Gathering = std::map<std::pair<Method, float>, Gathered>;

void gather(Gathering& all, const LadderPoint& p) {
  Gathered& g = all[{p.method, p.yarns_per_pixel}];
  g.worst.method = p.method;
  g.worst.yarns_per_pixel = p.yarns_per_pixel;
  g.worst.cost_ns += p.cost_ns;
  g.worst.filtering_error = std::max(g.worst.filtering_error, p.filtering_error);
  g.worst.model_error = std::max(g.worst.model_error, p.model_error);
  ++g.rows;
}

}  // namespace

Ladder default_ladder() {
  // Each rung holds its band (1/4, 2, 8 yarns a pixel are the borders) and doubles its error an octave
  // outside; costs grow with the texels and lobes a pixel takes.
  struct Band {
    Method method;
    float from, to, cost_ns;
  };
  constexpr Band bands[] = {{Method::kYarn, 1.0f / 64, 0.25f, 40},
                            {Method::kCell, 1.0f / 64, 2, 25},
                            {Method::kRepeat, 2, 8, 15},
                            {Method::kCloth, 8, 64, 10}};
  Ladder ladder;
  for (const Band& b : bands)
    for (float yarns = 1.0f / 64; yarns <= 64; yarns *= 2) {
      const float octaves = std::max({std::log2(b.from / yarns), std::log2(yarns / b.to), 0.0f});
      // The finest rung has no finer one to fall back to; cell is good enough only down to its own band.
      const float below = b.method == Method::kCell ? std::max(std::log2(0.25f / yarns), 0.0f) : 0.0f;
      const float error = 0.04f * std::exp2(octaves + below);
      ladder.push_back({b.method, yarns, b.cost_ns, error, error});
    }
  return ladder;
}

Ladder read_ladder(std::string_view csv, std::string& problem) {
  constexpr std::string_view kColumns[] = {"method", "yarns_per_pixel", "ns_per_pixel", "rel_rmse_filtering",
                                           "rel_rmse_model"};
  const std::vector<std::string_view> lines = split(csv, '\n');
  const std::vector<std::string_view> head = split(lines.front(), ',');
  size_t at[5] = {};
  for (size_t c = 0; c < 5; ++c) {
    at[c] = static_cast<size_t>(std::find(head.begin(), head.end(), kColumns[c]) - head.begin());
    if (at[c] == head.size()) {
      problem = "line 1: column " + std::string(kColumns[c]) + " is missing";
      return {};
    }
  }
  Gathering all;
  for (size_t l = 1; l < lines.size(); ++l) {
    if (lines[l].empty()) continue;
    const std::vector<std::string_view> cells = split(lines[l], ',');
    std::optional<float> v[4];
    const bool whole = cells.size() >= head.size();
    for (size_t c = 0; whole && c < 4; ++c) v[c] = number(cells[at[c + 1]]);
    if (!v[0] || *v[0] <= 0 || !v[1] || !v[2] || !v[3]) {
      problem = "line " + std::to_string(l + 1) + ": not a row of numbers";
      return {};
    }
    if (const std::optional<Method> m = method_from_name(cells[at[0]])) gather(all, {*m, *v[0], *v[1], *v[2], *v[3]});
  }
  Ladder ladder;
  for (auto& [key, g] : all) {
    g.worst.cost_ns /= static_cast<float>(g.rows);
    ladder.push_back(g.worst);
  }
  return ladder;
}

float expected_error(const Ladder& ladder, Method method, float yarns_per_pixel) {
  return interpolate(ladder, method, std::max(yarns_per_pixel, 1e-6f), error_of);
}

float expected_cost(const Ladder& ladder, Method method, float yarns_per_pixel) {
  return interpolate(ladder, method, std::max(yarns_per_pixel, 1e-6f), cost_of);
}

Method choose_rung(const Ladder& ladder, float yarns_per_pixel, float tolerance) {
  constexpr float kAsGood = 1.1f;  // errors nearer to each other than this are told apart by no eye
  float least = std::numeric_limits<float>::infinity();
  for (const Method m : kRungs) least = std::min(least, expected_error(ladder, m, yarns_per_pixel));
  const float held = std::max(tolerance, least * kAsGood);
  Method best = Method::kYarn;
  float best_cost = std::numeric_limits<float>::infinity();
  for (const Method m : kRungs) {
    const float cost = expected_cost(ladder, m, yarns_per_pixel);
    if (expected_error(ladder, m, yarns_per_pixel) <= held && cost < best_cost) best_cost = cost, best = m;
  }
  return best;
}

std::array<float, 3> rung_edges(const Ladder& ladder, float tolerance) {
  std::array<float, 3> edges{1e6f, 1e6f, 1e6f};
  int rank = 3;  // the finest rung any coarser footprint needs
  for (float octave = 6.0f; octave >= -6.0f; octave -= 0.25f) {
    const float yarns = std::exp2(octave);
    const Method m = choose_rung(ladder, yarns, tolerance);
    rank = std::min(rank, static_cast<int>(std::find(std::begin(kRungs), std::end(kRungs), m) - std::begin(kRungs)));
    for (int k = 0; k < rank; ++k) edges[static_cast<size_t>(k)] = yarns;
  }
  return edges;
}

}  // namespace weftlight::light
