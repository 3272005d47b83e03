#pragma once
// Requests of the panels in a frame, in their order. The editor carries them out after all panels are drawn, so that no
// request is lost if two panels make one.

#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "session/document/edit.h"
#include "session/editing/document_view.h"
#include "session/files/user_files.h"

namespace weftlight::session {

using design::Design;

struct RunAction {
  std::string id;  // in the table of actions
};
/// A gesture changes the view, and perhaps the design; it gets both as they are when it runs.
struct Gesture {
  std::function<MaybeEdit(DocumentView&, const Design&)> run;
};
struct SettingsChange {
  std::function<void(Settings&)> run;
};
struct GoToStep {
  size_t step = 0;  // of the history
};
using Intent = std::variant<Edit, RunAction, Gesture, SettingsChange, GoToStep>;

class Intents {
 public:
  void add(MaybeEdit edit) {
    if (edit) all_.emplace_back(std::move(*edit));
  }
  /// An empty id does nothing.
  void add_action(std::string id) {
    if (!id.empty()) all_.emplace_back(RunAction{std::move(id)});
  }
  void gesture(std::function<MaybeEdit(DocumentView&, const Design&)> run) {
    all_.emplace_back(Gesture{std::move(run)});
  }
  template <class Change>
  void change_view(Change change) {
    gesture([change = std::move(change)](DocumentView& view, const Design&) mutable {
      change(view);
      return MaybeEdit();
    });
  }
  void change_settings(std::function<void(Settings&)> run) { all_.emplace_back(SettingsChange{std::move(run)}); }
  void go_to(size_t step) { all_.emplace_back(GoToStep{step}); }
  std::vector<Intent> take() { return std::exchange(all_, {}); }

 private:
  std::vector<Intent> all_;
};

}  // namespace weftlight::session
