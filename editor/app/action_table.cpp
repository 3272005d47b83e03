#include "app/action_table.h"

#include <algorithm>

#include "platform/crash_report.h"

namespace weftlight::app {

using actions::make_actions, actions::nameless_id;
using design::NamedView;
using session::Settings;

void ActionTable::follow(const Document& document) {
  const Settings& settings = subjects_.settings;
  const std::vector<NamedView>& views = document.now().views;
  if (!actions_.empty() && recent_ == settings.recent && keys_ == settings.keys &&
      std::ranges::equal(views_, views, {}, {}, &NamedView::name))
    return;
  recent_ = settings.recent;
  keys_ = settings.keys;
  views_.clear();
  for (const NamedView& v : views) views_.push_back(v.name);
  actions_ = make_actions(subjects_, recent_, keys_, views_);
}

void ActionTable::run(const std::string& id) {
  for (const Action& a : actions_)
    if (a.item.id == id && (!a.enabled || a.enabled())) {
      platform::note_action(nameless_id(id));
      return a.run();
    }
}

bool ActionTable::is_enabled(const std::string& id) const {
  return std::ranges::any_of(actions_, [&](const Action& a) { return a.item.id == id && (!a.enabled || a.enabled()); });
}

bool ActionTable::run_key(const std::string& key) {
  for (const Action& a : actions_)
    if (a.item.shortcut == key) {
      run(a.item.id);
      return true;
    }
  return false;
}

}  // namespace weftlight::app
