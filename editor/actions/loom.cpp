// Weaving the draft pick by pick, by hand or with a connected loom.

#include "actions/action_parts.h"

namespace weftlight::actions {

using base::mark, base::tr;

void add_loom_actions(Actions& all, const ActiveDraft& draft, const LoomActions& loom) {
  const auto at_loom = [&draft] { return draft.view().at_loom.open; };
  const auto one = [&all](const char* id, const char* label, const char* key, std::function<void()> run) {
    Action& a = add(all, "Draft", id, label, key, std::move(run));
    a.item.submenu = mark("At the loom");
    return &a;
  };
  one("loom", tr("Weave at the loom"), "F9", loom.toggle)->checked = at_loom;
  all.back().item.group = true;
  one("loom_next", tr("Next pick"), "", [&loom] { loom.step(true); })->enabled = at_loom;
  one("loom_back", tr("Previous pick"), "", [&loom] { loom.step(false); })->enabled = at_loom;
  one("loom_connect", tr("Connect the loom"), "", loom.connect)->enabled = at_loom;
  one("loom_disconnect", tr("Disconnect the loom"), "", loom.disconnect)->enabled = at_loom;
}

}  // namespace weftlight::actions
