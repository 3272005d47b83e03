// The window as a weaver uses it: paint, undo, save, open again, with real mouse and keyboard events.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "../program.h"
#include "design/fibre.h"
#include "draft/drawdown.h"
#include "on_display.h"

namespace weftlight::gui {

using design::CrossSection, design::Design, design::Yarn, design::with_cross_section, design::with_threading;
using draft::Draft, draft::Threads, draft::blank_draft, draft::kFromYarn;
using wif::write_new_wif;
namespace {

namespace fs = std::filesystem;

/// A 2/2 twill on four shafts, two colours, on a flat cloth; a section of another program at the end.
std::string twill() {
  Design d;
  d.draft = blank_draft(16, 16, 4, 4);
  d.draft.palette = {{0.1f, 0.2f, 0.5f}, {0.95f, 0.9f, 0.8f}};
  for (int i = 0; i < 16; ++i) {
    d.draft.threading.set(i, i % 4, true);
    d.draft.treadling.set(i, i % 4, true);
    d.draft.tieup.set(i % 4, i % 4, true);
    d.draft.tieup.set(i % 4, (i + 1) % 4, true);
  }
  d.scene.mesh = "plane";
  return write_new_wif(d) + "[PRIVATE ANOTHER PROGRAM]\nKept=as it is\n";
}

constexpr double kSameCloth = 0.01;  // RMSE: 0.003 for one pass less, 0.042 for an edit

class WindowTest : public OnDisplay {
 protected:
  void SetUp() override {
    OnDisplay::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    draft_ = folder_ / "twill.wif";
    put(draft_, twill());
  }

  std::string drawdown_of(const fs::path& wif) const {
    const fs::path out = folder_ / "drawdown.txt";
    const std::string command = tested_program() + " drawdown " + wif.string() + " -o " + out.string();
    EXPECT_EQ(std::system(command.c_str()), 0);
    return bytes_of(out);
  }

  /// Opens a section of the yarns' page and closes the one above, so that all of it is visible; waits for a control in
  /// it.
  void open_below_yarns(const Window& w, const char* section, const char* control) {
    display_.click(w.middle_of("inspector:Yarns"));
    ASSERT_TRUE(comes_true([&] { return w.has(section); }));
    const double high = w.place_of(section).first.y;
    display_.click(w.middle_of("section.yarns"));
    ASSERT_TRUE(comes_true([&] { return w.place_of(section).first.y < high; }));
    display_.click(w.middle_of(section));
    ASSERT_TRUE(comes_true([&] { return w.has(control); }));
  }

  void quit(Window& w) {
    display_.key("ctrl+q");
    EXPECT_EQ(w.process().wait(), 0);
  }
};

TEST_F(WindowTest, PaintsUndoesSavesAndOpensAgain) {
  show_cloth();
  const std::string original = bytes_of(draft_);
  const Design before = design_of(original);
  std::string saved;
  {
    Window w(display_, folder_, draft_);
    ASSERT_TRUE(comes_true([&] { return is_settled(w); })) << "the window did not come up with its cloth";
    EXPECT_EQ(w.live(), original) << "an untouched draft is exported byte for byte";
    const std::string cloth = still_picture(w);

    // End 3 was on shaft 3 and goes to shaft 1.
    display_.click(w.cell("threading", 3, 1));
    ASSERT_TRUE(comes_true([&] { return w.live() != original; })) << "the click painted nothing";
    const Design painted = design_of(w.live());
    EXPECT_EQ(painted.draft, with_threading(before, 2, 0, true).draft);
    EXPECT_EQ(painted.draft.threading.first(2), 0);
    EXPECT_NE(drawdown_of(folder_ / "live.wif"), drawdown_of(draft_));
    EXPECT_EQ(bytes_of(draft_), original) << "nothing is saved without a command";
    EXPECT_TRUE(comes_true([&] { return apart(still_picture(w), cloth) > kSameCloth; }))
        << "the cloth did not follow the edit";

    display_.key("ctrl+z");
    EXPECT_TRUE(comes_true([&] { return w.live() == original; })) << "undo did not bring the draft back";
    EXPECT_TRUE(comes_true([&] { return apart(still_picture(w), cloth) < kSameCloth; }))
        << "undo did not bring the cloth back";

    display_.key("ctrl+shift+z");
    ASSERT_TRUE(comes_true([&] { return w.live() != original; }));
    display_.key("ctrl+s");
    ASSERT_TRUE(comes_true([&] { return bytes_of(draft_) != original; })) << "Ctrl+S wrote nothing";
    saved = bytes_of(draft_);
    EXPECT_EQ(saved, w.live());
    EXPECT_NE(saved.find("[PRIVATE ANOTHER PROGRAM]\nKept=as it is\n"), std::string::npos);
    quit(w);
  }
  Window again(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return again.is_ready(); }));
  EXPECT_EQ(again.live(), saved);
  EXPECT_EQ(design_of(saved).draft, with_threading(before, 2, 0, true).draft);
  quit(again);
}

