// Fitted by M. J. D. Powell, The BOBYQA algorithm for bound constrained optimization without derivatives, 2009, as
// NLopt has it.

#include "render_data/fibre_lobes.h"

#include <nlopt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "base/text.h"
#include "design/fibre.h"
#include "design/yarn_fields.h"
#include "render_data/face_cloth.h"
#include "render_data/flat_radiance.h"
#include "weaves/weaves.h"

namespace weftlight::render_data {

using base::ErrorKind, base::Result, base::TaskProgress, base::failed, base::failure, base::tr;
using cloth::Period;
using design::Lobes, design::Yarn, design::clamped;
using draft::drawdown;

namespace {

constexpr draft::Rgb kDyes{0.88f, 0.59f, 0.24f};  // a pale, a middle and a deep one, each traced in a channel
constexpr float kSeen = 0.03f;                    // of the brightest: what is darker does not count
constexpr float kTracingShare = 0.4f;             // of the time, for the progress

std::vector<FlatDirections> fitted_directions() {
  std::vector<FlatDirections> out;
  for (const bool warp : {true, false})
    for (const double view : {0.0, 30.0, 60.0})
      for (int light = -80; light <= 80; light += 5) out.push_back({warp, view, static_cast<double>(light)});
  return out;
}

Design swatch_of(const Yarn& yarn, Design woven) {
  woven = weaves::with_colors(std::move(woven), {kDyes}, {{0, 1}}, {{0, 1}});
  woven.yarns = {yarn};
  for (draft::Threads* threads : {&woven.draft.warp, &woven.draft.weft}) std::ranges::fill(threads->yarn, 0);
  return weaves::with_sett(std::move(woven));
}

/// A swatch and what its traced fibres send.
struct Swatch {
  Design design;
  std::vector<glm::vec3> fibres;
};

Cloth cloth_of(const Design& design) {
  return face_cloth(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
}

/// Sum of squares of log2(threads / fibres), and how many there are.
struct Difference {
  double squares = 0;
  int count = 0;
};

Difference difference_of(const std::vector<glm::vec3>& threads, const std::vector<glm::vec3>& fibres) {
  Difference out;
  for (int c = 0; c < 3; ++c) {
    float peak = 0;
    for (const glm::vec3& f : fibres) peak = std::max(peak, f[c]);
    for (size_t i = 0; i < fibres.size(); ++i) {
      if (fibres[i][c] <= kSeen * peak) continue;
      const double off =
          std::log2(std::max(static_cast<double>(threads[i][c]), 1e-6) / static_cast<double>(fibres[i][c]));
      out.squares += off * off, ++out.count;
    }
  }
  return out;
}

/// What is fitted, as numbers for the optimiser: widths and layers by their logarithm.
constexpr size_t kFitted = 5;
using Point = std::array<double, kFitted>;
constexpr std::array<double, 2> kWidths{0.03, 1.0}, kLayers{1, 16}, kInner{0, 0.9}, kBody{0.1, 1};

Point point_of(const Lobes& l) {
  constexpr float kMinWidth = 1e-3f;  // a width may be 0
  return {std::log(static_cast<double>(std::max(l.along_width, kMinWidth))),
          std::log(static_cast<double>(std::max(l.across_width, kMinWidth))), std::log(static_cast<double>(l.layers)),
          static_cast<double>(l.inner), static_cast<double>(l.body)};
}

Lobes lobes_at(Lobes lobes, const double* x) {
  lobes.along_width = static_cast<float>(std::exp(x[0])), lobes.across_width = static_cast<float>(std::exp(x[1]));
  lobes.layers = static_cast<float>(std::exp(x[2]));
  lobes.inner = static_cast<float>(x[3]), lobes.body = static_cast<float>(x[4]);
  return lobes;
}

/// The search for the lobes of one yarn.
struct Search {
  Yarn yarn;
  std::vector<Swatch> swatches;
  std::vector<FlatDirections> directions;
  const TaskProgress* progress = nullptr;
  nlopt_opt optimiser = nullptr;
  int tries = 0, max_tries = 1;

  double octaves(const Lobes& lobes) const {
    Difference all;
    for (const Swatch& swatch : swatches) {
      Design design = swatch.design;
      design.yarns[0].lobes = lobes;
      const Difference d = difference_of(evaluated_radiance(cloth_of(design), directions), swatch.fibres);
      all.squares += d.squares, all.count += d.count;
    }
    return std::sqrt(all.squares / std::max(all.count, 1));
  }
};

double octaves_at(unsigned /*count*/, const double* x, double* /*gradient*/, void* data) {
  Search& search = *static_cast<Search*>(data);
  if (search.progress->stopped()) nlopt_force_stop(search.optimiser);
  ++search.tries;
  const float share = std::min(static_cast<float>(search.tries) / static_cast<float>(search.max_tries), 1.0f);
  search.progress->report(kTracingShare + (1 - kTracingShare) * share);
  return search.octaves(lobes_at(search.yarn.lobes, x));
}

Result<void> trace(Search& search, const FibreFit& fit) {
  const auto count = static_cast<float>(search.swatches.size());
  for (size_t k = 0; k < search.swatches.size(); ++k) {
    const TaskProgress part(search.progress->stop(), [&search, k, count](float share, const std::string&) {
      search.progress->report(kTracingShare * (static_cast<float>(k) + share) / count);
    });
    auto traced = fibre_radiance(cloth_of(search.swatches[k].design), search.directions, fit.spp, part);
    if (!traced) return failed(traced);
    search.swatches[k].fibres = std::move(*traced);
  }
  return {};
}

/// To three decimals, as they are read in a draft.
Lobes rounded(Lobes lobes) {
  for (float Lobes::*member : {&Lobes::along_width, &Lobes::across_width, &Lobes::layers, &Lobes::inner, &Lobes::body})
    lobes.*member = std::round(1000 * lobes.*member) / 1000;
  return clamped(lobes);
}

/// The lobes that lie nearest to the fibres.
Lobes best_of(Search& search, const FibreFit& fit) {
  Point low{std::log(kWidths[0]), std::log(kWidths[0]), std::log(kLayers[0]), kInner[0], kBody[0]},
      high{std::log(kWidths[1]), std::log(kWidths[1]), std::log(kLayers[1]), kInner[1], kBody[1]};
  // Begun with many layers and much inner light, as fibres have, not where the given lobes may sit in a hollow.
  Lobes begin = search.yarn.lobes;
  begin.across_width = 0.4f, begin.layers = 6, begin.inner = 0.4f, begin.body = 0.5f;
  Point x = point_of(begin);
  if (!fit.fit_lustre) low[0] = high[0] = x[0];
  for (size_t k = 0; k < kFitted; ++k) x[k] = std::clamp(x[k], low[k], high[k]);
  constexpr Point kSteps{0.4, 0.4, 0.5, 0.15, 0.2};

  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(nlopt_create(NLOPT_LN_BOBYQA, kFitted),
                                                                         &nlopt_destroy);
  search.optimiser = optimiser.get();
  search.max_tries = fit.max_tries;
  nlopt_set_lower_bounds(search.optimiser, low.data());
  nlopt_set_upper_bounds(search.optimiser, high.data());
  nlopt_set_initial_step(search.optimiser, kSteps.data());
  nlopt_set_min_objective(search.optimiser, octaves_at, &search);
  nlopt_set_maxeval(search.optimiser, fit.max_tries);
  nlopt_set_ftol_abs(search.optimiser, 1e-3);
  double least = 0;
  nlopt_optimize(search.optimiser, x.data(), &least);
  return lobes_at(search.yarn.lobes, x.data());
}

}  // namespace

Result<FibreLobes> lobes_of_fibres(const Yarn& yarn, const FibreFit& fit, const TaskProgress& progress) {
  if (yarn.lobes.metallic)
    return failure(ErrorKind::kInput, tr("metallic yarn has no dye; its lobes are those of the metal"));
  if (progress.stopped()) return failure(ErrorKind::kCancelled, tr("stopped"));
  Search search{clamped(yarn), {}, fitted_directions(), &progress};
  // As even as the yarn is on the mean, so that a swatch of a few threads is like any other.
  search.yarn.irregularity = search.yarn.unevenness = search.yarn.melange = 0;
  search.yarn.dye = {};  // colours along a thread are not the swatch's
  search.swatches = {{swatch_of(search.yarn, weaves::plain({16, 16})), {}},
                     {swatch_of(search.yarn, weaves::satin(8, 3, Face::kFront, {16, 16})), {}}};
  if (const auto traced = trace(search, fit); !traced) return failed(traced);

  FibreLobes out{yarn.lobes, static_cast<float>(search.octaves(search.yarn.lobes))};
  out.octaves = out.octaves_before;
  if (fit.max_tries < 1) return out;
  Lobes found = rounded(best_of(search, fit));
  if (!fit.fit_lustre) found.along_width = yarn.lobes.along_width;
  if (progress.stopped()) return failure(ErrorKind::kCancelled, tr("stopped"));
  const auto octaves = static_cast<float>(search.octaves(found));
  if (octaves < out.octaves_before) out.lobes = found, out.octaves = octaves;
  return out;
}

}  // namespace weftlight::render_data
