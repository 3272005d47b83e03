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

using wif::WifUnit;

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

}  // namespace weftlight::session
