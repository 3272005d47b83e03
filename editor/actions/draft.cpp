// The draft as a whole: its size, its shed, what drives it.

#include <utility>

#include "actions/action_parts.h"
#include "draft/crossings.h"
#include "draft/edits.h"

namespace weftlight::actions {

namespace {

/// What rules and what follows.
void add_rules(Actions& all) {
  const auto rule = [&all](const char* id, const char* label, Authority authority) {
    Action& a = add(all, "Draft", id, label, "", [label, authority](Desk& e) {
      e.commit({label, [authority](Design d) { return with_authority(std::move(d), authority); }});
    });
    a.checked = [authority](const Desk& e) { return e.document().now().loom.authority == authority; };
    return &a;
  };
  rule("rules.threading", "Threading rules, drawdown follows", Authority::kThreading)->item.group = true;
  rule("rules.liftplan", "Liftplan rules, drawdown follows", Authority::kLiftplan);
  rule("rules.drawdown", "Drawdown rules, threading follows", Authority::kDrawdown);
  Action& lock = add(all, "Draft", "rules.lock", "Lock what follows", "", [](Desk& e) {
    const bool locked = !e.document().now().loom.locked;
    e.commit({locked ? "Lock what follows" : "Unlock what follows",
              [locked](Design d) { return with_lock(std::move(d), locked); }});
  });
  lock.checked = [](const Desk& e) { return e.document().now().loom.locked; };
  Action& nearest =
      add(all, "Draft", "nearest", "Nearest that the loom weaves\xE2\x80\xA6", "", [](Desk& e) { e.ask_nearest(); });
  nearest.enabled = [](const Desk& e) {
    const auto& refusal = e.view().refusal;
    return refusal && refusal->nearest && !refusal->nearest->is_there;
  };
  add(all, "Draft", "larger_loom", "What was painted, on a larger loom", "", [](Desk& e) {
    const Edit edit = larger_loom_edit(*e.view().refusal);
    e.commit(edit);
  }).enabled = [](const Desk& e) { return e.view().refusal.has_value(); };
}

}  // namespace

void add_draft_actions(Actions& all) {
  add(all, "Draft", "notes", "Title and notes\xE2\x80\xA6", "", [](Desk& e) { e.ask_notes(); });
  add(all, "Draft", "weave_over", "Weave over the draft or selection\xE2\x80\xA6", "W", [](Desk& e) { e.ask_weave(); });
  add(all, "Draft", "sections", "Threads from sections\xE2\x80\xA6", "Shift+W", [](Desk& e) { e.ask_sections(); });
  add(all, "Draft", "size", "Ends, picks, shafts, loom\xE2\x80\xA6", "", [](Desk& e) { e.ask_size(); });
  const auto shed = [&all](const char* id, const char* label, bool rising) {
    Action& a = add(all, "Draft", id, label, "", [rising](Desk& e) {
      e.commit(
          {rising ? "Rising shed" : "Sinking shed", [rising](Design d) { return with_rising(std::move(d), rising); }});
    });
    a.checked = [rising](const Desk& e) { return e.document().now().draft.rising == rising; };
    return &a;
  };
  shed("rising", "Rising shed", true)->item.group = true;
  shed("sinking", "Sinking shed", false);
  const auto drive = [&all](const char* id, const char* label, Drive to) {
    Action& a = add(all, "Draft", id, label, "", [to](Desk& e) {
      if (to == Drive::kLiftplan) return e.commit({"Drive by liftplan", to_liftplan});
      Edit edit{"Drive by treadles", [](Design d) {
                  const int most = loom_size(d).treadles;
                  return to_treadling(std::move(d), most);
                }};
      edit.why = [](const Design& d) {
        return "This takes " + std::to_string(treadles_needed(d.draft)) + " treadles, and the loom has " +
               std::to_string(loom_size(d).treadles);
      };
      e.commit(edit);
    });
    a.checked = [to](const Desk& e) { return e.document().now().draft.drive == to; };
    a.enabled = [to](const Desk& e) { return e.document().now().draft.drive != to; };
    return &a;
  };
  drive("treadling", "Drive by tie-up and treadles", Drive::kTreadling)->item.group = true;
  drive("liftplan", "Drive by liftplan", Drive::kLiftplan);
  add(all, "Draft", "skeleton", "Fewer treadles, two feet", "", [](Desk& e) {
    Edit edit{"Fewer treadles, two feet", [](Design d) { return to_skeleton(std::move(d), 2); }};
    edit.why = [](const Design&) { return std::string("No fewer treadles do, even with two feet"); };
    e.commit(edit);
  });
  add_rules(all);
  add_thread_actions(all);
  add_loom_actions(all);
}

}  // namespace weftlight::actions
