// A generated weave as a new draft, or applied to all or some threads of a draft.

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "design/loom.h"
#include "draft/drawdown.h"
#include "draft/factor.h"
#include "weaves/table.h"

namespace weftlight::weaves {

using base::arg, base::fill, base::tr;
using design::Design, design::WeaveUse, design::loom_size, design::weaves_on_loom;
using draft::BitMatrix, draft::Draft, draft::Rgb, draft::ShedControl, draft::drawdown, draft::first_equal_rows,
    draft::lifts, draft::with_drawdown;

namespace {

bool overlaps(const WeaveUse& a, const WeaveUse& b) {
  return a.first_end < b.first_end + b.ends && b.first_end < a.first_end + a.ends &&
         a.first_pick < b.first_pick + b.picks && b.first_pick < a.first_pick + a.picks;
}

/// Stores `use` and forgets the weaves that it overlaps.
void store_use(Design& design, const WeaveUse& use) {
  std::erase_if(design.weaves, [&](const WeaveUse& old) { return overlaps(old, use); });
  design.weaves.push_back(use);
}

/// Replaces threading, tie-up and treadling or liftplan; keeps shed and shed control.
void replace_structure(Draft& d, Draft made) {
  d.shafts = made.shafts;
  d.treadles = made.treadles;
  d.threading = std::move(made.threading);
  d.tieup = std::move(made.tieup);
  d.treadling = std::move(made.treadling);
  d.liftplan = std::move(made.liftplan);
  if (!d.rising)
    for (int t = 0; t < d.treadles; ++t)
      for (int s = 0; s < d.shafts; ++s) d.tieup.set(t, s, !d.tieup.get(t, s));
  const bool plan = d.shed_control == ShedControl::kLiftplan;
  d.shed_control = ShedControl::kTreadling;
  if (!plan) return;
  d.liftplan = lifts(d);
  d.shed_control = ShedControl::kLiftplan;
}

}  // namespace

base::Result<GeneratedWeave> with_weave(Design design, const WeaveUse& requested) {
  const WeaveKind* kind = find_weave(requested.weave);
  const Draft& d = design.draft;
  WeaveUse use = requested;
  use.first_end = std::clamp(use.first_end, 0, d.ends());
  use.first_pick = std::clamp(use.first_pick, 0, d.picks());
  use.ends = std::clamp(use.ends, 0, d.ends() - use.first_end);
  use.picks = std::clamp(use.picks, 0, d.picks() - use.first_pick);
  const auto impossible = [](std::string why) { return base::failure(base::ErrorKind::kInput, std::move(why)); };
  if (!kind) return impossible(fill(tr("there is no weave named '{name}'"), arg("name", requested.weave)));
  if (use.ends == 0 || use.picks == 0) return impossible(tr("no threads are selected"));
  use.values = complete_values(*kind, requested.values);
  if (auto checked = check_values(*kind, use.values); !checked) return failed(checked);
  GeneratedWeave made = kind->make(use.values, {use.ends, use.picks});
  if (use.ends == d.ends() && use.picks == d.picks()) {
    if (kind->colors == WeaveColors::kOwn) {
      design.draft.palette = made.design.draft.palette;
      design.draft.warp.color = made.design.draft.warp.color;
      design.draft.weft.color = made.design.draft.weft.color;
    }
    Draft whole = design.draft;
    replace_structure(whole, std::move(made.design.draft));
    if (const base::Result<void> possible = weaves_on_loom(design, whole); !possible) return failed(possible);
    design.draft = std::move(whole);
  } else {
    const BitMatrix part = drawdown(made.design.draft);
    BitMatrix cells = drawdown(d);
    for (int p = 0; p < use.picks; ++p)
      for (int e = 0; e < use.ends; ++e) cells.set(use.first_pick + p, use.first_end + e, part.get(p, e));
    base::Result<Draft> factored = with_drawdown(d, cells, loom_size(design));
    if (!factored) return failed(factored);
    design.draft = std::move(*factored);
  }
  store_use(design, use);
  return GeneratedWeave{std::move(design), std::move(made.note)};
}

ClothSize repeat_of(const WeaveKind& kind, const WeaveValues& values) {
  // Twice the longest repeat that is returned, so that a repeat can be recognised.
  constexpr int kThreads = 2048;
  const Design design = kind.make(complete_values(kind, values), {kThreads, kThreads}).design;
  const auto period = [](const std::vector<int>& first) {
    const int n = static_cast<int>(first.size());
    std::vector<int> border(first.size() + 1, 0);
    for (int i = 1, k = 0; i < n; ++i) {
      while (k > 0 && first[static_cast<size_t>(i)] != first[static_cast<size_t>(k)])
        k = border[static_cast<size_t>(k)];
      if (first[static_cast<size_t>(i)] == first[static_cast<size_t>(k)]) ++k;
      border[static_cast<size_t>(i) + 1] = k;
    }
    const int found = n - border[first.size()];
    return found <= n / 2 ? found : 0;
  };
  const auto thread_ids = [](const BitMatrix& m, const std::vector<int>& colors) {
    std::vector<int> of = first_equal_rows(m);
    for (size_t i = 0; i < of.size(); ++i) of[i] = of[i] * 4096 + colors[i] % 4096;
    return of;
  };
  const Draft& d = design.draft;
  return {period(thread_ids(d.threading, d.warp.color)), period(thread_ids(lifts(d), d.weft.color))};
}

std::string cut_repeat_note(const WeaveKind& kind, const WeaveValues& values, ClothSize room) {
  const ClothSize repeat = repeat_of(kind, values);
  if (repeat.ends <= room.ends && repeat.picks <= room.picks) return {};
  return fill(tr("The repeat has {ends} ends and {picks} picks, and there is room for {ends_here} by "
                 "{picks_here}; the rest of it is left out."),
              arg("ends", repeat.ends), arg("picks", repeat.picks), arg("ends_here", room.ends),
              arg("picks_here", room.picks));
}

ClothSize whole_repeats(ClothSize repeat, ClothSize about) {
  const auto whole = [](int one, int wanted) {
    return one <= 0 ? wanted : std::max(1, (wanted + one / 2) / one) * one;
  };
  return {whole(repeat.ends, about.ends), whole(repeat.picks, about.picks)};
}

GeneratedWeave new_draft(const WeaveKind& kind, const WeaveValues& values, ClothSize size) {
  const std::vector<Rgb> two_tones = {{0.93f, 0.90f, 0.84f}, {0.16f, 0.25f, 0.42f}};
  const Rgb third_tone = {0.72f, 0.38f, 0.24f};
  WeaveUse use{kind.id, complete_values(kind, values), 0, size.ends, 0, size.picks};
  GeneratedWeave made = kind.make(use.values, size);
  if (kind.colors == WeaveColors::kTwoTone)
    made.design = with_colors(std::move(made.design), two_tones, {{0, 1}}, {{1, 1}});
  if (kind.colors == WeaveColors::kPattern)
    made.design = with_colors(std::move(made.design), two_tones, {{0, 1}}, {{1, 1}, {0, 1}});
  if (kind.colors == WeaveColors::kByThread) {
    std::vector<Rgb> tones = two_tones;
    if (std::ranges::find(made.design.draft.weft.color, 2) != made.design.draft.weft.color.end())
      tones.push_back(third_tone);
    made.design = with_colors(std::move(made.design), std::move(tones), {}, {});
  }
  made.design.weaves = {std::move(use)};
  return made;
}

}  // namespace weftlight::weaves
