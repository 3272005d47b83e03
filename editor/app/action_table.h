#pragma once
// The table of actions of the window, made anew when the files, shortcuts or views that it lists change.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "actions/actions.h"
#include "session/document/document.h"
#include "session/files/user_files.h"

namespace weftlight::app {

using actions::Action, actions::Subjects, actions::show;
using session::ActionItem, session::Document;

class ActionTable {
 public:
  explicit ActionTable(Subjects subjects) : subjects_(std::move(subjects)) {}
  ActionTable(const ActionTable&) = delete;
  ActionTable& operator=(const ActionTable&) = delete;

  /// Makes the table anew if it is outdated.
  void follow(const Document& document);
  /// As the panels show them.
  std::vector<ActionItem> items() const { return show(actions_); }
  void run(const std::string& id);
  /// Whether the action can be run now.
  bool is_enabled(const std::string& id) const;
  /// Runs the action with that shortcut; false if there is none.
  bool run_key(const std::string& key);

 private:
  Subjects subjects_;
  std::vector<Action> actions_;
  // Of the table.
  std::vector<std::string> recent_, views_;
  std::map<std::string, std::string> keys_;
};

}  // namespace weftlight::app
