#include "session/editing/follow_document.h"

#include <algorithm>

#include "session/document/document.h"
#include "session/editing/mirror.h"
#include "session/editing/selection_state.h"
#include "session/editing/typing.h"

namespace weftlight::session {

using design::Design;
using draft::System;

DocumentView view_of(const Document& document) {
  DocumentView v;
  v.cloth.camera = orbit_of(document.now().scene);
  v.drawing.given = {document.now().draft.shafts, document.now().draft.treadles};
  v.units.warp = document.unit(System::kWarp);
  v.units.weft = document.unit(System::kWeft);
  return v;
}

void follow_document(DocumentView& v, const Document& document) {
  const Design& d = document.now();
  follow_design(v.select, d, document.revision());
  limit_choice(v.chosen, d.draft);
  follow_draft(v.drawing.cursor, d.draft);
  if (v.drawing.shape && !is_shown(d.draft, *bit_grid_of(v.drawing.shape->grid))) v.drawing.shape.reset();
  v.drawing.color = std::clamp(v.drawing.color, 0, static_cast<int>(d.draft.palette.size()) - 1);
  v.drawing.yarn = std::clamp(v.drawing.yarn, 0, static_cast<int>(d.yarns.size()) - 1);
}

void show_place(DocumentView& v, int index, const CellRect& at) {
  v.differences.place = index;
  scroll_to(v.draft, System::kWarp, (at.end0 + at.end1) / 2);
  scroll_to(v.draft, System::kWeft, (at.pick0 + at.pick1) / 2);
}

}  // namespace weftlight::session