TEST_F(WindowTest, OneDragIsOneStepOnEveryGrid) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string original = w.live();
  const auto undone = [&](const char* what) {
    display_.key("ctrl+z");
    EXPECT_TRUE(comes_true([&] { return w.live() == original; })) << what << ": one undo did not undo the drag";
  };

  display_.drag({w.cell("threading", 5, 4), w.cell("threading", 8, 4)});
  EXPECT_TRUE(comes_true([&] {
    const Draft d = design_of(w.live()).draft;
    return d.threading.first(4) == 3 && d.threading.first(5) == 3 && d.threading.first(6) == 3 &&
           d.threading.first(7) == 3;
  })) << "the drag skipped a cell";
  undone("threading");

  display_.click(w.cell("tieup", 1, 4));
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft.tieup.get(0, 3); }));
  undone("tieup");

  display_.drag({w.cell("treadling", 2, 9), w.cell("treadling", 2, 11)});
  EXPECT_TRUE(comes_true([&] {
    const Draft d = design_of(w.live()).draft;
    return d.treadling.first(8) == 1 && d.treadling.first(9) == 1 && d.treadling.first(10) == 1;
  }));
  undone("treadling");

  display_.click(w.middle_of("palette:2"));
  display_.drag({w.cell("warp_colors", 1, 1), w.cell("warp_colors", 4, 1)});
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft.warp.color[3] == 1; }));
  undone("warp colours");

  display_.click(w.middle_of("inspector:Yarns"));
  ASSERT_TRUE(comes_true([&] { return w.has("yarn.turns_per_m"); }));
  display_.click(w.middle_of("yarn.turns_per_m"));
  EXPECT_TRUE(
      comes_true([&] { return design_of(w.live()).yarns[0].turns_per_m != design_of(original).yarns[0].turns_per_m; }));
  undone("yarn twist");
  quit(w);
}

