#include "session/slow_edits.h"

#include "base/text.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr;

namespace {

constexpr const char* kEdit = "edit";  // kinds of tasks
constexpr const char* kClosest = "closest weave";

}  // namespace

void SlowEdits::start(const SlowEdit& edit) {
  const State of{session_.active().id, session_.active().document.snapshot(), nullptr};
  base::Task task = base::task_with_result(
      [edit, of](const base::RunningTask& running) { return edit.apply(*of.design, running); },
      [this, edit, of](const base::Result<Design>& made) {
        if (made) return take(edit, of, *made);
        outcome_.said = fill(tr("{edit}: {problem}"), arg("edit", edit.label), arg("problem", message(made.error())));
      });
  task.kind = kEdit;
  task.name = edit.doing;
  runner_.start(std::move(task));
}

void SlowEdits::take(const SlowEdit& edit, const State& of, const Design& made) {
  OpenDocument* open = session_.find(of.document);
  if (open == nullptr) return;
  std::optional<Design> result = made;
  if (const std::shared_ptr<const Design> now = open->document.snapshot(); now != of.design)
    result = edit.onto ? edit.onto(*now, *of.design, made) : std::nullopt;
  if (!result) {
    outcome_.said = fill(tr("{edit}: not applied, because the draft has changed meanwhile"), arg("edit", edit.label));
    return;
  }
  const bool changed = session_.commit(*open, {edit.label, [&result](const Design&) { return *result; }}, 0);
  if (!changed) outcome_.said = edit.no_change;
  outcome_.edited |= changed && open == &session_.active();
}

void SlowEdits::find_closest_weave() {
  const OpenDocument& open = session_.active();
  const std::optional<RejectedEdit>& rejected = open.view.rejected_edit;
  if (!rejected && searched_.document == open.id) {
    runner_.stop(kClosest);
    searched_ = {};
  }
  if (!rejected || rejected->closest) return;
  const State of{open.id, open.document.snapshot(), rejected->requested};
  if (searched_ == of) return;
  searched_ = of;
  base::Task task = base::task_with_result(
      [of](const base::RunningTask& running) { return closest_weave_to(*of.design, *of.requested, running); },
      [this, of](const base::Result<std::shared_ptr<const ClosestWeave>>& found) {
        take(of, found.value_or(nullptr));
        if (!found)
          outcome_.said =
              fill(tr("The closest weave was not found: {problem}"), arg("problem", message(found.error())));
      });
  task.kind = kClosest;
  task.name = tr("Searching for the closest weave");
  runner_.start(std::move(task));
}

void SlowEdits::take(const State& of, std::shared_ptr<const ClosestWeave> found) {
  if (searched_ == of) searched_ = {};
  OpenDocument* open = session_.find(of.document);
  if (open == nullptr || open->document.snapshot() != of.design) return;
  std::optional<RejectedEdit>& rejected = open->view.rejected_edit;
  if (!rejected || rejected->requested != of.requested) return;
  rejected->closest = std::move(found);
  if (!rejected->closest) rejected.reset();
}

void SlowEdits::cancel(const std::string& kind) {
  runner_.stop(kind);
  if (kind != kClosest) return;
  if (OpenDocument* open = session_.find(searched_.document)) open->view.rejected_edit.reset();
  searched_ = {};
}

}  // namespace weftlight::session
