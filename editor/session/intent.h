#pragma once
// What the panels of a frame ask for, in the order in which they asked; the editor does it after all are drawn, so
// that nothing that two of them want is lost.

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "session/edit.h"
#include "session/names.h"

namespace weftlight::session {

struct RunAction {
  std::string id;  // of the table of actions
};
using Intent = std::variant<Edit, RunAction>;

class Intents {
 public:
  void add(MaybeEdit edit) {
    if (edit) all_.emplace_back(std::move(*edit));
  }
  /// Empty: none.
  void add_action(std::string id) {
    if (!id.empty()) all_.emplace_back(RunAction{std::move(id)});
  }
  std::vector<Intent> take() { return std::exchange(all_, {}); }

 private:
  std::vector<Intent> all_;
};

}  // namespace weftlight::session
