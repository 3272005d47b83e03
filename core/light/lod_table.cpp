#include "light/lod_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "base/text.h"

namespace weftlight::light {

using base::ErrorKind, base::arg, base::failure, base::fill, base::tr;
using design::kShadedMethods, design::method_from_name;

namespace {

float error_of(const LodPoint& p) { return std::max(p.filtering_error, p.model_error); }
float cost_of(const LodPoint& p) { return p.cost_ns; }

float interpolate(const LodTable& lod_table, Method method, int samples, float yarns, float (*value)(const LodPoint&)) {
  const LodPoint *below = nullptr, *above = nullptr;
  for (const LodPoint& p : lod_table) {
    if (p.method != method || p.samples != samples) continue;
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

constexpr float kMaxSamples = 1e6f;  // far more than any row has

/// Measured values lie far within 1e12; larger sums would overflow a float.
std::optional<float> number(std::string_view text) {
  constexpr float kMax = 1e12f;
  float v = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), v);
  if (error != std::errc() || end != text.data() + text.size() || !(std::abs(v) <= kMax)) return std::nullopt;
  return v;
}

/// Merges scenes and views of one method and footprint: worst errors, mean cost.
struct Merged {
  LodPoint worst;
  int rows = 0;
};
using MergedPoints = std::map<std::tuple<Method, int, float>, Merged>;

void merge(MergedPoints& all, const LodPoint& p) {
  Merged& g = all[{p.method, p.samples, p.yarns_per_pixel}];
  g.worst.method = p.method;
  g.worst.samples = p.samples;
  g.worst.yarns_per_pixel = p.yarns_per_pixel;
  g.worst.cost_ns += p.cost_ns;
  g.worst.filtering_error = std::max(g.worst.filtering_error, p.filtering_error);
  g.worst.model_error = std::max(g.worst.model_error, p.model_error);
  ++g.rows;
}

}  // namespace

/// `all`: method yarn, with the cost of one sample and the error of the most samples. Fewer samples have a larger
/// error.
static void add_lattices(LodTable& lod_table, const LodPoint& all) {
  for (int i = 0; i < formulas::kLattices; ++i) {
    LodPoint p = all;
    p.samples = formulas::lattice_of(i).x;
    const float fraction = static_cast<float>(p.samples) / static_cast<float>(formulas::kMaxYarnSamples);
    p.cost_ns *= static_cast<float>(p.samples);
    p.filtering_error = p.model_error = all.model_error / std::sqrt(fraction);
    lod_table.push_back(p);
  }
}

LodTable default_lod_table() {
  // Each method is good within its band (limits at 1/4, 2 and 8 yarns a pixel); its error doubles each octave outside.
  // Costs grow with the texels and lobes of a pixel.
  struct Band {
    Method method;
    float from, to, cost_ns;
  };
  constexpr Band bands[] = {{Method::kYarn, 1.0f / 64, 0.25f, 40},
                            {Method::kCell, 1.0f / 64, 2, 25},
                            {Method::kRepeat, 2, 8, 15},
                            {Method::kCloth, 8, 64, 10}};
  LodTable lod_table;
  for (const Band& b : bands)
    for (int octave = -6; octave <= 6; ++octave) {
      const float yarns = std::exp2(static_cast<float>(octave));
      const float octaves = std::max({std::log2(b.from / yarns), std::log2(yarns / b.to), 0.0f});
      // There is no finer method than yarn to fall back to; cell is good enough only down to its own band.
      const float below = b.method == Method::kCell ? std::max(std::log2(0.25f / yarns), 0.0f) : 0.0f;
      const float error = 0.04f * std::exp2(octaves + below);
      if (b.method != Method::kYarn) lod_table.push_back({b.method, yarns, b.cost_ns, error, error});
      else add_lattices(lod_table, {b.method, yarns, b.cost_ns, error, error});
    }
  return lod_table;
}

base::Result<LodTable> read_lod_table(std::string_view csv) {
  constexpr std::array<std::string_view, 6> kColumns{
      "method", "samples", "yarns_per_pixel", "ns_per_pixel", "rel_rmse_filtering", "rel_rmse_model"};
  const std::vector<std::string_view> lines = split(csv, '\n');
  const std::vector<std::string_view> head = split(lines.front(), ',');
  std::array<size_t, kColumns.size()> at{};
  for (size_t c = 0; c < at.size(); ++c) {
    at[c] = static_cast<size_t>(std::find(head.begin(), head.end(), kColumns[c]) - head.begin());
    if (at[c] == head.size())
      return failure(ErrorKind::kInput,
                     fill(tr("line {line}: column {column} is missing"), arg("line", 1), arg("column", kColumns[c])));
  }
  MergedPoints all;
  for (size_t l = 1; l < lines.size(); ++l) {
    if (lines[l].empty()) continue;
    const std::vector<std::string_view> cells = split(lines[l], ',');
    std::array<std::optional<float>, kColumns.size() - 1> v;
    const bool whole = cells.size() >= head.size();
    for (size_t c = 0; whole && c < v.size(); ++c) v[c] = number(cells[at[c + 1]]);
    const bool numbers = std::all_of(v.begin(), v.end(), [](const auto& n) { return n.has_value(); });
    if (!numbers || *v[0] < 1 || *v[0] > kMaxSamples || *v[1] <= 0)
      return failure(ErrorKind::kInput, fill(tr("line {line}: not a row of numbers"), arg("line", l + 1)));
    if (const std::optional<Method> m = method_from_name(cells[at[0]]))
      merge(all, {*m, *v[1], *v[2], *v[3], *v[4], static_cast<int>(*v[0])});
  }
  LodTable lod_table;
  for (auto& [key, g] : all) {
    g.worst.cost_ns /= static_cast<float>(g.rows);
    lod_table.push_back(g.worst);
  }
  return lod_table;
}

float expected_error(const LodTable& lod_table, Method method, float yarns_per_pixel, int samples) {
  return interpolate(lod_table, method, samples, std::max(yarns_per_pixel, 1e-6f), error_of);
}

float expected_cost(const LodTable& lod_table, Method method, float yarns_per_pixel, int samples) {
  return interpolate(lod_table, method, samples, std::max(yarns_per_pixel, 1e-6f), cost_of);
}

namespace {

constexpr float kAsGood = 1.1f;  // errors within this ratio count as equal
// A quarter more error is accepted at a tenth of the cost: at two yarns a pixel, tracing threads would cost eighty
// times `repeat` to bring 0.17 to 0.14, with more flicker.
constexpr float kNearlyHeld = 1.25f, kMuchCheaper = 0.1f;

/// The candidates: method yarn with each lattice, and the others.
std::vector<Choice> offered(const LodDemand& demand) {
  std::vector<Choice> all;
  for (int i = 0; i < formulas::kLattices; ++i) {
    const int points = formulas::lattice_of(i).x;
    if (i == 0 || points <= demand.samples) all.push_back({Method::kYarn, points});
  }
  for (const Method m : {Method::kCell, Method::kRepeat, Method::kCloth}) all.push_back({m, 1});
  return all;
}

Choice cheapest(const LodTable& lod_table, float yarns, float tolerance, const std::vector<Choice>& among) {
  float least = std::numeric_limits<float>::infinity();
  for (const Choice& c : among) least = std::min(least, expected_error(lod_table, c.method, yarns, c.samples));
  const float held = std::max(tolerance, least * kAsGood);
  Choice best;
  float best_cost = std::numeric_limits<float>::infinity();
  const auto try_within = [&](float error, float cost) {
    for (const Choice& c : among) {
      const float one = expected_cost(lod_table, c.method, yarns, c.samples);
      if (expected_error(lod_table, c.method, yarns, c.samples) <= error && one < cost && one < best_cost)
        best_cost = one, best = c;
    }
  };
  try_within(held, best_cost);
  try_within(held * kNearlyHeld, best_cost * kMuchCheaper);
  return best;
}

constexpr int kMaxStep = 24;  // from 1/64 to 64 yarns a pixel
constexpr float kOctaveStep = 0.25f;

float yarns_at(int step) { return std::exp2(kOctaveStep * static_cast<float>(step)); }

std::array<float, 3> edges_among(const LodTable& lod_table, float tolerance, const std::vector<Choice>& among) {
  std::array<float, 3> edges{1e6f, 1e6f, 1e6f};
  int rank = 3;  // finest method that a coarser footprint needs
  for (int step = kMaxStep; step >= -kMaxStep; --step) {
    const float yarns = yarns_at(step);
    const Method m = cheapest(lod_table, yarns, tolerance, among).method;
    rank = std::min(rank, static_cast<int>(std::find(std::begin(kShadedMethods), std::end(kShadedMethods), m) -
                                           std::begin(kShadedMethods)));
    for (int k = 0; k < rank; ++k) edges[static_cast<size_t>(k)] = yarns;
  }
  return edges;
}

/// Near the threads `cell` may be less accurate than `repeat`. It is left out if a coarser footprint would keep it
/// where it is worse than `repeat` and out of tolerance.
std::array<float, 3> method_edges(const LodTable& lod_table, float tolerance, std::vector<Choice> among) {
  const std::array<float, 3> edges = edges_among(lod_table, tolerance, among);
  for (int step = -kMaxStep; step <= kMaxStep; ++step) {
    const float yarns = yarns_at(step);
    if (yarns < edges[0] || yarns >= edges[1]) continue;
    const float cell = expected_error(lod_table, Method::kCell, yarns);
    if (cell <= tolerance || cell <= kAsGood * expected_error(lod_table, Method::kRepeat, yarns)) continue;
    std::erase_if(among, [](const Choice& c) { return c.method == Method::kCell; });
    return edges_among(lod_table, tolerance, among);
  }
  return edges;
}

std::array<float, 8> lattice_edges(const LodTable& lod_table, float tolerance, std::vector<Choice> lattices) {
  static_assert(formulas::kLattices == 8);
  std::erase_if(lattices, [](const Choice& c) { return c.method != Method::kYarn; });
  std::array<float, 8> edges;
  edges.fill(1e6f);
  size_t enough = 0;
  for (int step = -kMaxStep; step <= kMaxStep; ++step) {
    const float yarns = yarns_at(step);
    const int points = cheapest(lod_table, yarns, tolerance, lattices).samples;
    // From half a step before, since the error grows between the two.
    while (enough + 1 < lattices.size() && lattices[enough].samples < points)
      edges[enough++] = yarns * std::exp2(-0.5f * kOctaveStep);
  }
  return edges;
}

int lattice_at(const Plan& plan, float yarns) {
  const std::array<float, 8>& l = plan.lattices;
  return formulas::lattice_for(yarns, {l[0], l[1], l[2], l[3]}, {l[4], l[5], l[6], l[7]}, plan.samples);
}

}  // namespace

Choice choose(const LodTable& lod_table, float yarns_per_pixel, const LodDemand& demand) {
  return cheapest(lod_table, yarns_per_pixel, demand.tolerance, offered(demand));
}

Plan plan_of(const LodTable& lod_table, const LodDemand& demand) {
  const std::vector<Choice> among = offered(demand);
  return {method_edges(lod_table, demand.tolerance, among), lattice_edges(lod_table, demand.tolerance, among),
          demand.samples};
}

int samples_at(const Plan& plan, float yarns_per_pixel) {
  return formulas::lattice_of(lattice_at(plan, yarns_per_pixel)).x;
}

Expected expected(const LodTable& lod_table, const Plan& plan, float yarns_per_pixel) {
  const glm::vec4 weight = formulas::lod_weights(yarns_per_pixel, {plan.methods[0], plan.methods[1], plan.methods[2]});
  Expected sum;
  for (size_t k = 0; k < std::size(kShadedMethods); ++k) {
    const float w = weight[static_cast<int>(k)];
    if (w <= 0) continue;
    const int samples = kShadedMethods[k] == Method::kYarn ? samples_at(plan, yarns_per_pixel) : 1;
    const float error = expected_error(lod_table, kShadedMethods[k], yarns_per_pixel, samples);
    const float cost = expected_cost(lod_table, kShadedMethods[k], yarns_per_pixel, samples);
    if (std::isfinite(error)) sum.error += w * error;
    if (std::isfinite(cost)) sum.cost_ns += cost;
  }
  return sum;
}

}  // namespace weftlight::light
