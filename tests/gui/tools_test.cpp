// Printing, exporting, comparing, yarn requirements and weaving at a loom, in the real window.

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdio>

#include "../unit/loom_port.h"
#include "draft/drawdown.h"
#include "on_display.h"

namespace weftlight::gui {
namespace {

namespace fs = std::filesystem;

class ToolsTest : public OnDisplay {};

TEST_F(ToolsTest, PrintsThePreviewedSheets) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("ctrl+shift+p");
  ASSERT_TRUE(comes_true([&] { return w.has("print.ready"); })) << "no sheet is shown";
  EXPECT_TRUE(w.has("print.sheets:2")) << "the grids, and the lists";
  for (const char* part : {"print.lists", "print.heddles", "print.yarn"}) ASSERT_NO_FATAL_FAILURE(click(w, part));
  ASSERT_NO_FATAL_FAILURE(click(w, "print.scale:Custom"));
  ASSERT_TRUE(comes_true([&] { return w.has("print.cell"); }));
  const auto [slider, size] = w.place_of("print.cell");
  display_.drag({{slider.x + 10, slider.y + size.y / 2}, {slider.x + size.x - 4, slider.y + size.y / 2}});
  ASSERT_TRUE(comes_true([&] { return w.has("print.ready") && !w.has("print.sheets:2"); }))
      << "large cells, more sheets";
  ASSERT_NO_FATAL_FAILURE(click(w, "print.scale:Automatic"));
  EXPECT_TRUE(comes_true([&] { return w.has("print.ready") && w.has("print.sheets:2"); })) << "small cells again";
  ASSERT_NO_FATAL_FAILURE(click(w, "dialog:Save\xE2\x80\xA6"));
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  display_.key("ctrl+a");
  display_.type((folder_ / "printed").string());
  display_.key("Return");
  const fs::path pdf = folder_ / "printed.pdf";
  ASSERT_TRUE(comes_true([&] { return fs::exists(pdf); })) << "nothing was printed";
  EXPECT_TRUE(comes_true([&] { return bytes_of(pdf).starts_with("%PDF"); }));
  EXPECT_EQ(design_of(w.live()), design_of(bytes_of(draft_))) << "printing changes nothing";
}

TEST_F(ToolsTest, ExportsThePreviewedSetAndFollowsTheDraft) {
  show_cloth();
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const fs::path other = folder_ / "textures/straight";
  fs::create_directories(other);
  put(other / "notes.txt", "of the artist");
  display_.key("ctrl+e");
  ASSERT_TRUE(comes_true([&] { return w.has("export.ready") && w.has("export.map:straight_basecolor.png"); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "export.for:godot"));
  ASSERT_NO_FATAL_FAILURE(click(w, "export.for:gltf"));
  EXPECT_TRUE(comes_true([&] { return w.has("export.ready") && w.has("export.map:straight_flowmap.png"); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "export.face:Back"));
  EXPECT_TRUE(comes_true([&] { return w.has("export.map:straight_back_albedo.png"); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "export.size:512"));
  EXPECT_TRUE(w.has("export.images:8"));
  ASSERT_NO_FATAL_FAILURE(click(w, "export.watch"));
  ASSERT_NO_FATAL_FAILURE(click(w, "dialog:Export"));
  ASSERT_TRUE(comes_true([&] { return w.has("export.asked"); })) << "a foreign file is in the way";
  display_.key("Return");
  EXPECT_TRUE(w.has("export.asked")) << "Enter answered it";
  ASSERT_NO_FATAL_FAILURE(click(w, "dialog:Replace"));
  ASSERT_TRUE(comes_true([&] { return w.has("export.written"); }));
  EXPECT_EQ(bytes_of(other / "notes.txt"), "of the artist");
  const std::string before = bytes_of(other / "straight_albedo.png");
  EXPECT_FALSE(before.empty());
  ASSERT_NO_FATAL_FAILURE(click(w, "dialog:Close"));
  ASSERT_TRUE(comes_true([&] { return !w.has("export.watch"); }));
  display_.click(w.cell("threading", 5, 1));
  EXPECT_TRUE(comes_true([&] {
    const std::string now = bytes_of(other / "straight_albedo.png");
    return !now.empty() && now != before;
  })) << "the set does not follow the draft";
}

TEST_F(ToolsTest, ShowsTheDifferencesOfTwoDrafts) {
  Window w(display_, folder_, draft_, without_dialogs());
  const fs::path other = folder_ / "other.wif";
  design::Design changed = design_of(bytes_of(draft_));
  changed.draft.threading.set(4, 4, false);
  changed.draft.threading.set(4, 0, true);
  put(other, wif::write_new_wif(changed));
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("ctrl+p");
  display_.type("compare with");
  display_.key("Return");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  display_.key("ctrl+a");
  display_.type(other.string());
  display_.key("Return");
  ASSERT_TRUE(comes_true([&] { return w.has("difference.crossings") && w.has("difference:threading"); }));
  EXPECT_TRUE(w.has("place:1"));
  const std::string before = display_.picture(w.cell("drawdown", 6, 1), {60, 60});
  display_.key("F3");
  EXPECT_TRUE(comes_true([&] {
    return display_.picture(w.cell("drawdown", 6, 1), {60, 60}) != before;
  })) << "the place is not outlined";
  // Once painted the same, the comparison updates.
  display_.click(w.cell("threading", 5, 1));
  EXPECT_TRUE(comes_true([&] { return w.has("difference.same") && !w.has("difference:threading"); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "difference.done"));
  EXPECT_TRUE(comes_true([&] { return !w.has("difference.same"); }));
}

TEST_F(ToolsTest, ThePlanOfTheClothIsKeptInTheFileAndUndone) {
  {
    Window w(display_, folder_, draft_, without_dialogs());
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    const std::string original = w.live();
    ASSERT_NO_FATAL_FAILURE(click(w, "inspector:Plan"));
    ASSERT_TRUE(comes_true([&] { return w.has("plan.width") && w.has("plan.finished"); }));
    EXPECT_EQ(w.live(), original) << "looking at the plan changes nothing";
    const auto type = [&](const std::string& control, const std::string& keys) {
      ASSERT_NO_FATAL_FAILURE(click(w, control + ":figure"));
      display_.key("ctrl+a " + keys + " Return");
    };
    ASSERT_NO_FATAL_FAILURE(type("plan.width", "5 0"));
    ASSERT_TRUE(comes_true([&] { return design_of(w.live()).plan.width_mm == 500; }));
    ASSERT_NO_FATAL_FAILURE(click(w, "plan.units:Imperial"));
    ASSERT_NO_FATAL_FAILURE(type("plan.length", "1 0"));
    ASSERT_TRUE(comes_true([&] { return design_of(w.live()).plan.length_mm == 254; })) << "inches";
    display_.key("ctrl+z");
    ASSERT_TRUE(comes_true([&] { return design_of(w.live()).plan.length_mm == 0; })) << "undone";
    EXPECT_EQ(design_of(w.live()).plan.width_mm, 500);
    ASSERT_NO_FATAL_FAILURE(type("plan.waste", "3 0"));
    ASSERT_TRUE(comes_true([&] { return design_of(w.live()).plan.loom_waste_mm == 762; }));
    display_.key("ctrl+s");
    ASSERT_TRUE(comes_true([&] { return design_of(bytes_of(draft_)).plan.loom_waste_mm == 762; }));
    display_.key("ctrl+q");
    EXPECT_EQ(w.process().wait(), 0);
  }
  const auto kept = nlohmann::json::parse(bytes_of(folder_ / "config/weftlight/settings.json"));
  EXPECT_NEAR(kept["loom_waste_cm"].get<double>(), 76.2, 1e-4) << "for the next new draft";
  EXPECT_TRUE(kept["imperial"].get<bool>());
}

TEST_F(ToolsTest, TheFirstReedIsOneOfTheWeaversUnits) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "inspector:Plan"));
  ASSERT_NO_FATAL_FAILURE(click(w, "plan.units:Imperial"));
  for (const char* above : {"section.size", "section.on_loom"}) ASSERT_NO_FATAL_FAILURE(click(w, above));
  ASSERT_NO_FATAL_FAILURE(click(w, "plan.reed:figure"));
  display_.key("ctrl+a 1 2 Return");
  EXPECT_TRUE(comes_true([&] {
    return design_of(w.live()).plan.reed == design::Reed{12, true};
  })) << "12 dents in 10 cm, for a weaver who counts in inches";
}

TEST_F(ToolsTest, CellsOnPaperAreInInchesForAWeaverWhoCountsInThem) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  ASSERT_NO_FATAL_FAILURE(command(w, "inches, yards"));
  display_.key("ctrl+shift+p");
  ASSERT_TRUE(comes_true([&] { return w.has("print.ready") && w.has("print.sheets:2"); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "print.scale:Custom"));
  ASSERT_NO_FATAL_FAILURE(click(w, "print.cell:figure"));
  display_.key("ctrl+a 0 period 5 Tab");
  EXPECT_TRUE(comes_true([&] { return w.has("print.ready") && !w.has("print.sheets:2"); }))
      << "half an inch takes more sheets than half a millimetre";
}

TEST_F(ToolsTest, AStepOfUndoHasTheNameOfItsControl) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "inspector:Plan"));
  ASSERT_NO_FATAL_FAILURE(click(w, "plan.width:figure"));
  display_.key("ctrl+a 5 0 Return");
  ASSERT_TRUE(comes_true([&] { return design_of(w.live()).plan.width_mm == 500; }));
  display_.key("ctrl+p");
  ASSERT_TRUE(comes_true([&] { return w.has("commands.typed"); }));
  display_.type("undo: width");
  EXPECT_TRUE(comes_true([&] { return w.has("command:undo") && !w.has("command:redo"); }));
  display_.key("ctrl+a");
  display_.type("undo: change");
  EXPECT_TRUE(comes_true([&] { return !w.has("command:undo"); })) << "\"Change plan (Width)\"";
}

