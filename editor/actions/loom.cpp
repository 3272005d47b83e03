// Weaving the draft pick by pick, by hand or with a connected loom.

#include "actions/action_parts.h"

namespace weftlight::actions {

using base::mark, base::tr;
using session::LoomWork;

void add_loom_actions(Actions& all, const ActiveDraft& draft, const LoomActions& loom) {
  const auto at_loom = [&draft] { return draft.view().at_loom.open; };
  const auto one = [&all](const char* id, const char* label, const char* key, std::function<void()> run) {
    Action& a = add(all, "Draft", id, label, key, std::move(run));
    a.item.submenu = mark("At the loom");
    return &a;
  };
  one("loom", tr("Weave at the loom"), "F9", loom.toggle)->checked = at_loom;
  all.back().item.group = true;
  const auto work = [&](const char* id, const char* label, LoomWork which) {
    Action* a = one(id, label, "", [&loom, which] { loom.work(which); });
    a->enabled = at_loom;
    a->checked = [&draft, which] { return draft.view().at_loom.work == which; };
  };
  work("loom_thread", tr("Thread, end by end"), LoomWork::kThread);
  work("loom_sley", tr("Sley, dent by dent"), LoomWork::kSley);
  work("loom_weave", tr("Weave, pick by pick"), LoomWork::kWeave);
  one("loom_next", tr("Next step"), "", [&loom] { loom.step(true); })->enabled = at_loom;
  all.back().item.group = true;
  one("loom_back", tr("Previous step"), "", [&loom] { loom.step(false); })->enabled = at_loom;
  one("loom_say", tr("Read the step aloud"), "", loom.say)->enabled = at_loom;
  one("loom_tabby", tr("Tabby pick"), "", loom.tabby)->enabled = at_loom;
  Action* between = one("loom_tabby_between", tr("Tabby between pattern picks"), "", loom.tabby_between);
  between->enabled = at_loom;
  between->checked = [&draft] { return draft.document().now().loom.tabby_between; };
  one("loom_connect", tr("Connect the loom"), "", loom.connect)->enabled = at_loom;
  all.back().item.group = true;
  one("loom_disconnect", tr("Disconnect the loom"), "", loom.disconnect)->enabled = at_loom;
  const auto serves = [&loom] { return loom.serves_page(); };
  one("loom_page", tr("Start the phone page"), "", loom.open_page)->enabled = at_loom;
  one("loom_page_code", tr("New pairing code"), "", loom.renew_code)->enabled = serves;
  one("loom_page_off", tr("Stop the phone page"), "", loom.close_page)->enabled = serves;
}

}  // namespace weftlight::actions
