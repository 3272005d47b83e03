#pragma once
// Edits that take seconds, computed beside the window: the weaver paints on meanwhile, and nothing painted is lost. A
// result belongs to one state of one document; where that has changed since, it is dropped.

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "base/tasks.h"
#include "session/document/edit.h"
#include "session/session.h"

namespace weftlight::session {

using design::Design;

class SlowEdits {
 public:
  /// Both outlive it; the results are taken by `runner`'s take().
  SlowEdits(Session& session, base::TaskRunner& runner) : session_(session), runner_(runner) {}
  SlowEdits(const SlowEdits&) = delete;
  SlowEdits& operator=(const SlowEdits&) = delete;

  /// Computes an edit of the active document. It is committed there, as a step of its own, if the document is the same
  /// then, whichever is active.
  void start(const SlowEdit& edit);
  /// Searches for the closest weave to the rejected edit of the active document, once; stops the search when the edit
  /// was dismissed. Call it in every frame without a gesture.
  void find_closest_weave();
  /// Drops what is computed as a task of this kind, at the user's request.
  void cancel(const std::string& kind);

  struct Outcome {
    bool edited = false;  // the active document
    std::string said;
  };
  /// What came of the results taken since the last call.
  Outcome take_outcome() { return std::exchange(outcome_, {}); }

 private:
  /// What a result belongs to.
  struct State {
    uint64_t document = 0;
    std::shared_ptr<const Design> design, requested;  // `requested`: of the rejected edit
    bool operator==(const State&) const = default;
  };
  void take(const SlowEdit& edit, const State& of, const Design& made);
  void take(const State& of, std::shared_ptr<const ClosestWeave> found);

  Session& session_;
  base::TaskRunner& runner_;
  State searched_;  // the closest weave to this is being searched for
  Outcome outcome_;
};

}  // namespace weftlight::session