TEST_F(WindowTest, SelectsCopiesPastesAndUndoes) {
  const std::string original = bytes_of(draft_);
  const Design before = design_of(original);
  std::string saved;
  {
    Window w(display_, folder_, draft_);
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    const auto becomes = [&](const Draft& expected, const char* what) {
      EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft == expected; })) << what;
    };
    display_.click(w.middle_of("tool:Select"));
    display_.drag({w.cell("threading", 1, 1), w.cell("threading", 3, 3), w.cell("threading", 4, 4)});
    EXPECT_EQ(w.live(), original) << "selecting is no edit";
    display_.key("ctrl+c");
    display_.key("ctrl+v");
    display_.click(w.cell("threading", 6, 1));
    Draft pasted = before.draft;
    for (int end = 5; end < 9; ++end) {
      pasted.threading.set(end, end % 4, false);
      pasted.threading.set(end, end - 5, true);
    }
    becomes(pasted, "ends 6 to 9 should be threaded as 1 to 4 are");

    display_.key("ctrl+s");
    ASSERT_TRUE(comes_true([&] { return bytes_of(draft_) != original; })) << "Ctrl+S wrote nothing";
    saved = bytes_of(draft_);
    const std::string repeat = "1100111001001100\n0110001101100110\n0011000110110011\n1001110010011001\n";
    EXPECT_EQ(drawdown_of(draft_), repeat + repeat + repeat + repeat);

    display_.key("shift+h");
    Draft mirrored = pasted;
    for (int end = 5; end < 9; ++end) {
      mirrored.threading.set(end, end - 5, false);
      mirrored.threading.set(end, 8 - end, true);
    }
    becomes(mirrored, "the pasted ends should be mirrored");
    const double tieup_x = w.cell("tieup", 1, 1).x;
    display_.key("ctrl+Delete");
    EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft.ends() == 12; }))
        << "the four selected ends should go";
    ASSERT_TRUE(comes_true([&] { return w.cell("tieup", 1, 1).x != tieup_x; })) << "a narrower draft moves its tie-up";
    display_.drag({w.cell("tieup", 1, 1), w.cell("tieup", 2, 2)});
    display_.drag({w.cell("tieup", 1, 1), w.cell("tieup", 2, 2), w.cell("tieup", 3, 3)});
    EXPECT_TRUE(comes_true([&] {
      return design_of(w.live()).draft.tieup.get(2, 3) && !design_of(w.live()).draft.tieup.get(0, 0);
    })) << "the drag should move the ties";
    for (int i = 0; i < 4; ++i) display_.key("ctrl+z");
    EXPECT_TRUE(comes_true([&] { return w.live() == original; })) << "four steps should be four undos, to the byte";
    display_.key("ctrl+shift+z");
    EXPECT_TRUE(comes_true([&] { return w.live() == saved; }));
    quit(w);
  }
  Window again(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return again.is_ready(); }));
  EXPECT_EQ(again.live(), saved);
  quit(again);
}

TEST_F(WindowTest, ComparesWithTheRayTracedThreads) {
  show_cloth();
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return is_settled(w); }));
  const std::string alone = still_picture(w);
  display_.key("F7");
  ASSERT_TRUE(comes_true([&] { return w.has("view.reference"); })) << "nothing was traced";
  const auto [pane, size] = w.place_of("view");
  const auto half = [&, pane = pane, size = size](double left, double right) {
    return display_.picture({pane.x + left * size.x, pane.y + 90}, {(right - left) * size.x, size.y - 170});
  };
  const auto [buttons, buttons_size] = w.place_of("views");
  EXPECT_GE(w.place_of("view.comparison").first.y, buttons.y + buttons_size.y) << "its note lies under the buttons";
  const std::string quarter = half(0.3, 0.45);
  display_.drag({w.middle_of("view.compare"), {pane.x + 0.25 * size.x, pane.y + 0.5 * size.y}});
  EXPECT_TRUE(comes_true([&, pane = pane, size = size] {
    return w.middle_of("view.compare").x < pane.x + 0.3 * size.x;
  })) << "the slider did not move";
  EXPECT_TRUE(comes_true([&] { return half(0.3, 0.45) != quarter; })) << "the traced threads did not follow the slider";
  display_.key("F7");
  EXPECT_TRUE(comes_true([&] { return !w.has("view.compare") && apart(still_picture(w), alone) < kSameCloth; }))
      << "the preview does not fill the pane again";
  quit(w);
}

TEST_F(WindowTest, ACrossSectionIsChosenByItsName) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string original = w.live();
  const Yarn before = design_of(original).yarns[0];
  display_.click(w.middle_of("inspector:Yarns"));
  ASSERT_TRUE(comes_true([&] { return w.has("yarn.section"); }));
  display_.click(w.middle_of("yarn.section"));
  ASSERT_TRUE(comes_true([&] { return w.has("yarn.section:Flat film"); }));
  display_.click(w.middle_of("yarn.section:Flat film"));
  ASSERT_TRUE(comes_true([&] { return w.live() != original; }));
  EXPECT_EQ(design_of(w.live()).yarns[0], with_cross_section(before, CrossSection::kFlat)) << "as saved in the file";
  display_.key("ctrl+z");
  EXPECT_TRUE(comes_true([&] { return w.live() == original; }));
  quit(w);
}

