// Bounded linear least squares over pairs of views and lights, relative to the reflected light and the mean of the
// view, and over those means in and around the planes of the threads. The widths of the lobe and the sheen's roughness
// are found by descent. Coupling between the parts (Fresnel, and what the sheen leaves) is taken from the previous
// round.

#include "light/engine_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "light/engine_directions.h"
#include "light/engine_pixels.h"

namespace weftlight::light {

namespace {

constexpr int kRounds = 3;  // rounds of least squares, for the coupling between the parts
constexpr int kTintRounds = 8;
constexpr size_t kSearchedTexels = 64;                           // for the descent
constexpr float kMinBase = 0.25f, kMaxBase = 8, kMaxSheen = 40;  // factors of the colours
constexpr float kFirstStep = 0.7f, kLastStep = 0.06f;            // of the descent, in logarithms
constexpr float kNarrowestLobe = 0.02f, kWidestLobe = 4.0f;      // factors of the variances, at footprint weight 1
// Starts of the descent: factors along the fibres and across, and along the weft. There are several minima.
constexpr std::array<float, 2> kStarts[] = {{0.15f, 1}, {1, 1}};
// Half vectors of the fit are 5 degrees (0.087) apart. Without this limit organza had a highlight of 0.034 and 0.004 of
// reflectance, which no light of the fit met.
constexpr float kLeastAlpha = 0.08f;
constexpr float kFlattest = 0.3f;  // factor of the slopes of normals
constexpr float kSmoothestSheen = 0.2f, kRoughestSheen = 1.0f;
// Weight of the pair itself in the scale of an error; the rest is the mean of the view.
constexpr float kHighlightWeight = 0.2f;
// Of the mean over all azimuths at an elevation. A round highlight is too bright in one plane of a satin and too dim in
// the other: only that mean can be right.
constexpr float kRoundWeight = 30;
constexpr float kDarkChannel = 0.15f;  // of the brightest: below, errors are relative to this
constexpr float kHue = 0.005f;         // pull of colour factors to their mean: a dark channel is poorly determined
// Pull of the sheen's factors to those of a neighbour: shot taffeta in Unreal is nearly as well off with a red sheen at
// 0 as at its bound.
constexpr float kSheenHold = 0.02f;
constexpr float kNeighbourLoss = 1.02f;  // error that a neighbour's widths may have over that of the best
constexpr float kMostShone = 0.9f;       // reflectance at normal view times its factor for a flat view
constexpr glm::vec3 kLuminance{0.2126f, 0.7152f, 0.0722f};
constexpr std::array<float, 3> kChannelWeight{0.3f, 0.5f, 0.2f};

// Unknowns: factors of base colour, reflectances at normal view, at grazing view, factors of sheen. Where a model has
// one number for the channels, it is the first of three.
constexpr size_t kBase = 0, kF0 = 3, kF90 = 6, kSheen = 7, kUnknowns = 10;
using Unknowns = std::array<float, kUnknowns>;

glm::vec3 whole(const PairRadiance& radiance, const EngineFit& fit) {
  return radiance.body * fit.base + radiance.gloss * fit.f0 + radiance.grazing * fit.f90 + radiance.fuzz * fit.sheen;
}

/// Which unknown a channel has.
struct Layout {
  bool tinted = false, hued = false;  // reflectance and sheen by channel
  size_t f0(size_t channel) const { return kF0 + (tinted ? channel : 0); }
  size_t sheen(size_t channel) const { return kSheen + (hued ? channel : 0); }
};

bool has_sheen(const EngineModel& model) {
  return model.sheen == formulas::kSheenCharlie || model.sheen == formulas::kSheenZeltner ||
         model.sheen == formulas::kSheenInverseGgx || model.sheen == formulas::kSheenDisney;
}

Layout layout_of(const EngineModel& model) {
  return {model.tinted, has_sheen(model) && model.sheen != formulas::kSheenDisney};
}

/// Of the unknowns: base colour and sheen up to white, and what the model can do.
struct UnknownBounds {
  Unknowns least{}, most{};
};
UnknownBounds bounds_of(const EngineTexels& texels, const EngineModel& model) {
  glm::vec3 most_sheen(1e-3f);
  for (const EngineTexel& t : texels.texels) most_sheen = glm::max(most_sheen, t.material.sheen);
  const bool hued = layout_of(model).hued;
  if (!hued) most_sheen = glm::vec3(std::max({most_sheen.r, most_sheen.g, most_sheen.b}));
  const bool fixed = model.most_f0 <= formulas::kEngineF0;
  UnknownBounds out;
  for (size_t c = 0; c < 3; ++c) {
    out.least[kBase + c] = kMinBase, out.most[kBase + c] = kMaxBase;
    out.least[kF0 + c] = fixed ? formulas::kEngineF0 : 0, out.most[kF0 + c] = model.most_f0;
    out.most[kSheen + c] = has_sheen(model) ? std::min(kMaxSheen, 1 / most_sheen[static_cast<int>(c)]) : 0;
  }
  out.least[kF90] = model.grazing ? 0.0f : 1.0f, out.most[kF90] = 1;
  return out;
}

/// Least squares by coordinates within bounds.
struct Normal {
  std::array<std::array<double, kUnknowns>, kUnknowns> a{};
  std::array<double, kUnknowns> b{};
  double wanted2 = 0, held2 = 0;
  void add(const Unknowns& row, float wanted, float weight) {
    for (size_t i = 0; i < kUnknowns; ++i) {
      if (row[i] == 0) continue;
      const double by = static_cast<double>(weight * row[i]);
      for (size_t j = 0; j < kUnknowns; ++j) a[i][j] += by * static_cast<double>(row[j]);
      b[i] += by * static_cast<double>(wanted);
    }
    wanted2 += static_cast<double>(weight * wanted * wanted);
  }
  /// Pulls three unknowns to their mean.
  void pull(size_t first) {
    const double by =
        static_cast<double>(kHue) * std::max({a[first][first], a[first + 1][first + 1], a[first + 2][first + 2]});
    for (size_t i = first; i < first + 3; ++i)
      for (size_t j = first; j < first + 3; ++j) a[i][j] += by * (i == j ? 2.0 / 3 : -1.0 / 3);
  }
  /// Pulls an unknown to a value.
  void hold(size_t i, float to, float strength) {
    const double by = static_cast<double>(strength) * a[i][i];
    a[i][i] += by, b[i] += by * static_cast<double>(to);
    held2 += by * static_cast<double>(to * to);
  }
  void solve(Unknowns& x, const UnknownBounds& bounds) const {
    for (int round = 0; round < 200; ++round) {
      double moved = 0;
      for (size_t i = 0; i < kUnknowns; ++i) {
        if (a[i][i] <= 1e-12) continue;
        double rest = b[i];
        for (size_t j = 0; j < kUnknowns; ++j) rest -= j == i ? 0.0 : a[i][j] * static_cast<double>(x[j]);
        const float before = x[i];
        x[i] = std::clamp(static_cast<float>(rest / a[i][i]), bounds.least[i], bounds.most[i]);
        // Fresnel reflectance does not fall towards grazing.
        if (i == kF90) x[i] = std::max(x[i], std::min(std::max({x[kF0], x[kF0 + 1], x[kF0 + 2]}), bounds.most[i]));
        moved = std::max(moved, static_cast<double>(std::abs(x[i] - before)));
      }
      if (moved < 1e-5) break;
    }
  }
  float error(const Unknowns& x) const {
    double sum = wanted2 + held2;
    for (size_t i = 0; i < kUnknowns; ++i) {
      sum -= 2 * b[i] * static_cast<double>(x[i]);
      for (size_t j = 0; j < kUnknowns; ++j) sum += a[i][j] * static_cast<double>(x[i]) * static_cast<double>(x[j]);
    }
    return static_cast<float>(std::sqrt(std::max(sum, 0.0) / std::max(wanted2, 1e-30)));
  }
};

Unknowns row_of(const PairRadiance& radiance, size_t channel, const Layout& layout) {
  const int c = static_cast<int>(channel);
  Unknowns row{};
  row[kBase + channel] = radiance.body[c];
  row[layout.f0(channel)] = radiance.gloss[c];
  row[kF90] = radiance.grazing[c];
  row[layout.sheen(channel)] = radiance.fuzz[c];
  return row;
}

/// The equations of one view: its pairs, and their mean, which errors that cancel over lights do not change.
void add_view(Normal& to, const EngineDirections& directions, const EngineView& view,
              std::span<const PairRadiance> radiance, const Layout& layout) {
  const std::span<const EnginePair> pairs = std::span(directions.pairs).subspan(view.first, view.count);
  glm::vec3 mean(0);
  for (const EnginePair& p : pairs) mean += p.fraction * p.wanted;
  const float brightest = std::max({mean.r, mean.g, mean.b, 1e-4f});
  for (size_t c = 0; c < 3; ++c) {
    const int channel = static_cast<int>(c);
    const float size = std::max(mean[channel], kDarkChannel * brightest);
    Unknowns sum{};
    for (size_t i = 0; i < pairs.size(); ++i) {
      const Unknowns row = row_of(radiance[view.first + i], c, layout);
      for (size_t k = 0; k < kUnknowns; ++k) sum[k] += pairs[i].fraction * row[k];
      const float wanted = pairs[i].wanted[channel];
      const float scale = (1 - kHighlightWeight) * size + kHighlightWeight * wanted;
      to.add(row, wanted, kChannelWeight[c] * view.shape * pairs[i].fraction / (scale * scale));
    }
    to.add(sum, mean[channel], kChannelWeight[c] * view.weight / (size * size));
  }
}

Normal normal_of(const EngineDirections& directions, const std::vector<PairRadiance>& radiance, const Layout& layout) {
  Normal out;
  for (const EngineView& view : directions.means) add_view(out, directions, view, radiance, layout);
  out.pull(kBase);
  if (layout.tinted) out.pull(kF0);
  if (layout.hued) out.pull(kSheen);
  return out;
}

/// All that one fit needs.
struct Problem {
  const EngineTexels& texels;
  const EngineDirections& directions;
  const EngineModel& model;
  Layout layout;
  UnknownBounds bounds;
  const EngineFit* near = nullptr;  // a neighbour's fit that this one keeps to where it can
};

/// What the tint can do for one view.
TintedMean tinted_mean(const EngineFit& fit, const Problem& p, const EngineView& view,
                       const std::vector<PairRadiance>& radiance) {
  TintedMean out;
  const glm::vec4 slant = ViewTint::slant(p.directions.views[view.view]);
  for (size_t i = view.first; i < view.first + view.count; ++i) {
    const EnginePair& pair = p.directions.pairs[i];
    const PairRadiance& r = radiance[i];
    const glm::vec3 body = pair.fraction * r.body * fit.base;
    const glm::vec3 gloss = pair.fraction * (r.gloss * fit.f0 + (p.model.grazing ? r.grazing * fit.f90 : glm::vec3(0)));
    out.wanted += pair.fraction * pair.wanted, out.whole += pair.fraction * whole(r, fit), out.body += body;
    const glm::vec4 by = p.model.light_tinted ? slant + ViewTint::slant(p.directions.lights[pair.light]) : slant;
    for (int k = 0; k < 4; ++k) out.body_by[static_cast<size_t>(k)] += body * by[k];
    for (int k = 0; k < 2; ++k) out.gloss_by[static_cast<size_t>(k)] += gloss * by[k + 2];
  }
  const float brightest = std::max({out.wanted.r, out.wanted.g, out.wanted.b, 1e-4f});
  const glm::vec3 size = glm::max(out.wanted, glm::vec3(kDarkChannel * brightest));
  out.weight = view.weight * glm::vec3(kChannelWeight[0], kChannelWeight[1], kChannelWeight[2]) / (size * size);
  return out;
}

/// Moves base colour, tint and the highlight's growth with the view to what the means of views lack.
void tint(EngineFit& fit, const Problem& p, const std::vector<PairRadiance>& radiance) {
  std::vector<TintedMean> means;
  for (const EngineView& view : p.directions.means) means.push_back(tinted_mean(fit, p, view, radiance));
  const float most_f0 = std::max({fit.f0.r, fit.f0.g, fit.f0.b, formulas::kEngineF0});
  move_tint(fit.base, fit.tint, std::log(kMostShone / most_f0), means);
  fit.base = glm::clamp(fit.base, kMinBase, kMaxBase);
}

/// Best factors for the given lobe widths, sheen roughness and tint; with `tinting` the tint is moved as well.
void solve(EngineFit& fit, const Problem& p, int rounds, bool tinting = false) {
  for (int round = 0; round < rounds; ++round) {
    const std::vector<PairRadiance> radiance = texel_radiance(p.texels, p.directions, p.model, fit);
    Normal normal = normal_of(p.directions, radiance, p.layout);
    for (size_t c = 0; p.near != nullptr && c < (p.layout.hued ? 3u : 1u); ++c)
      normal.hold(kSheen + c, p.near->sheen[static_cast<int>(c)], kSheenHold);
    Unknowns x{fit.base.r, fit.base.g, fit.base.b,  fit.f0.r,    fit.f0.g,
               fit.f0.b,   fit.f90,    fit.sheen.r, fit.sheen.g, fit.sheen.b};
    normal.solve(x, p.bounds);
    fit.error = normal.error(x);
    const auto three = [&x](size_t first, bool each) {
      return each ? glm::vec3(x[first], x[first + 1], x[first + 2]) : glm::vec3(x[first]);
    };
    fit.base = three(kBase, true), fit.f0 = three(kF0, p.layout.tinted), fit.sheen = three(kSheen, p.layout.hued);
    fit.f90 = x[kF90];
    if (tinting) tint(fit, p, radiance);
  }
}

/// How far the widths of the highlight may change, 0..1: of close views they are the yarns' own.
float freedom(const Problem& p) { return p.model.each_texel ? 1 : p.texels.footprint_weight; }

/// Searched parameters, each with its bounds.
struct Searched {
  float* value;
  float least, most;
};
std::vector<Searched> searched(EngineFit& fit, const Problem& p) {
  const float narrowest = std::pow(kNarrowestLobe, freedom(p)), widest = std::pow(kWidestLobe, freedom(p));
  std::vector<Searched> out{{&fit.lobe.fibre.x, narrowest, widest}, {&fit.lobe.fibre.y, narrowest, widest}};
  if (p.model.anisotropic) out.push_back({&fit.lobe.weft, narrowest, 1 / narrowest});
  // Only these models have a sheen roughness of their own.
  if (p.model.sheen == formulas::kSheenCharlie || p.model.sheen == formulas::kSheenZeltner)
    out.push_back({&fit.sheen_roughness, kSmoothestSheen, kRoughestSheen});
  if (p.model.each_texel) out.push_back({&fit.relief.x, kFlattest, 1}), out.push_back({&fit.relief.y, kFlattest, 1});
  return out;
}

float narrowest_alpha(const EngineFit& fit, const Problem& p) {
  float out = 1;
  for (const EngineTexel& t : p.texels.texels)
    out = std::min(out, engine_lobe(t, fit.lobe, p.texels.footprint_weight).alpha().y);
  return out;
}

/// Whether highlights of pixels become so narrow that the directions of the fit miss them.
bool falls_between_directions(const EngineFit& fit, const EngineFit& before, const Problem& p) {
  if (p.model.each_texel) return false;
  const float alpha = narrowest_alpha(fit, p);
  return alpha < kLeastAlpha && alpha < narrowest_alpha(before, p);
}

/// Moves one parameter if that is better.
bool improve(EngineFit& best, const Problem& p, size_t which, float by) {
  EngineFit other = best;
  const Searched at = searched(other, p)[which];
  const float before = *at.value;
  *at.value = std::clamp(before * std::exp(which < 3 ? 2 * by : by), at.least, at.most);
  if (*at.value == before || falls_between_directions(other, best, p)) return false;
  solve(other, p, 1);
  if (other.error >= best.error) return false;
  best = other;
  return true;
}

/// With the tint that belongs to its widths.
void tinted(EngineFit& fit, const Problem& p, int rounds) {
  if (!p.model.view_tinted) return;
  solve(fit, p, rounds, true);
  solve(fit, p, 1);
}

EngineFit descend(EngineFit best, const Problem& p, float first_step, float last_step) {
  const size_t count = searched(best, p).size();
  float step = first_step;
  while (step > last_step) {
    tinted(best, p, 1);
    // Until none has helped since the last one that did.
    for (size_t which = 0, failed = 0; failed < count; which = (which + 1) % count)
      failed = improve(best, p, which, -step) || improve(best, p, which, step) ? 0 : failed + 1;
    step /= 2;
  }
  return best;
}

/// With the colours that belong to its widths.
EngineFit finished(EngineFit fit, const Problem& p) {
  solve(fit, p, kRounds);
  tinted(fit, p, kTintRounds);
  return fit;
}

EngineDirections directions_for(const FarRadiance& cloth, const EngineModel& model) {
  return fit_directions(cloth, model.planes, model.anisotropic ? 0 : kRoundWeight);
}

/// Enough pixels to find the widths of the lobe.
EngineTexels some_of(const EngineTexels& all) {
  const size_t step = std::max<size_t>(all.texels.size() / kSearchedTexels, 1);
  EngineTexels out{{}, all.lean, all.footprint_weight};
  for (size_t i = 0; i < all.texels.size(); i += step) out.texels.push_back(all.texels[i]);
  return out;
}

/// The best of all starts.
EngineFit from_starts(const Problem& p) {
  EngineFit best;
  best.error = std::numeric_limits<float>::max();
  for (const auto& [lobe, weft] : kStarts) {
    if (!p.model.anisotropic && weft != 1) continue;
    EngineFit start;
    start.lobe.fibre = glm::vec2(std::pow(lobe, freedom(p)));
    start.lobe.weft = std::pow(weft, freedom(p));
    if (falls_between_directions(start, {}, p)) continue;
    if (!has_sheen(p.model)) start.sheen = glm::vec3(0);
    solve(start, p, kRounds);
    start = descend(start, p, kFirstStep, 0.5f * kFirstStep);
    if (start.error < best.error) best = start;
  }
  return descend(best, p, 0.5f * kFirstStep, kLastStep);
}

/// From the neighbour's fit, in small steps.
EngineFit from_neighbour(const Problem& p) {
  EngineFit start = *p.near;
  for (const Searched& at : searched(start, p)) *at.value = std::clamp(*at.value, at.least, at.most);
  solve(start, p, kRounds);
  return descend(start, p, 2 * kLastStep, kLastStep);
}

}  // namespace

EngineFit fit_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                     const EngineModel& model, const EngineFit* near) {
  if (texels.texels.empty()) return {};
  const EngineDirections directions = directions_for({cloth, response}, model);
  const EngineTexels few = some_of(texels);
  Problem p{few, directions, model, layout_of(model), bounds_of(texels, model)};
  EngineFit best = from_starts(p);
  if (near != nullptr) {
    p.near = near;
    const EngineFit beside = from_neighbour(p);
    if (beside.error <= kNeighbourLoss * best.error) best = beside;
    else p.near = nullptr;
  }
  return finished(best, {texels, directions, model, p.layout, p.bounds, p.near});
}