TEST_F(ToolsTest, WeavesPickByPickAndSavesThePlaceWithTheDraft) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("F9");
  ASSERT_TRUE(comes_true([&] { return w.has("loom.pick:1"); }));
  display_.key("space");
  display_.key("Next");
  ASSERT_TRUE(comes_true([&] { return w.has("loom.pick:3"); }))
      << "Space and Page down, as from a pedal, go to the next pick";
  ASSERT_NO_FATAL_FAILURE(click(w, "loom.next"));
  ASSERT_TRUE(comes_true([&] { return w.has("loom.pick:4"); }));
  display_.key("BackSpace");
  ASSERT_TRUE(comes_true([&] { return w.has("loom.pick:3"); }));
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).loom.next_pick == 2; })) << "it is saved with the draft";
  display_.key("Escape");
  EXPECT_TRUE(comes_true([&] { return !w.has("loom.next") && w.is_ready(); }));
  display_.key("ctrl+z");
  display_.key("F9");
  EXPECT_TRUE(comes_true([&] { return w.has("loom.pick:3"); })) << "undo is about edits";
}

/// The window connects to the address and sends the lift of each pick that the loom requests.
TEST_F(ToolsTest, SendsEachPickToALoomOverTcp) {
  const LoomPort port;
  ASSERT_GT(port.number(), 0);
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("F9");
  ASSERT_NO_FATAL_FAILURE(click(w, "loom.address"));
  display_.type(port.address());
  ASSERT_NO_FATAL_FAILURE(click(w, "loom.connect"));
  const int loom = port.accepted();
  ASSERT_GE(loom, 0);
  std::string heard;
  const auto hears = [&](const std::string& line) {
    char buffer[256];
    for (ssize_t got; heard.find(line) == std::string::npos && (got = ::read(loom, buffer, sizeof buffer)) > 0;)
      heard.append(buffer, static_cast<size_t>(got));
    return heard.find(line) != std::string::npos;
  };
  const timeval patience{20, 0};
  ::setsockopt(loom, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  EXPECT_TRUE(hears("U0\n")) << "weaving, not unweaving";
  ASSERT_TRUE(comes_true([&] { return w.has("loom.disconnect"); }));
  const draft::Draft d = design_of(w.live()).draft;
  const draft::BitMatrix lifts = draft::lifts(d);
  for (int pick = 0; pick < 3; ++pick) {
    uint32_t shafts = 0;
    for (int s = 0; s < d.shafts; ++s) shafts |= lifts.get(pick, s) ? 1u << s : 0;
    char command[16];
    std::snprintf(command, sizeof command, "C%08x\n", shafts);
    ASSERT_EQ(::write(loom, "p\n", 2), 2);
    EXPECT_TRUE(hears(command)) << "pick " << pick + 1;
    heard.clear();
  }
  EXPECT_TRUE(comes_true([&] { return w.has("loom.pick:3"); })) << "the window follows the loom";
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).loom.next_pick == 2; }));
  ASSERT_NO_FATAL_FAILURE(click(w, "loom.disconnect"));
  EXPECT_TRUE(comes_true([&] { return w.has("loom.connect"); }));
  ::close(loom);
}