TEST_F(WindowTest, AYarnIsDyedAlongItsLength) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string original = w.live();
  open_below_yarns(w, "section.dye", "dye.add");
  if (HasFatalFailure()) return;
  const Point corner = w.cell("drawdown", 16, 1), opposite = w.cell("drawdown", 1, 16);
  const auto drawdown = [&] {
    return display_.picture({std::min(corner.x, opposite.x), std::min(corner.y, opposite.y)},
                            {std::abs(corner.x - opposite.x), std::abs(corner.y - opposite.y)});
  };
  const auto before = drawdown();
  display_.click(w.middle_of("dye.add"));
  ASSERT_TRUE(comes_true([&] { return w.live() != original; }));
  const auto stretches = [&] { return design_of(w.live()).yarns[0].dye.stretches; };
  ASSERT_EQ(stretches().size(), 2u) << "the thread's own colour, and another";
  EXPECT_FALSE(stretches()[0].color);
  EXPECT_TRUE(comes_true([&] { return drawdown() != before; })) << "the drawdown has the colours";
  ASSERT_TRUE(comes_true([&] { return w.has("dye:1.fades"); }));
  display_.click(w.middle_of("dye:1.fades"));
  EXPECT_TRUE(comes_true([&] { return stretches()[0].fades; }));
  display_.click(w.middle_of("dye:2.remove"));
  EXPECT_TRUE(comes_true([&] { return stretches().size() == 1; }));
  for (int i = 0; i < 3; ++i) display_.key("ctrl+z");
  EXPECT_TRUE(comes_true([&] { return w.live() == original; }));
  quit(w);
}

// It takes a minute, in which the weaver goes on; here it is cancelled.
TEST_F(WindowTest, FibresAreTracedBesideTheWindow) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string original = w.live();
  open_below_yarns(w, "section.lobes", "yarn.optics_from_fibres");
  if (HasFatalFailure()) return;
  display_.click(w.middle_of("yarn.optics_from_fibres"));
  ASSERT_TRUE(comes_true([&] { return w.has("task.cancel"); }));
  const Point paint = w.cell("threading", 1, 1);
  display_.click(paint);
  EXPECT_TRUE(comes_true([&] { return w.live() != original; })) << "painting goes on";
  display_.key("ctrl+z");
  EXPECT_TRUE(comes_true([&] { return w.live() == original; }));
  display_.click(w.middle_of("task.cancel"));
  EXPECT_TRUE(comes_true([&] { return !w.has("task.cancel"); }));
  EXPECT_EQ(w.live(), original);
  quit(w);
}

TEST_F(WindowTest, TheLobesFollowTheirSlider) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string original = w.live();
  open_below_yarns(w, "section.lobes", "yarn.specular");
  if (HasFatalFailure()) return;
  const auto seen = [&](const char* control) {
    const auto [place, size] = w.place_of(control);
    return display_.picture(place, size);
  };
  const std::string plot = seen("yarn.lobes"), strip = seen("yarn.strip");
  const auto [place, size] = w.place_of("yarn.specular");
  display_.click({place.x + 0.2 * size.x, place.y + size.y / 2});
  ASSERT_TRUE(comes_true([&] { return w.live() != original; }));
  EXPECT_TRUE(comes_true([&] { return seen("yarn.lobes") != plot && seen("yarn.strip") != strip; }));
  const std::string before = w.live(), after = seen("yarn.strip");
  const auto [at, wide] = w.place_of("yarn.lobes");
  display_.drag({{at.x + 0.6 * wide.x, at.y + 0.4 * wide.y}, {at.x + 0.2 * wide.x, at.y + 0.4 * wide.y}});
  EXPECT_TRUE(comes_true([&] { return seen("yarn.strip") != after; })) << "the thread did not follow the light";
  EXPECT_EQ(w.live(), before) << "the plot's light is not part of the design";
  display_.key("ctrl+z");
  EXPECT_TRUE(comes_true([&] { return w.live() == original; }));
  quit(w);
}

