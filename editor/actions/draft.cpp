// The Draft menu: size, shed, shed control, and what leads.

#include <utility>

#include "actions/action_parts.h"
#include "design/crossings.h"
#include "design/edits.h"
#include "design/loom.h"

namespace weftlight::actions {

namespace {

/// Which grid leads and which follow.
void add_leading(Actions& all) {
  const auto lead = [&all](const char* id, const char* label, Leading leading) {
    Action& a = add(all, "Draft", id, label, "", [label, leading](ActionHost& e) {
      e.commit({label, [leading](Design d) { return with_leading(std::move(d), leading); }});
    });
    a.checked = [leading](const ActionHost& e) { return e.document().now().loom.leading == leading; };
    return &a;
  };
  lead("rules.threading", tr("Threading leads, drawdown follows"), Leading::kThreading)->item.group = true;
  lead("rules.liftplan", tr("Liftplan leads, drawdown follows"), Leading::kLiftplan);
  lead("rules.drawdown", tr("Drawdown leads, threading follows"), Leading::kDrawdown);
  Action& lock = add(all, "Draft", "rules.lock", tr("Lock the grids that follow"), "", [](ActionHost& e) {
    const bool locked = !e.document().now().loom.locked;
    e.commit({locked ? tr("Lock the grids that follow") : tr("Unlock the grids that follow"),
              [locked](Design d) { return with_lock(std::move(d), locked); }});
  });
  lock.checked = [](const ActionHost& e) { return e.document().now().loom.locked; };
  Action& nearest = add(all, "Draft", "nearest", tr("Closest weave for this loom\xE2\x80\xA6"), "",
                        [](ActionHost& e) { e.ask_closest_weave(); });
  nearest.enabled = [](const ActionHost& e) {
    const auto& rejected_edit = e.view().rejected_edit;
    return rejected_edit && rejected_edit->nearest && !rejected_edit->nearest->is_there;
  };
  add(all, "Draft", "larger_loom", tr("Enlarge the loom for what was painted"), "", [](ActionHost& e) {
    const Edit edit = larger_loom_edit(*e.view().rejected_edit);
    e.commit(edit);
  }).enabled = [](const ActionHost& e) { return e.view().rejected_edit.has_value(); };
}

}  // namespace

void add_draft_actions(Actions& all) {
  add(all, "Draft", "notes", tr("Title and notes\xE2\x80\xA6"), "", [](ActionHost& e) { e.ask_notes(); });
  add(all, "Draft", "weave_over", tr("Weave over the draft or selection\xE2\x80\xA6"), "W",
      [](ActionHost& e) { e.ask_weave(); });
  add(all, "Draft", "sections", tr("Build from sections\xE2\x80\xA6"), "Shift+W",
      [](ActionHost& e) { e.ask_sections(); });
  add(all, "Draft", "size", tr("Size and loom limits\xE2\x80\xA6"), "", [](ActionHost& e) { e.ask_size(); });
  const auto shed = [&all](const char* id, const char* label, bool rising) {
    Action& a = add(all, "Draft", id, label, "", [rising](ActionHost& e) {
      e.commit({rising ? tr("Rising shed") : tr("Sinking shed"),
                [rising](Design d) { return with_rising(std::move(d), rising); }});
    });
    a.checked = [rising](const ActionHost& e) { return e.document().now().draft.rising == rising; };
    return &a;
  };
  shed("rising", tr("Rising shed"), true)->item.group = true;
  shed("sinking", tr("Sinking shed"), false);
  const auto control = [&all](const char* id, const char* label, ShedControl to) {
    Action& a = add(all, "Draft", id, label, "", [to](ActionHost& e) {
      if (to == ShedControl::kLiftplan) return e.commit({tr("Use the liftplan"), to_liftplan});
      Edit edit{tr("Use tie-up and treadling"), [](Design d) {
                  const int treadles = loom_size(d).treadles;
                  return to_treadling(std::move(d), treadles);
                }};
      edit.why = [](const Design& d) {
        return fill(tr("This needs {needed} treadles; the loom has {has}."), arg("needed", treadles_needed(d.draft)),
                    arg("has", loom_size(d).treadles));
      };
      e.commit(edit);
    });
    a.checked = [to](const ActionHost& e) { return e.document().now().draft.shed_control == to; };
    a.enabled = [to](const ActionHost& e) { return e.document().now().draft.shed_control != to; };
    return &a;
  };
  control("treadling", tr("Tie-up and treadling"), ShedControl::kTreadling)->item.group = true;
  control("liftplan", tr("Use the liftplan"), ShedControl::kLiftplan);
  add(all, "Draft", "skeleton", tr("Skeleton tie-up, two treadles a pick"), "", [](ActionHost& e) {
    e.compute({tr("Skeleton tie-up, two treadles a pick"), tr("Searching for a skeleton tie-up"),
               [](Design d, const base::TaskProgress& progress) { return to_skeleton(std::move(d), 2, progress); },
               tr("No skeleton tie-up needs fewer treadles.")});
  });
  add_leading(all);
  add_thread_actions(all);
  add_loom_actions(all);
}

}  // namespace weftlight::actions
