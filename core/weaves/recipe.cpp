// What all generators share: a draft from its recipe, colours in stripes, and the sett.
//
// Sett. Based on: T. R. Ashenhurst, A Treatise on Textile Calculations and the Structure of Fabrics, 1884:
// a thread needs room for itself and for the threads that pass between it and the next, so that fewer interlacings
// allow a closer sett. Differs: Ashenhurst counts round threads on
// the loom. Finished cloth is closer, its threads flattened and bloomed until they nearly touch: they cover about 6/7
// of the width in plain weave and, where no thread passes between them, all of it (F. T. Peirce, The Geometry
// of Cloth Structure, 1937, on flattened threads and cover).

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/mark.h"
#include "design/fibre.h"
#include "draft/drawdown.h"
#include "weaves/weaves.h"

namespace weftlight::weaves {

using base::mark;
using design::Design, design::Yarn, design::with_thickness;
using draft::BitMatrix, draft::Draft, draft::Rgb, draft::System, draft::Threads, draft::blank_draft, draft::drawdown,
    draft::first_equal_rows, draft::kMaxThreads, draft::transposed;

namespace {

constexpr float kGapAtPlain = 1.0f / 7.0f;  // fraction of the width that is open in plain weave

// Interlacings per crossing along the rows, 0..1.
float interlacing(const BitMatrix& cells) {
  int64_t changes = 0;
  for (int r = 0; r < cells.rows(); ++r) {
    for (int c = 0; c < cells.cols(); ++c) changes += cells.get(r, c) != cells.get(r, (c + 1) % cells.cols());
  }
  const float crossings = static_cast<float>(cells.rows()) * static_cast<float>(cells.cols());
  return crossings > 0 ? static_cast<float>(changes) / crossings : 0;
}

float mean_width_mm(const Threads& threads, const std::vector<Yarn>& yarns) {
  float sum = 0;
  for (int i = 0; i < threads.size(); ++i) {
    const Yarn& yarn = yarns[threads.yarn[i]];
    const float own = threads.thickness_mm[i];
    // Width of an ellipse with the area of the round thread; `flattening` is its height over its width.
    sum += (own >= 0 ? own : yarn.diameter_mm) / std::sqrt(yarn.flattening);
  }
  return threads.size() > 0 ? sum / static_cast<float>(threads.size()) : 0;
}

void set_spacing(Threads& threads, const std::vector<Yarn>& yarns, float interlacings, float openness) {
  const float mm = mean_width_mm(threads, yarns) / (1 - kGapAtPlain * interlacings) * openness;
  // Rounded to 0.01 mm, as the user reads the number.
  std::fill(threads.spacing_mm.begin(), threads.spacing_mm.end(), std::round(mm * 100) / 100);
}

void set_stripes(Threads& threads, const std::vector<Stripe>& order, size_t colors) {
  std::vector<int> sequence;
  for (const Stripe& stripe : order) {
    const int color = std::clamp(stripe.color, 0, static_cast<int>(colors) - 1);
    sequence.insert(sequence.end(), static_cast<size_t>(std::clamp(stripe.threads, 0, kMaxThreads)), color);
  }
  if (sequence.empty()) return;
  for (size_t i = 0; i < threads.color.size(); ++i) threads.color[i] = sequence[i % sequence.size()];
}

const std::vector<Rgb> kDefaultPalette = {{0.15f, 0.16f, 0.20f}, {0.93f, 0.91f, 0.86f}};

}  // namespace

Design make_design(const Recipe& recipe, ClothSize size) {
  const int treadles = static_cast<int>(recipe.tieup.size());
  Design design;
  design.draft = blank_draft(std::clamp(size.ends, 1, kMaxThreads), std::clamp(size.picks, 1, kMaxThreads),
                             recipe.shafts, treadles);
  Draft& d = design.draft;
  for (int e = 0; e < d.ends(); ++e) d.threading.set(e, recipe.threading[e % recipe.threading.size()], true);
  for (int p = 0; p < d.picks(); ++p) d.treadling.set(p, recipe.treadling[p % recipe.treadling.size()], true);
  for (int t = 0; t < treadles; ++t) {
    for (const int shaft : recipe.tieup[t]) d.tieup.set(t, shaft, true);
  }
  d.palette = kDefaultPalette;
  return with_sett(std::move(design));
}

Recipe recipe_of(const BitMatrix& repeat) {
  Recipe out{0, {}, {}, {}};
  const auto numbered = [](const BitMatrix& threads, std::vector<int>& of) {
    std::vector<int> first;  // the first of each kind of thread
    for (const int same : first_equal_rows(threads)) {
      const auto found = std::ranges::find(first, same);
      of.push_back(static_cast<int>(found - first.begin()));
      if (found == first.end()) first.push_back(same);
    }
    return first;
  };
  const std::vector<int> ends = numbered(transposed(repeat), out.threading), picks = numbered(repeat, out.treadling);
  out.shafts = static_cast<int>(ends.size());
  for (const int pick : picks) {
    out.tieup.emplace_back();
    for (int s = 0; s < out.shafts; ++s)
      if (repeat.get(pick, ends[static_cast<size_t>(s)])) out.tieup.back().push_back(s);
  }
  return out;
}

Recipe turned(const Recipe& recipe) {
  const int treadles = static_cast<int>(recipe.tieup.size());
  Recipe out{treadles, recipe.treadling, std::vector<std::vector<int>>(static_cast<size_t>(recipe.shafts)),
             recipe.threading};
  // A treadle that did not lift a shaft becomes a shaft that is lifted.
  for (int t = 0; t < treadles; ++t) {
    std::vector<bool> lifted(static_cast<size_t>(recipe.shafts), false);
    for (const int shaft : recipe.tieup[static_cast<size_t>(t)]) lifted[static_cast<size_t>(shaft)] = true;
    for (size_t s = 0; s < lifted.size(); ++s)
      if (!lifted[s]) out.tieup[s].push_back(t);
  }
  return out;
}

Design with_pattern_yarn(Design design, System system, const std::vector<bool>& marked) {
  Yarn pattern = with_thickness(design.yarns[0], 1.6f * design.yarns[0].diameter_mm);  // covers the ground
  pattern.name = mark("Pattern weft");
  pattern.flattening = 0.6f;  // soft and little twisted, so that it spreads
  design.yarns.push_back(pattern);
  Threads& threads = design.draft.threads(system);
  for (size_t i = 0; i < threads.yarn.size(); ++i)
    if (marked[i % marked.size()]) threads.yarn[i] = static_cast<int>(design.yarns.size()) - 1;
  return with_sett(std::move(design));
}

Design with_ground_yarn(Design design, const Yarn& yarn) {
  const float ground_mm = design.yarns[0].diameter_mm;
  for (size_t i = 1; i < design.yarns.size() && ground_mm > 0; ++i) {
    Yarn pattern = with_thickness(yarn, yarn.diameter_mm * design.yarns[i].diameter_mm / ground_mm);
    pattern.name = design.yarns[i].name;
    pattern.flattening = design.yarns[i].flattening;
    design.yarns[i] = std::move(pattern);
  }
  design.yarns[0] = yarn;
  return with_sett(std::move(design));
}

Design with_colors(Design design, std::vector<Rgb> palette, const std::vector<Stripe>& warp,
                   const std::vector<Stripe>& weft) {
  Draft& d = design.draft;
  if (palette.empty()) return design;
  d.palette = std::move(palette);
  const int last = static_cast<int>(d.palette.size()) - 1;
  for (Threads* threads : {&d.warp, &d.weft}) {
    for (int& color : threads->color) color = std::min(color, last);
  }
  set_stripes(d.warp, warp, d.palette.size());
  set_stripes(d.weft, weft, d.palette.size());
  return design;
}

Design with_sett(Design design, float openness) {
  const BitMatrix cells = drawdown(design.draft);
  set_spacing(design.draft.warp, design.yarns, interlacing(cells), openness);
  set_spacing(design.draft.weft, design.yarns, interlacing(transposed(cells)), openness);
  return design;
}

}  // namespace weftlight::weaves
