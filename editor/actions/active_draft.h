#pragma once
// The draft that is shown, its view, and the one way to change it.

#include <functional>

#include "session/document/document.h"
#include "session/editing/document_view.h"

namespace weftlight::actions {

using session::Document, session::DocumentView, session::Edit, session::SlowEdit;

struct ActiveDraft {
  std::function<const Document&()> document;
  /// Of that document; the settings are shared by all documents.
  std::function<DocumentView&()> view;
  std::function<void(const Edit&)> commit;
  /// Commits it when it is computed, if the draft is still the same.
  std::function<void(const SlowEdit&)> compute;
  std::function<void()> undo, redo;
};

}  // namespace weftlight::actions
