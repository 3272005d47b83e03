// Every row of the table, run without a window in every state: what changes the design is undone and redone exactly,
// and what is no edit changes nothing.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "../straight_draft.h"
#include "bare_editor.h"
#include "design/crossings.h"
#include "design/edits.h"
#include "design/loom.h"
#include "design/thread_text.h"
#include "design/versions.h"
#include "draft/block_text.h"
#include "draft/factor.h"
#include "platform/missing_font.h"
#include "session/editing/follow_document.h"
#include "session/editing/selection_state.h"
#include "session/editing/typing.h"

namespace weftlight::actions {

using design::Design, design::Leading, design::Yarn, design::color_text, design::is_consistent, design::loom_size,
    design::with_leading, design::with_lock, design::with_new_yarn, design::with_rising, design::with_thread_spacing,
    design::with_thread_thickness, design::with_version;
using draft::BitGrid, draft::BitMatrix, draft::CellBlock, draft::Draft, draft::Selection, draft::ShedControl,
    draft::System, draft::blank_draft, draft::block_text, draft::clipped, draft::closest_drawdown, draft::drawdown,
    draft::kMaxShafts;
using session::OtherDraft, session::RejectedEdit, session::closest_weave_to, session::follow_document,
    session::hold_block, session::hold_block_over, session::is_shown, session::keep_view_edit, session::select_cells;

namespace {

/// All that a draft can have, so that nothing of it can be forgotten by an edit unseen.
Design rich_design() {
  Design d;
  d.draft = blank_draft(24, 20, 8, 8);
  for (int i = 0; i < 24; ++i) d.draft.threading.set(i, i % 14 < 8 ? i % 14 : 14 - i % 14, true);
  for (int i = 0; i < 20; ++i) d.draft.treadling.set(i, i % 8, true);
  for (int t = 0; t < 8; ++t)
    for (const int s : {t, (t + 1) % 8, (t + 3) % 8}) d.draft.tieup.set(t, s, true);
  d.draft.palette = {{1, 1, 1}, {0.1f, 0.2f, 0.5f}, {0.8f, 0.3f, 0.1f}};
  for (size_t i = 0; i < 24; ++i) d.draft.warp.color[i] = static_cast<int>(i * i % 3);
  for (size_t i = 0; i < 20; ++i) d.draft.weft.color[i] = static_cast<int>(i / 4 % 3);
  d = with_new_yarn(std::move(d), Yarn{});
  for (const int end : {2, 3, 11}) d = with_thread_thickness(std::move(d), System::kWarp, end, 0.1f * (end + 3));
  for (const int pick : {1, 8}) d = with_thread_spacing(std::move(d), System::kWeft, pick, 1.25f);
  d.title = "All of it";
  d.loom = {Leading::kThreading, false, 8, 10, 3};
  d = with_version(std::move(d), "In blue");
  d.draft.palette[1] = {0.1f, 0.4f, 0.2f};
  return with_version(std::move(d), "In green");
}

/// Twelve picks that lift four shafts alone and together: six treadles do with two feet.
Design two_footed() {
  Design d = rich_design();
  d.draft = blank_draft(16, 12, 4, 6);
  for (int i = 0; i < 16; ++i) d.draft.threading.set(i, i % 4, true);
  d.draft.shed_control = ShedControl::kLiftplan;
  d.draft.liftplan = BitMatrix(12, 4);
  constexpr unsigned kLifts[] = {1, 2, 4, 8, 3, 5, 9, 6, 10, 12, 1, 2};
  for (int pick = 0; pick < 12; ++pick)
    for (int s = 0; s < 4; ++s) d.draft.liftplan.set(pick, s, (kLifts[pick] >> s & 1) != 0);
  d.loom = {Leading::kLiftplan, false, 4, 12, 0};
  return d;
}

struct Stage {
  std::string name;
  std::function<Design()> design;
  std::function<void(BareEditor&)> prepare;
};

using Prepare = std::function<void(BareEditor&)>;

void select(BareEditor& editor, const Selection& s) {
  const Draft& draft = editor.document().now().draft;
  if (is_shown(draft, s.grid)) select_cells(editor.view().select, clipped(s, draft));
}

CellBlock small_block() {
  BitMatrix cells(3, 4);
  for (int i = 0; i < 3; ++i) cells.set(i, i, true), cells.set(i, 3, i == 1);
  return {BitGrid::kDrawdown, cells};
}

/// A crossing that the loom cannot weave without another shaft.
void refuse(BareEditor& editor) {
  Design requested = editor.document().now();
  requested.loom.shafts = requested.loom.treadles = kMaxShafts;
  BitMatrix cells = drawdown(requested.draft);
  for (int i = 0; i < std::min({10, cells.rows(), cells.cols()}); ++i) cells.set(i, i, !cells.get(i, i));
  requested.draft = closest_drawdown(requested.draft, cells, loom_size(requested)).draft;
  editor.view().rejected_edit = RejectedEdit{0, std::make_shared<const Design>(requested)};
  editor.view().rejected_edit->closest = closest_weave_to(editor.document().now(), requested);
}

std::vector<std::pair<std::string, Prepare>> preparations() {
  const auto selection = [](BitGrid grid, int a0, int a1, int b0, int b1) {
    return [=](BareEditor& d) { select(d, {grid, a0, a1, b0, b1}); };
  };
  return {
      {"nothing", [](BareEditor&) {}},
      {"threading selected", selection(BitGrid::kThreading, 2, 7, 0, 4)},
      {"whole ends selected", selection(BitGrid::kThreading, 4, 9, 0, 99)},
      {"tie-up selected", selection(BitGrid::kTieup, 1, 3, 1, 4)},
      {"treadling selected", selection(BitGrid::kTreadling, 0, 5, 3, 6)},
      {"liftplan selected", selection(BitGrid::kLiftplan, 0, 3, 2, 7)},
      {"crossings selected", selection(BitGrid::kDrawdown, 3, 8, 2, 6)},
      {"block in hand",
       [](BareEditor& d) {
         hold_block(d.view().select, d.document().now().draft, small_block(), false);
         hold_block_over(d.view().select, BitGrid::kThreading, {1, 1});
       }},
      {"ends chosen",
       [](BareEditor& d) {
         d.view().chosen = {System::kWarp, {2, 3, 11}, 3, {}, false, false};
       }},
      {"picks chosen",
       [](BareEditor& d) {
         d.view().chosen = {System::kWeft, {1, 4}, 1, {}, false, false};
       }},
      {"cells on the clipboard", [](BareEditor& d) { d.set_clipboard(block_text(small_block())); }},
      {"colours on the clipboard",
       [](BareEditor& d) {
         d.set_clipboard(color_text(d.document().now().draft, System::kWarp, std::vector<int>{1, 2, 4}));
       }},
      {"thickness on the clipboard", [](BareEditor& d) { d.set_clipboard("weftlight thickness: 0.5 - 0.8"); }},
      {"at the loom", [](BareEditor& d) { d.view().at_loom.open = true; }},
      {"refused", refuse},
      {"held against another",
       [](BareEditor& d) {
         d.view().differences.other = std::make_shared<OtherDraft>(OtherDraft{"other.wif", {}, {}});
       }},
      {"after two steps, one taken back",
       [](BareEditor& d) {
         d.commit({"Title", [](Design x) { return x.title = "Other", x; }});
         d.commit({"Notes", [](Design x) { return x.title = "Third", x; }});
         d.undo();
       }},
      {"seen otherwise, views kept",
       [](BareEditor& d) {
         d.commit(keep_view_edit(d.view().cloth, "Near"));
         d.view().cloth.camera.distance *= 2;
         d.commit({"Lights", [](Design x) { return x.scene.lights = "overcast", x; }});
       }},
  };
}

std::vector<Stage> stages() {
  const auto ruled_by = [](Leading leading) {
    return [leading] {
      Design d = rich_design();
      d.loom.shafts = d.loom.treadles = 20;
      return with_leading(std::move(d), leading);
    };
  };
  const std::vector<std::pair<std::string, std::function<Design()>>> designs = {
      {"threading rules", rich_design},
      {"liftplan rules", ruled_by(Leading::kLiftplan)},
      {"drawdown rules", ruled_by(Leading::kDrawdown)},
      {"locked, sinking", [] { return with_lock(with_rising(rich_design(), false), true); }},
      {"for two feet", two_footed},
      {"one end, one pick",
       [] {
         Design d;
         d.draft = blank_draft(1, 1, 1, 1);
         return d;
       }},
  };
  std::vector<Stage> all;
  for (const auto& [of, design] : designs)
    for (const auto& [name, prepare] : preparations()) all.push_back({of + ", " + name, design, prepare});
  return all;
}

/// What changes the design in one state or another; all else changes it in none. Undo and redo walk along its history.
const std::set<std::string> kEdits = {"advance_down",
                                      "advance_up",
                                      "clear",
                                      "colors.sort_hue",
                                      "colors.sort_lightness",
                                      "colors.swap_lightness",
                                      "colors.swap_systems",
                                      "cut",
                                      "delete_threads",
                                      "double_mirrored",
                                      "double_threads",
                                      "drape.*",
                                      "drop",
                                      "half_turn",
                                      "insert_threads",
                                      "invert",
                                      "larger_loom",
                                      "liftplan",
                                      "lights.*",
                                      "loom_back",
                                      "loom_next",
                                      "mirror_across",
                                      "mirror_down",
                                      "move_down",
                                      "move_left",
                                      "move_right",
                                      "move_up",
                                      "next_version",
                                      "point_end",
                                      "previous_version",
                                      "quarter_turn",
                                      "redo",
                                      "repeat_all",
                                      "repeat_end",
                                      "reverse_threads",
                                      "rising",
                                      "rules.drawdown",
                                      "rules.liftplan",
                                      "rules.lock",
                                      "rules.threading",
                                      "shift_down",
                                      "shift_left",
                                      "shift_right",
                                      "shift_up",
                                      "sinking",
                                      "skeleton",
                                      "threads.from_yarn",
                                      "threads.paste_looks",
                                      "threads.warp_as_weft",
                                      "threads.warp_thick_as_weft",
                                      "threads.weft_as_warp",
                                      "threads.weft_thick_as_warp",
                                      "treadling",
                                      "turn",
                                      "undo",
                                      "view.*",
                                      "view_keep_as",
                                      "views_change",
                                      "yarns.merge",
                                      "yarns.remove_unused"};

/// What has a row for each drape, light or view.
std::string kind_of(const std::string& id) {
  for (const char* kind : {"drape.", "lights.", "view."})
    if (id.starts_with(kind)) return kind + std::string("*");
  return id;
}

std::vector<Action> whole_table(const BareEditor& editor) {
  return make_actions(editor.subjects(), {"/drafts/one.wif"}, {}, {"Near"});
}

/// Runs it in the state; true when it changed the design, which is then taken back and brought again.
bool changes(BareEditor& editor, const Action& action, const Stage& stage) {
  editor.begin(stage.design());
  stage.prepare(editor);
  follow_document(editor.view(), editor.document());
  const auto before = editor.document().snapshot();
  // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): a copy shows whether the original was written to.
  const Design value = *before;
  const size_t first_step = editor.document().history().position();
  if (action.enabled && !action.enabled()) return false;
  if (action.label) {
    EXPECT_FALSE(action.label().empty());
  }
  const auto run = action.run;
  run();
  follow_document(editor.view(), editor.document());
  EXPECT_EQ(*before, value) << "a design that stands in the history is never written to";
  const auto after = editor.document().snapshot();
  EXPECT_TRUE(is_consistent(*after));
  EXPECT_EQ(editor.document().cells(), drawdown(after->draft));
  if (*after == *before) return false;
  if (action.item.id == "undo" || action.item.id == "redo") return true;

  EXPECT_FALSE(editor.document().is_saved());
  Design elsewhere = *after;
  elsewhere.loom = design::with_place_of(before->loom, after->loom);
  if (elsewhere == *before) {
    EXPECT_EQ(editor.document().history().position(), first_step) << "the place at the loom is no step";
    return true;
  }
  EXPECT_FALSE(editor.document().history().undo_label().empty()) << "the step has a name";
  const Design& edited = *after;
  editor.undo();
  EXPECT_EQ(editor.document().now(), value) << "after undo";
  EXPECT_EQ(editor.document().cells(), drawdown(value.draft)) << "after undo";
  editor.redo();
  EXPECT_EQ(editor.document().now(), edited) << "after redo";
  EXPECT_EQ(editor.document().cells(), drawdown(edited.draft)) << "after redo";
  follow_document(editor.view(), editor.document());

  // Twice more: some join the step before, and all of them are taken back.
  const size_t steps = editor.document().history().position();
  for (int i = 0; i < 2; ++i)
    if (!action.enabled || action.enabled()) run(), follow_document(editor.view(), editor.document());
  EXPECT_LE(editor.document().history().position(), steps + 2);
  EXPECT_EQ(*before, value) << "a design that stands in the history is never written to";
  editor.go_to_step(steps);
  editor.undo();
  EXPECT_EQ(editor.document().now(), value) << "after all of three are taken back";
  return true;
}

TEST(EveryAction, StartsFromConsistentDesigns) {
  for (const Stage& stage : stages()) {
    ASSERT_TRUE(is_consistent(stage.design())) << stage.name;
    BareEditor editor(stage.design());
    stage.prepare(editor);
    ASSERT_TRUE(is_consistent(editor.document().now())) << stage.name;
  }
}

TEST(EveryAction, IsUndoneAndRedoneExactly) {
  BareEditor editor(rich_design());
  const std::vector<Stage> all = stages();
  std::set<std::string> edits;
  for (const Action& action : whole_table(editor))
    for (const Stage& stage : all) {
      SCOPED_TRACE(action.item.id + ": " + stage.name);
      if (changes(editor, action, stage)) edits.insert(kind_of(action.item.id));
      if (testing::Test::HasFailure()) return;
    }
  EXPECT_EQ(edits, kEdits) << "rows that change the design, in a state or another";
}

TEST(EveryAction, ASkeletonTieupHasNoMoreTreadlesThanTheLoom) {
  Design lifted = design::to_liftplan(straight_draft(8));  // its shafts, lifted one by one, take eight treadles
  Draft& d = lifted.draft;
  d.treadles = 2;
  d.tieup.resize(d.treadles, d.shafts);
  d.treadling.resize(d.picks(), d.treadles);
  for (const int has : {6, 8}) {
    lifted.loom.treadles = has;
    BareEditor editor(lifted);
    const std::vector<Action> all = whole_table(editor);
    std::ranges::find(all, "skeleton", [](const Action& action) { return action.item.id; })->run();
    EXPECT_EQ(editor.document().now().draft.treadles, has < 8 ? 2 : 8);
  }
}

TEST(EveryAction, ANumberThatIsTypedIsKeptWhenTheToolChanges) {
  Design design;
  design.draft = blank_draft(8, 8, 16, 16);
  for (const char* tool : {"tool_paint", "tool_type", "tool_select"}) {
    BareEditor editor(design);
    const std::vector<Action> all = whole_table(editor);
    const auto run = [&all](const char* id) {
      std::ranges::find(all, id, [](const Action& action) { return action.item.id; })->run();
    };
    run("tool_type");
    session::type_key(editor.view(), editor.document().now(), {}, "1", 0);
    ASSERT_TRUE(session::waits_until(editor.view())) << "it could become 10 to 16";
    run(tool);
    EXPECT_EQ(editor.document().now().draft.threading.first(0), 0) << tool;
    EXPECT_FALSE(session::waits_until(editor.view())) << tool;
  }
}

TEST(EveryAction, IsEnabledInSomeState) {
  BareEditor editor(rich_design());
  // Other tabs, files, and what crashed sessions left.
  std::set<std::string> needs_the_window = {"close_others", "close_right", "copy_path", "drape.again",   "next_tab",
                                            "previous_tab", "recovery",    "reload",    "show_in_folder"};
  if (!platform::missing_font("ja").empty()) needs_the_window.insert("language.ja");
  const std::vector<Stage> all = stages();
  std::set<std::string> never;
  for (const Action& action : whole_table(editor)) {
    bool can = !action.enabled;
    for (size_t i = 0; i < all.size() && !can; ++i) {
      editor.begin(all[i].design());
      all[i].prepare(editor);
      can = action.enabled();
    }
    if (!can) never.insert(action.item.id);
  }
  EXPECT_EQ(never, needs_the_window);
}

TEST(EveryAction, HasItsOwnIdAndShortcut) {
  BareEditor editor(rich_design());
  std::map<std::string, std::string> keys;
  std::set<std::string> ids;
  for (const Action& a : whole_table(editor)) {
    EXPECT_TRUE(ids.insert(a.item.id).second) << a.item.id;
    EXPECT_FALSE(a.item.label.empty()) << a.item.id;
    if (!a.item.shortcut.empty()) {
      EXPECT_TRUE(keys.emplace(a.item.shortcut, a.item.id).second)
          << a.item.shortcut << " of " << a.item.id << " and " << keys[a.item.shortcut];
    }
  }
}

}  // namespace
}  // namespace weftlight::actions