TEST_F(WindowTest, StartsADraftFromAWeave) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:herringbone"); }));
  display_.click(w.middle_of("weave:herringbone"));
  ASSERT_TRUE(comes_true([&] { return w.has("weave.band"); }));
  display_.click(w.middle_of("dialog:Create"));
  ASSERT_TRUE(comes_true([&] { return !w.has("dialog:Create"); }));
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft.warp.size() == 16 && w.live() != bytes_of(draft_); }));
  EXPECT_NE(drawdown_of(folder_ / "live.wif"), drawdown_of(draft_));
  display_.key("ctrl+q");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Do not save"); })) << "a new draft is work";
  display_.click(w.middle_of("dialog:Do not save"));
  EXPECT_EQ(w.process().wait(), 0);
}

TEST_F(WindowTest, TheThicknessOfSelectedEndsIsSaved) {
  // Written by another program, in inches; only the lines of the selected ends may change.
  std::ofstream(draft_, std::ios::binary)
      << twill() + "[WARP]\nUnits=Inches\n[WARP THICKNESS]\n1=.0200 ; as spun\n9= 0.030\n";
  settings({{"imperial", true}});
  const std::string original = bytes_of(draft_);
  std::string saved;
  {
    Window w(display_, folder_, draft_);
    ASSERT_TRUE(comes_true([&] { return w.is_ready() && w.has("threads.thickness"); }));
    EXPECT_EQ(w.live(), original);
    display_.click(w.cell("warp_numbers", 3, 1));
    display_.click_holding("shift", w.cell("warp_numbers", 5, 1));
    ASSERT_TRUE(comes_true([&] { return w.has("threads.none"); })) << "nothing was selected";
    const auto [place, size] = w.place_of("threads.thickness");
    const auto at = [place = place, size = size](double share) {
      return Point{place.x + share * size.x, place.y + size.y / 2};
    };
    display_.drag({at(0.2), at(0.4), at(0.5)});
    ASSERT_TRUE(comes_true([&] { return w.live() != original; })) << "the slider changed nothing";
    const auto thickness = [&] { return design_of(w.live()).draft.warp.thickness_mm; };
    ASSERT_TRUE(comes_true([&] { return thickness()[2] > 1; }));
    EXPECT_EQ(thickness()[3], thickness()[2]);
    EXPECT_EQ(thickness()[4], thickness()[2]);
    EXPECT_EQ(thickness()[5], kFromYarn);
    EXPECT_NE(w.live().find("\n1=.0200 ; as spun\n"), std::string::npos);
    EXPECT_NE(w.live().find("\n9= 0.030\n"), std::string::npos);

    display_.key("ctrl+z");
    EXPECT_TRUE(comes_true([&] { return w.live() == original; })) << "the drag was more than one undo step";
    display_.key("ctrl+shift+z");
    ASSERT_TRUE(comes_true([&] { return w.live() != original; }));

    // A typed value is for the same ends: 10 ends per inch.
    display_.key("Escape");
    ASSERT_TRUE(comes_true([&] { return !w.has("threads.none"); })) << "Escape did not clear the selection";
    display_.click(w.middle_of("threads.which"));
    display_.key("3 minus 5 Return");
    ASSERT_TRUE(comes_true([&] { return w.has("threads.none"); }));
    display_.click(w.middle_of("threads.sett"));
    display_.key("ctrl+a 1 0 Return");
    EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft.warp.spacing_mm[4] == 2.54f; }));
    EXPECT_EQ(design_of(w.live()).draft.warp.spacing_mm[5], kFromYarn);
    display_.key("ctrl+s");
    ASSERT_TRUE(comes_true([&] { return bytes_of(draft_) == w.live() && bytes_of(draft_) != original; }));
    saved = bytes_of(draft_);
    quit(w);
  }
  Window again(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return again.is_ready(); }));
  EXPECT_EQ(again.live(), saved);
  const Threads warp = design_of(saved).draft.warp;
  EXPECT_GT(warp.thickness_mm[3], 1);
  EXPECT_FLOAT_EQ(warp.thickness_mm[0], 0.508f);
  EXPECT_EQ(warp.spacing_mm[2], 2.54f);
  quit(again);
}

