#pragma once
// The view state of one open document, by subject: a panel takes the part that it draws. None of it is saved, except
// the camera when the user saves it with the draft.

#include <optional>

#include "session/document/rejected_edit.h"
#include "session/editing/analysis_view.h"
#include "session/editing/cloth_view.h"
#include "session/editing/difference_view.h"
#include "session/editing/draft_view.h"
#include "session/editing/drawing_state.h"
#include "session/editing/select_state.h"
#include "session/editing/thread_choice.h"
#include "session/loom/at_loom.h"
#include "wif/wif.h"

namespace weftlight::session {

using draft::CellRect;
using wif::WifUnit;

class Document;

/// The units of thickness and spacing in the opened file.
struct FileUnits {
  WifUnit warp, weft;
};

struct DocumentView {
  DraftView draft;
  ClothView cloth;
  DrawingState drawing;
  SelectState select;
  ThreadChoice chosen;  // threads shown in the Threads panel
  AnalysisView analysis;
  DifferenceView differences;
  std::optional<RejectedEdit> rejected_edit;  // the last edit that the loom cannot weave
  AtLoom at_loom;
  FileUnits units;
};

/// The view of a document that was just opened: fitted, with the camera of the draft.
DocumentView view_of(const Document& document);
/// Called after every change of the design: limits selection, cursor, colour and yarn to what still exists.
void follow_document(DocumentView& view, const Document& document);
/// Scrolls difference `index` to the middle of the pane.
void show_place(DocumentView& view, int index, const CellRect& place);

}  // namespace weftlight::session
