#pragma once
// The document that is shown, and the edits of it. Nothing else in the window changes a design.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "actions/active_draft.h"
#include "app/background_tasks.h"
#include "app/messages.h"
#include "session/editing/strokes.h"
#include "session/editing/typing.h"
#include "session/session.h"
#include "session/slow_edits.h"

namespace weftlight::app {

using actions::ActiveDraft;
using session::Document, session::DocumentView, session::Edit, session::Session, session::SlowEdit, session::SlowEdits,
    session::Strokes, session::TypedKey;

class Editing {
 public:
  /// `edited` is called after every change of the shown design.
  Editing(Session& session, BackgroundTasks& tasks, Messages& messages, std::function<void()> edited)
      : session_(session), messages_(messages), edited_(std::move(edited)), slow_edits_(session, tasks.computing()) {}

  const Document& document() const { return session_.active().document; }
  DocumentView& view() { return session_.active().view; }
  uint64_t shown_id() const { return session_.active().id; }
  void commit(const Edit& edit);
  /// Commits it to that document, whichever is shown; nothing if that has been closed.
  void commit_to(uint64_t id, const Edit& edit);
  /// Commits it when it is computed, if the draft is still the same.
  void compute(const SlowEdit& edit) { slow_edits_.start(edit); }
  /// After results were taken: shows what they changed.
  void take_computed();
  /// Drops what is computed as a task of this kind.
  void cancel(const std::string& kind) { slow_edits_.cancel(kind); }
  void undo();
  void redo();
  /// Goes to a step of the history.
  void go_to_step(size_t step);
  /// Commits the edits of typed numbers. True if the key was used.
  bool commit(const TypedKey& typed);
  /// Searches for the closest weave to a rejected gesture once it has ended.
  void find_closest_weave();
  Strokes& strokes() { return strokes_; }

  ActiveDraft actions();

 private:
  Session& session_;
  Messages& messages_;
  std::function<void()> edited_;
  Strokes strokes_;
  SlowEdits slow_edits_;
};

}  // namespace weftlight::app