TEST_F(WindowTest, AsksBeforeUnsavedWorkIsLost) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string original = w.live();
  display_.click(w.cell("threading", 1, 2));
  ASSERT_TRUE(comes_true([&] { return w.live() != original; }));
  display_.key("ctrl+q");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Do not save"); })) << "quitting did not ask";
  display_.key("Escape");
  ASSERT_TRUE(comes_true([&] { return !w.has("dialog:Do not save"); }));
  EXPECT_TRUE(w.process().is_running());
  display_.key("ctrl+q");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Do not save"); }));
  display_.click(w.middle_of("dialog:Do not save"));
  EXPECT_EQ(w.process().wait(), 0);
  EXPECT_EQ(bytes_of(draft_), original);
}

TEST_F(WindowTest, QuickClicksAreSeparateSteps) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  std::vector<std::string> steps = {w.live()};
  for (int end = 1; end <= 6; ++end) display_.click(w.cell("threading", end, end % 4 + 2 > 4 ? 1 : end % 4 + 2));
  const auto moved = [&] {
    const Design now = design_of(w.live()), before = design_of(steps.front());
    int ends = 0;
    for (int end = 0; end < 16; ++end) ends += now.draft.threading.first(end) != before.draft.threading.first(end);
    return ends;
  };
  ASSERT_TRUE(comes_true([&] { return moved() == 6; })) << moved();
  for (int left = 5; left >= 0; --left) {
    display_.key("ctrl+z");
    EXPECT_TRUE(comes_true([&] { return moved() == left; })) << "an undo undid more than one click: " << moved();
  }
  quit(w);
}

TEST_F(WindowTest, EscapeClosesAMenuAndKeysWorkAgain) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.click(w.middle_of("menu:Edit"));
  ASSERT_TRUE(comes_true([&] { return w.has("menu.undo"); })) << "the menu did not open";
  display_.key("Escape");
  EXPECT_TRUE(comes_true([&] { return !w.has("menu.undo"); })) << "Escape did not close the menu";
  display_.key("F4");
  EXPECT_TRUE(comes_true([&] { return !w.has("threads.which"); })) << "a key did nothing after the menu";
  display_.key("F4");
  ASSERT_TRUE(comes_true([&] { return w.has("threads.which"); }));
  const std::string original = bytes_of(draft_);
  display_.click(w.cell("threading", 1, 2));
  ASSERT_TRUE(comes_true([&] { return w.live() != original; })) << "the draft could not be painted";
  // Ctrl+S also works in a text field.
  display_.click(w.middle_of("threads.which"));
  display_.key("3 ctrl+s");
  EXPECT_TRUE(comes_true([&] { return bytes_of(draft_) != original; })) << "Ctrl+S did nothing in a text field";
  display_.key("Escape");
  quit(w);
}

TEST_F(WindowTest, EscapeClosesWhatLiesOverTheGridsBeforeItDeselects) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string original = w.live();
  const auto deletes = [&] {
    display_.key("Delete");
    const bool changed = comes_true([&] { return w.live() != original; });
    display_.key("ctrl+z");
    return changed && comes_true([&] { return w.live() == original; });
  };
  display_.click(w.cell("warp_numbers", 3, 1));
  ASSERT_TRUE(comes_true([&] { return w.has("threads.none"); })) << "no thread was selected";
  display_.click(w.middle_of("tool:Select"));
  display_.drag({w.cell("threading", 1, 1), w.cell("threading", 3, 3), w.cell("threading", 6, 6)});
  display_.right_click(w.cell("threading", 3, 3));
  ASSERT_TRUE(comes_true([&] { return w.has("context.cut"); }));
  display_.key("Escape");
  ASSERT_TRUE(comes_true([&] { return !w.has("context.cut"); }));
  EXPECT_TRUE(w.has("threads.none")) << "the menu took the selection of threads with it";
  EXPECT_TRUE(deletes()) << "the menu took the selection with it";
  // A window of the window is closed first as well.
  display_.key("ctrl+h");
  ASSERT_NO_FATAL_FAILURE(click(w, "history:0"));
  display_.key("Escape");
  ASSERT_TRUE(comes_true([&] { return !w.has("history:0"); }));
  EXPECT_TRUE(w.has("threads.none")) << "the history took the selection of threads with it";
  EXPECT_TRUE(deletes()) << "the history took the selection with it";
  display_.key("Escape");
  EXPECT_TRUE(comes_true([&] { return !w.has("threads.none"); }));
  display_.key("Delete");
  EXPECT_EQ(w.live(), original) << "Escape kept the selection";
  quit(w);
}

