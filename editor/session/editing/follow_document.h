#pragma once
// How the view of a document follows it.

#include "session/editing/document_view.h"

namespace weftlight::session {

using draft::CellRect;

class Document;

/// The view of a document that was just opened: fitted, with the camera of the draft.
DocumentView view_of(const Document& document);
/// Called after every change of the design: limits selection, cursor, colour and yarn to what still exists.
void follow_document(DocumentView& view, const Document& document);
/// Scrolls difference `index` to the middle of the pane.
void show_place(DocumentView& view, int index, const CellRect& place);

}  // namespace weftlight::session
