#include "session/editing/document_view.h"

#include <algorithm>
#include <cmath>

#include "session/document/document.h"
#include "session/editing/mirror.h"
#include "session/editing/selection_state.h"
#include "session/editing/typing.h"

namespace weftlight::session {
namespace {

constexpr float kSmallestPitch = 0.02f;  // 100,000 threads in 2,000 pixels
constexpr float kLargestPitch = 48.0f;

bool has_mark(const BitMatrix& m, int column) {
  for (int row = 0; row < m.rows(); ++row)
    if (m.get(row, column)) return true;
  return false;
}

}  // namespace

DocumentView view_of(const Document& document, bool per_inch) {
  constexpr double kMmPerCm = 10;
  DocumentView v;
  v.camera = orbit_of(document.now().scene);
  v.given = {document.now().draft.shafts, document.now().draft.treadles};
  v.warp_unit = document.unit(System::kWarp);
  v.weft_unit = document.unit(System::kWeft);
  v.per_inch = per_inch || v.warp_unit.mm != kMmPerCm;
  return v;
}

void follow_document(DocumentView& v, const Document& document) {
  const Design& d = document.now();
  follow_design(v.select, d, document.revision());
  limit_choice(v.chosen, d.draft);
  follow_draft(v.cursor, d.draft);
  if (v.shape && !is_shown(d.draft, *bit_grid_of(v.shape->grid))) v.shape.reset();
  v.color = std::clamp(v.color, 0, static_cast<int>(d.draft.palette.size()) - 1);
  v.yarn = std::clamp(v.yarn, 0, static_cast<int>(d.yarns.size()) - 1);
}

void follow_given(LoomSize& given, const Draft& before, const Draft& now, bool by_painting) {
  // Painting adds only what it uses. An unused new shaft or treadle was requested by the user, also when redo restores
  // it.
  const auto follow = [by_painting](int& own, int was, int is, bool last_in_use) {
    const bool asked = is != was && !(by_painting && (last_in_use || is < was));
    own = asked ? is : std::min(own, is);
  };
  const int shaft = now.shafts - 1, treadle = now.treadles - 1;
  follow(given.shafts, before.shafts, now.shafts, shaft < 0 || has_mark(now.threading, shaft));
  follow(given.treadles, before.treadles, now.treadles,
         treadle < 0 || now.tieup.first(treadle) >= 0 || has_mark(now.treadling, treadle));
}

float zoomed_pitch(float pitch, float steps) {
  float next = pitch * std::pow(1.2f, steps);
  if (next >= 2) {
    next = std::round(next);
    if (next == pitch && steps != 0) next += steps > 0 ? 1.0f : -1.0f;
  }
  return std::clamp(next, kSmallestPitch, kLargestPitch);
}

void page_ends(DocumentView& v, int pages) {
  v.scroll_end += static_cast<float>(pages) * std::max(1.0f, 0.9f * v.seen_ends);
}

void page_picks(DocumentView& v, int pages) {
  v.scroll_pick += static_cast<float>(pages) * std::max(1.0f, 0.9f * v.seen_picks);
}

void bring_into_sight(DocumentView& v, GridId grid, Cell at) {
  const auto see = [](float& scroll, float seen, int cell) {
    constexpr float kBeside = 1;  // cells
    const auto first = static_cast<float>(cell);
    if (seen < 2 * kBeside + 1) scroll = first;
    else scroll = std::max(0.0f, std::clamp(scroll, first + 1 + kBeside - seen, first - kBeside));
  };
  const bool ends = has_ends(grid), picks = has_picks(grid);
  see(ends ? v.scroll_end : v.scroll_treadle, ends ? v.seen_ends : v.seen_treadles, at.a);
  see(picks ? v.scroll_pick : v.scroll_shaft, picks ? v.seen_picks : v.seen_shafts, at.b);
}

void show_place(DocumentView& v, int index, const CellRect& at) {
  v.place = index;
  scroll_to(v, System::kWarp, (at.end0 + at.end1) / 2);
  scroll_to(v, System::kWeft, (at.pick0 + at.pick1) / 2);
}

void scroll_to(DocumentView& v, System system, int thread) {
  const bool warp = system == System::kWarp;
  (warp ? v.scroll_end : v.scroll_pick) =
      static_cast<float>(thread) + 0.5f - 0.5f * (warp ? v.seen_ends : v.seen_picks);
}

}  // namespace weftlight::session
