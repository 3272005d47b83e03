// The draft as a whole: its size, its shed, what drives it.

#include <utility>

#include "actions/action_parts.h"
#include "draft/edits.h"

namespace weftlight::actions {

void add_draft_actions(Actions& all) {
  add(all, "Draft", "notes", "Title and notes\xE2\x80\xA6", "", [](Desk& e) { e.ask_notes(); });
  add(all, "Draft", "size", "Ends, picks, shafts\xE2\x80\xA6", "", [](Desk& e) { e.ask_size(); });
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
      e.commit(to == Drive::kLiftplan ? Edit{"Drive by liftplan", to_liftplan}
                                      : Edit{"Drive by treadles", to_treadling});
    });
    a.checked = [to](const Desk& e) { return e.document().now().draft.drive == to; };
    a.enabled = [to](const Desk& e) { return e.document().now().draft.drive != to; };
    return &a;
  };
  drive("treadling", "Drive by tie-up and treadles", Drive::kTreadling)->item.group = true;
  drive("liftplan", "Drive by liftplan", Drive::kLiftplan);
  add_thread_actions(all);
}

}  // namespace weftlight::actions
