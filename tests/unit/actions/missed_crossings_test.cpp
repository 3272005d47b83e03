// What the actions on a selection say of crossings that could not follow.

#include <gtest/gtest.h>

#include <algorithm>

#include "../hand_drafts.h"
#include "bare_editor.h"
#include "session/editing/selection_state.h"

namespace weftlight::actions {

using design::straight_twill;
using draft::BitGrid;
using session::select_cells;

namespace {

/// What the window refuses after the action on the first crossings of pick 1, of which the third is down.
std::string refused_after(const char* id, Design design, int ends) {
  BareEditor editor(std::move(design));
  const std::vector<Action> all = make_actions(editor.subjects(), {});
  select_cells(editor.view().select, {BitGrid::kDrawdown, 0, ends, 0, 1});
  std::ranges::find(all, std::string(id), [](const Action& action) { return action.item.id; })->run();
  return editor.refused();
}

TEST(MissedCrossings, OfARepeatAreTold) {
  for (const char* id : {"repeat_end", "repeat_all"}) {
    const std::string said = refused_after(id, straight_twill(8, 6), 3);
    EXPECT_NE(said.find(" crossings could not follow, because ends on the same shafts rise together"),
              std::string::npos)
        << id << ": " << said;
  }
}

// A pick that lifts one shaft would take a fifth treadle.
TEST(MissedCrossings, OfALoomWithoutAnotherTreadleAreTold) {
  Design d = straight_twill(8, 6);
  d.loom.shafts = d.loom.treadles = 4;
  for (const char* id : {"clear", "cut"}) {
    const std::string said = refused_after(id, d, 1);
    EXPECT_NE(said.find("1 crossing could not follow"), std::string::npos) << id << ": " << said;
  }
}

TEST(MissedCrossings, AreNoneWhereAllFollow) {
  EXPECT_EQ(refused_after("clear", straight_twill(8, 6), 1), "");
  Design locked = straight_twill(8, 6);
  locked.loom.locked = true;
  EXPECT_EQ(refused_after("repeat_end", locked, 3), "") << "the lock has its own reason";
}

}  // namespace
}  // namespace weftlight::actions
