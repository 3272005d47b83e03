// The draft as a whole: its size, its shed, what drives it.

#include <utility>

#include "actions/action_parts.h"
#include "draft/crossings.h"
#include "draft/edits.h"

namespace weftlight::actions {

namespace {

/// What rules and what follows.
void add_rules(Actions& all) {
  const auto rule = [&all](const char* id, const char* label, Leading leading) {
    Action& a = add(all, "Draft", id, label, "", [label, leading](ActionHost& e) {
      e.commit({label, [leading](Design d) { return with_leading(std::move(d), leading); }});
    });
    a.checked = [leading](const ActionHost& e) { return e.document().now().loom.leading == leading; };
    return &a;
  };
  rule("rules.threading", "Threading rules, drawdown follows", Leading::kThreading)->item.group = true;
  rule("rules.liftplan", "Liftplan rules, drawdown follows", Leading::kLiftplan);
  rule("rules.drawdown", "Drawdown rules, threading follows", Leading::kDrawdown);
  Action& lock = add(all, "Draft", "rules.lock", "Lock what follows", "", [](ActionHost& e) {
    const bool locked = !e.document().now().loom.locked;
    e.commit({locked ? "Lock what follows" : "Unlock what follows",
              [locked](Design d) { return with_lock(std::move(d), locked); }});
  });
  lock.checked = [](const ActionHost& e) { return e.document().now().loom.locked; };
  Action& nearest = add(all, "Draft", "nearest", "ClosestWeave that the loom weaves\xE2\x80\xA6", "",
                        [](ActionHost& e) { e.ask_closest_weave(); });
  nearest.enabled = [](const ActionHost& e) {
    const auto& rejected_edit = e.view().rejected_edit;
    return rejected_edit && rejected_edit->nearest && !rejected_edit->nearest->is_there;
  };
  add(all, "Draft", "larger_loom", "What was painted, on a larger loom", "", [](ActionHost& e) {
    const Edit edit = larger_loom_edit(*e.view().rejected_edit);
    e.commit(edit);
  }).enabled = [](const ActionHost& e) { return e.view().rejected_edit.has_value(); };
}

}  // namespace

void add_draft_actions(Actions& all) {
  add(all, "Draft", "notes", "Title and notes\xE2\x80\xA6", "", [](ActionHost& e) { e.ask_notes(); });
  add(all, "Draft", "weave_over", "Weave over the draft or selection\xE2\x80\xA6", "W",
      [](ActionHost& e) { e.ask_weave(); });
  add(all, "Draft", "sections", "Threads from sections\xE2\x80\xA6", "Shift+W",
      [](ActionHost& e) { e.ask_sections(); });
  add(all, "Draft", "size", "Ends, picks, shafts, loom\xE2\x80\xA6", "", [](ActionHost& e) { e.ask_size(); });
  const auto shed = [&all](const char* id, const char* label, bool rising) {
    Action& a = add(all, "Draft", id, label, "", [rising](ActionHost& e) {
      e.commit(
          {rising ? "Rising shed" : "Sinking shed", [rising](Design d) { return with_rising(std::move(d), rising); }});
    });
    a.checked = [rising](const ActionHost& e) { return e.document().now().draft.rising == rising; };
    return &a;
  };
  shed("rising", "Rising shed", true)->item.group = true;
  shed("sinking", "Sinking shed", false);
  const auto drive = [&all](const char* id, const char* label, ShedControl to) {
    Action& a = add(all, "Draft", id, label, "", [to](ActionHost& e) {
      if (to == ShedControl::kLiftplan) return e.commit({"ShedControl by liftplan", to_liftplan});
      Edit edit{"ShedControl by treadles", [](Design d) {
                  const int most = loom_size(d).treadles;
                  return to_treadling(std::move(d), most);
                }};
      edit.why = [](const Design& d) {
        return "This takes " + std::to_string(treadles_needed(d.draft)) + " treadles, and the loom has " +
               std::to_string(loom_size(d).treadles);
      };
      e.commit(edit);
    });
    a.checked = [to](const ActionHost& e) { return e.document().now().draft.drive == to; };
    a.enabled = [to](const ActionHost& e) { return e.document().now().draft.drive != to; };
    return &a;
  };
  drive("treadling", "ShedControl by tie-up and treadles", ShedControl::kTreadling)->item.group = true;
  drive("liftplan", "ShedControl by liftplan", ShedControl::kLiftplan);
  add(all, "Draft", "skeleton", "Fewer treadles, two feet", "", [](ActionHost& e) {
    Edit edit{"Fewer treadles, two feet", [](Design d) { return to_skeleton(std::move(d), 2); }};
    edit.why = [](const Design&) { return std::string("No fewer treadles do, even with two feet"); };
    e.commit(edit);
  });
  add_rules(all);
  add_thread_actions(all);
  add_loom_actions(all);
}

}  // namespace weftlight::actions
