// The Draft menu: size, shed, shed control, and what leads.

#include <utility>

#include "actions/action_parts.h"
#include "design/crossings.h"
#include "design/edits.h"
#include "design/loom.h"
#include "design/turned.h"
#include "session/editing/version_edits.h"

namespace weftlight::actions {

using base::fill, base::tr, base::tr_n;
using design::Design, design::Leading, design::loom_size, design::to_liftplan, design::to_skeleton,
    design::to_treadling, design::turned, design::weaves_on_loom, design::with_leading, design::with_lock,
    design::with_rising;
using draft::ShedControl, draft::treadles_needed;
using session::Edit, session::go_to_version_edit, session::larger_loom_edit, session::next_version;

namespace {

/// Which grid leads and which follow.
void add_leading(Actions& all, const ActiveDraft& draft, const DraftDialogs& dialogs) {
  const auto lead = [&all, &draft](const char* id, const char* label, Leading leading) {
    Action& a = add(all, "Draft", id, label, "", [&draft, label, leading] {
      draft.commit({label, [leading](Design d) { return with_leading(std::move(d), leading); }});
    });
    a.checked = [&draft, leading] { return draft.document().now().loom.leading == leading; };
    return &a;
  };
  lead("rules.threading", tr("Threading leads, drawdown follows"), Leading::kThreading)->item.group = true;
  lead("rules.liftplan", tr("Liftplan leads, drawdown follows"), Leading::kLiftplan);
  lead("rules.drawdown", tr("Drawdown leads, threading follows"), Leading::kDrawdown);
  Action& lock = add(all, "Draft", "rules.lock", tr("Lock the grids that follow"), "", [&draft] {
    const bool locked = !draft.document().now().loom.locked;
    draft.commit({locked ? tr("Lock the grids that follow") : tr("Unlock the grids that follow"),
                  [locked](Design d) { return with_lock(std::move(d), locked); }});
  });
  lock.checked = [&draft] { return draft.document().now().loom.locked; };
  Action& closest =
      add(all, "Draft", "closest_weave", tr("Closest weave for this loom\xE2\x80\xA6"), "", dialogs.closest_weave);
  closest.enabled = [&draft] {
    const auto& rejected_edit = draft.view().rejected_edit;
    return rejected_edit && rejected_edit->closest && !rejected_edit->closest->is_there;
  };
  add(all, "Draft", "larger_loom", tr("Add shafts or treadles for the last edit"), "", [&draft] {
    const Edit edit = larger_loom_edit(*draft.view().rejected_edit);
    draft.commit(edit);
  }).enabled = [&draft] { return draft.view().rejected_edit.has_value(); };
}

void add_versions(Actions& all, const ActiveDraft& draft, const DraftDialogs& dialogs) {
  add(all, "Draft", "versions", tr("Versions and colourways\xE2\x80\xA6"), "", dialogs.versions);
  const auto go = [&all, &draft](const char* id, const char* label, int step) {
    add(all, "Draft", id, label, "", [&draft, step] {
      const Design& now = draft.document().now();
      const design::Version* version = next_version(now, step);
      if (const session::MaybeEdit edit = version ? go_to_version_edit(now, *version) : std::nullopt)
        draft.commit(*edit);
    }).enabled = [&draft] { return !draft.document().now().versions.empty(); };
  };
  go("next_version", tr("Next version"), 1);
  go("previous_version", tr("Previous version"), -1);
}

base::Result<Design> skeleton_on_loom(const Design& design, const base::TaskProgress& progress) {
  Design made = to_skeleton(design, 2, progress);
  if (base::Result<void> woven = weaves_on_loom(design, made.draft); !woven) return base::failed(woven);
  return made;
}

}  // namespace

void add_draft_actions(Actions& all, const ActiveDraft& draft, const DraftDialogs& dialogs) {
  add(all, "Draft", "notes", tr("Title and notes\xE2\x80\xA6"), "", dialogs.notes);
  add(all, "Draft", "weave_over", tr("Weave over the draft or selection\xE2\x80\xA6"), "W", dialogs.weave);
  add(all, "Draft", "sections", tr("Build from sections\xE2\x80\xA6"), "Shift+W", dialogs.sections);
  add(all, "Draft", "join", tr("Join with another draft\xE2\x80\xA6"), "", dialogs.join);
  add(all, "Draft", "picture", tr("Weave a picture\xE2\x80\xA6"), "", dialogs.picture);
  add_versions(all, draft, dialogs);
  add(all, "Draft", "size", tr("Size and loom limits\xE2\x80\xA6"), "", dialogs.size);
  add(all, "Draft", "turn", tr("Turn the draft, warp becomes weft"), "", [&draft] {
    draft.compute({tr("Turn the draft, warp becomes weft"), tr("Turning the draft"),
                   [](const Design& d, const base::TaskProgress&) { return turned(d); },
                   tr("Turned, the draft is the same.")});
  });
  const auto shed = [&all, &draft](const char* id, const char* label, bool rising) {
    Action& a = add(all, "Draft", id, label, "", [&draft, rising] {
      draft.commit({rising ? tr("Use a rising shed") : tr("Use a sinking shed"),
                    [rising](Design d) { return with_rising(std::move(d), rising); }});
    });
    a.checked = [&draft, rising] { return draft.document().now().draft.rising == rising; };
    return &a;
  };
  shed("rising", tr("Rising shed"), true)->item.group = true;
  shed("sinking", tr("Sinking shed"), false);
  const auto control = [&all, &draft](const char* id, const char* label, ShedControl to) {
    Action& a = add(all, "Draft", id, label, "", [&draft, to] {
      if (to == ShedControl::kLiftplan) return draft.commit({tr("Use the liftplan"), to_liftplan});
      Edit edit{tr("Use tie-up and treadling"), [](Design d) {
                  const int treadles = loom_size(d).treadles;
                  return to_treadling(std::move(d), treadles);
                }};
      edit.why = [](const Design& d) {
        const int needed = treadles_needed(d.draft);
        return fill(tr_n("This needs {needed} treadle, but the loom has {has}.",
                         "This needs {needed} treadles, but the loom has {has}.", needed),
                    arg("needed", needed), arg("has", loom_size(d).treadles));
      };
      draft.commit(edit);
    });
    a.checked = [&draft, to] { return draft.document().now().draft.shed_control == to; };
    a.enabled = [&draft, to] { return draft.document().now().draft.shed_control != to; };
    return &a;
  };
  control("treadling", tr("Tie-up and treadling"), ShedControl::kTreadling)->item.group = true;
  control("liftplan", tr("Use the liftplan"), ShedControl::kLiftplan);
  add(all, "Draft", "skeleton", tr("Skeleton tie-up, two treadles a pick"), "", [&draft] {
    draft.compute({tr("Skeleton tie-up, two treadles a pick"), tr("Searching for a skeleton tie-up"), skeleton_on_loom,
                   tr("No skeleton tie-up needs fewer treadles.")});
  });
  add_leading(all, draft, dialogs);
}

}  // namespace weftlight::actions