TEST_F(WindowTest, AnyWindowSizeWorksAndTheInspectorCanBeHidden) {
  show_cloth();
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return is_settled(w); }));
  EXPECT_TRUE(w.has("threads.which"));
  display_.key("F4");
  EXPECT_TRUE(comes_true([&] { return !w.has("threads.which"); })) << "F4 did not hide the inspector";
  display_.key("F4");
  ASSERT_TRUE(comes_true([&] { return w.has("threads.which"); }));
  for (const auto& [width, height] : {std::pair{430, 640}, {900, 170}, {60, 60}, {1, 1}, {2000, 1}, {900, 600}}) {
    display_.resize(width, height);
    ASSERT_TRUE(w.process().is_running()) << width << " x " << height;
  }
  ASSERT_TRUE(comes_true([&] { return is_settled(w) && w.place_of("view").second.x < 560; }))
      << "the window did not come back to 900 x 600";
  // Nothing is cut off: every control of the draft's header is left of the splitter.
  const double edge = w.place_of("split").first.x;
  for (const char* control : {"tool", "look"}) {
    const auto [place, size] = w.place_of(control);
    EXPECT_LE(place.x + size.x, edge) << control;
  }
  quit(w);
}

TEST_F(WindowTest, TheDraftCanHaveTheWindowToItself) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  EXPECT_FALSE(w.has("view") || w.has("split")) << "the setting was not kept";
  ASSERT_NO_FATAL_FAILURE(paint(w));
  display_.key("shift+F4");
  EXPECT_TRUE(comes_true([&] { return is_settled(w); })) << "the cloth does not come back";
  display_.key("shift+F4");
  EXPECT_TRUE(comes_true([&] { return !w.has("view"); }));
  display_.key("f");
  EXPECT_TRUE(comes_true([&] { return w.has("view"); })) << "a command about the cloth changes what nobody sees";
}

TEST_F(WindowTest, ATipAppearsWhenThePointerRests) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.move(w.middle_of("save"));
  EXPECT_TRUE(comes_true([&] { return w.has("tip"); })) << "the button has no tip";
  display_.move(w.cell("drawdown", 8, 8));
  EXPECT_TRUE(comes_true([&] { return !w.has("tip"); }));
  quit(w);
}

TEST_F(WindowTest, ShowsLongFloatsAndWeavesOverTheDraft) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string original = w.live();
  display_.click(w.middle_of("inspector:Analysis"));
  ASSERT_TRUE(comes_true([&] { return w.has("floats.count"); })) << "no floats were counted";
  EXPECT_FALSE(w.has("float:1")) << "a 2/2 twill has none";
  const auto [limit, size] = w.place_of("floats.limit");
  display_.click({limit.x + 0.15 * size.x, limit.y + size.y / 2});  // those of a satin, 7, are the most of the default
  display_.key("w");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:satin"); }));
  display_.click(w.middle_of("weave:satin"));
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft.shafts == 8; })) << "the draft did not follow";
  display_.click(w.middle_of("dialog:Apply"));
  ASSERT_TRUE(comes_true([&] { return w.has("float:1"); })) << "the floats of a satin were not found";
  display_.click(w.middle_of("float:1"));
  display_.key("ctrl+z");
  EXPECT_TRUE(comes_true([&] { return w.live() == original; })) << "the weave was more than one undo step";

  display_.key("Escape w");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:satin"); }));
  display_.click(w.middle_of("weave:satin"));
  EXPECT_TRUE(comes_true([&] { return w.live() != original; }));
  display_.key("Escape");
  EXPECT_TRUE(comes_true([&] { return w.live() == original; })) << "Cancel did not restore the draft";
  quit(w);
}

}  // namespace
}  // namespace weftlight::gui