TEST_F(ToolsTest, QuitsWhileTheNameOfALoomIsLookedUp) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "a library put before the sanitizer's cannot be loaded";
#endif
  auto environment = without_dialogs();
  environment.push_back(std::string("LD_PRELOAD=") + WEFTLIGHT_HANGING_LOOKUP);
  Window w(display_, folder_, draft_, environment);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("F9");
  ASSERT_NO_FATAL_FAILURE(click(w, "loom.address"));
  display_.type("tcp:loom.invalid:7388");
  ASSERT_NO_FATAL_FAILURE(click(w, "loom.connect"));
  ASSERT_TRUE(comes_true([&] { return w.has("loom.disconnect"); }));
  display_.key("ctrl+q");
  EXPECT_EQ(w.process().wait(), 0) << "the window waited for the name server";
}

TEST_F(ToolsTest, Pick1CanBeAtTheBottom) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  EXPECT_LT(w.cell("drawdown", 1, 1).y, w.cell("drawdown", 1, 9).y);
  display_.key("ctrl+p");
  ASSERT_TRUE(comes_true([&] { return w.has("commands.typed"); }));
  display_.type("pick 1 at the bottom");
  display_.key("Return");
  ASSERT_TRUE(comes_true([&] { return w.cell("drawdown", 1, 1).y > w.cell("drawdown", 1, 9).y; }));
  for (const char* grid : {"treadling", "weft_colors", "weft_numbers"})
    EXPECT_GT(w.cell(grid, 1, 1).y, w.cell(grid, 1, 9).y) << grid;
  EXPECT_LT(w.cell("threading", 1, 8).y, w.cell("drawdown", 1, 24).y) << "the threading stays above";
  // Clicks and arrow keys follow the orientation on the screen.
  display_.click(w.cell("treadling", 5, 2));
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft.treadling.first(1) == 4; }));
  display_.key("n");
  display_.click(w.cell("treadling", 1, 3));
  display_.key("Up");
  display_.type("7");
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft.treadling.first(3) == 6; })) << "the pick above";
  display_.key("ctrl+q");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Do not save"); }));
  display_.click(w.middle_of("dialog:Do not save"));
  EXPECT_EQ(w.process().wait(), 0);
  Window again(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return again.is_ready(); }));
  EXPECT_GT(again.cell("drawdown", 1, 1).y, again.cell("drawdown", 1, 9).y) << "it is saved";
}

