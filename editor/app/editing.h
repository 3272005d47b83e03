#pragma once
// The document that is shown, and the edits of it. Nothing else in the window changes a design.

#include <cstddef>
#include <functional>
#include <utility>

#include "actions/active_draft.h"
#include "app/messages.h"
#include "app/names.h"
#include "session/session.h"
#include "session/strokes.h"
#include "session/typing.h"

namespace weftlight::app {

class Editing {
 public:
  /// `edited` is called after every change of the shown design.
  Editing(Session& session, Messages& messages, std::function<void()> edited)
      : session_(session), messages_(messages), edited_(std::move(edited)) {}

  const Document& document() const { return session_.active().document; }
  DocumentView& view() { return session_.active().view; }
  void commit(const Edit& edit);
  void undo();
  void redo();
  /// Goes to a step of the history.
  void go_to_step(size_t step);
  /// Commits the edits of typed numbers. True if the key was used.
  bool commit(const TypedKey& typed);
  /// Computes the closest weave to a rejected gesture once it has ended.
  void find_closest_weave();
  Strokes& strokes() { return strokes_; }

  ActiveDraft actions();

 private:
  Session& session_;
  Messages& messages_;
  std::function<void()> edited_;
  Strokes strokes_;
};

}  // namespace weftlight::app
