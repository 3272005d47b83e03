// Weaving the draft pick by pick, by hand or with a connected loom.

#include "actions/action_parts.h"

namespace weftlight::actions {

void add_loom_actions(Actions& all) {
  const auto at_loom = [](const ActionHost& e) { return e.view().at_loom.open; };
  const auto one = [&all](const char* id, const char* label, const char* key, std::function<void(ActionHost&)> run) {
    Action& a = add(all, "Draft", id, label, key, std::move(run));
    a.item.submenu = mark("At the loom");
    return &a;
  };
  one("loom", tr("Weave at the loom"), "F9", [](ActionHost& e) { e.toggle_loom(); })->checked = at_loom;
  all.back().item.group = true;
  one("loom_next", tr("Next pick"), "", [](ActionHost& e) { e.step_at_loom(true); })->enabled = at_loom;
  one("loom_back", tr("Previous pick"), "", [](ActionHost& e) { e.step_at_loom(false); })->enabled = at_loom;
  one("loom_connect", tr("Connect the loom"), "", [](ActionHost& e) { e.connect_loom(); })->enabled = at_loom;
  one("loom_disconnect", tr("Disconnect the loom"), "", [](ActionHost& e) { e.disconnect_loom(); })->enabled = at_loom;
}

}  // namespace weftlight::actions