EngineFit refit_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                       const EngineModel& model, const EngineFit& fitted) {
  if (texels.texels.empty()) return {};
  const EngineDirections directions = directions_for({cloth, response}, model);
  EngineFit start;
  start.lobe = fitted.lobe, start.relief = fitted.relief;
  if (!has_sheen(model)) start.sheen = glm::vec3(0);
  return finished(start, {texels, directions, model, layout_of(model), bounds_of(texels, model)});
}

std::vector<EngineCheck> check_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                                      const EngineModel& model, const EngineFit& fit) {
  const EngineDirections directions = check_directions({cloth, response});
  const std::vector<PairRadiance> radiance = texel_radiance(texels, directions, model, fit);
  std::vector<EngineCheck> out;
  for (size_t i = 0; i < radiance.size(); ++i) {
    const EnginePair& pair = directions.pairs[i];
    out.push_back({directions.views[pair.view], directions.lights[pair.light], pair.wanted, whole(radiance[i], fit)});
  }
  return out;
}

namespace {

std::vector<EngineScore> scores_of(const EngineTexels& texels, const EngineDirections& directions,
                                   const EngineModel& model, const EngineFit& fit) {
  const std::vector<PairRadiance> radiance = texel_radiance(texels, directions, model, fit);
  struct Sums {
    float engine = 0, wanted = 1e-9f, square = 0, squares = 1e-12f;
  };
  std::vector<EngineScore> out;
  std::vector<Sums> sums;
  for (const EngineView& view : directions.means) {
    if (out.empty() || std::abs(out.back().view_deg - view.view_deg) > 0.5f)
      out.push_back({view.view_deg, 1, 0}), sums.push_back({});
    Sums& s = sums.back();
    for (size_t i = view.first; i < view.first + view.count; ++i) {
      const EnginePair& pair = directions.pairs[i];
      const float a = glm::dot(whole(radiance[i], fit), kLuminance), b = glm::dot(pair.wanted, kLuminance);
      s.engine += pair.fraction * a, s.wanted += pair.fraction * b;
      s.square += pair.fraction * (a - b) * (a - b), s.squares += pair.fraction * b * b;
    }
  }
  for (size_t i = 0; i < out.size(); ++i)
    out[i].mean = sums[i].engine / sums[i].wanted, out[i].error = std::sqrt(sums[i].square / sums[i].squares);
  return out;
}

}  // namespace

std::vector<EngineScore> score_engine(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                                      const EngineModel& model, const EngineFit& fit) {
  return scores_of(texels, grid_directions({cloth, response}), model, fit);
}

std::vector<EngineScore> score_plane(const EngineTexels& texels, const Cloth& cloth, const ClothResponse& response,
                                     const EngineModel& model, const EngineFit& fit, EnginePlane plane) {
  return scores_of(texels, plane_directions({cloth, response}, plane == EnginePlane::kWarp), model, fit);
}

}  // namespace weftlight::light