TEST_F(ToolsTest, OnASmallScreenEverythingFits) {
  show_cloth();
  const Display small(1000, 640);
  ASSERT_TRUE(small.is_up());
  Window w(small, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready() && w.has("inspector:Analysis"); }));
  EXPECT_TRUE(comes_true([&] {
    const auto [at, size] = w.place_of("inspector:Analysis");
    return at.x + size.x <= 1000;
  }));
  const auto [at, size] = w.place_of("view");
  EXPECT_LE(at.y + size.y, 640);
}

TEST_F(ToolsTest, AFlatSwatchFillsThePane) {
  show_cloth();
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready() && w.has("view.picture") && !w.has("view.busy"); }));
  const auto [at, size] = w.place_of("view");
  const auto corner = [&, at = at, size = size] { return display_.picture({at.x + 4, at.y + size.y / 2}, {40, 40}); };
  const auto is_plain = [](const std::string& ppm) {
    return ppm.size() > 100 && ppm.find_first_not_of(ppm.back(), ppm.size() - 60) == std::string::npos;
  };
  ASSERT_NO_FATAL_FAILURE(click(w, "hanging:Flat"));
  EXPECT_TRUE(comes_true([&] { return !w.has("view.busy") && !is_plain(corner()); })) << "no cloth at the pane's edge";
  const auto middle = [&, at = at, size = size] {
    return display_.picture({at.x + size.x / 2, at.y + size.y / 2}, {60, 60});
  };
  const std::string from_the_front = middle();
  display_.key("shift+f");
  ASSERT_TRUE(comes_true([&] { return w.has("grazing.on"); }));
  EXPECT_TRUE(comes_true([&] { return middle() != from_the_front; })) << "the light is where it was";
  ASSERT_NO_FATAL_FAILURE(click(w, "grazing.on"));
  EXPECT_TRUE(comes_true([&] { return w.has("grazing"); }));
  display_.key("f");
  EXPECT_TRUE(comes_true([&] { return !w.has("view.busy") && !w.has("grazing"); }));
  EXPECT_EQ(design_of(w.live()), design_of(bytes_of(draft_))) << "the design is unchanged";
}

}  // namespace
}  // namespace weftlight::gui
