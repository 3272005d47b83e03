#pragma once
// Fixture of the window tests: a display, and a folder with a draft.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "design/edits.h"
#include "display.h"
#include "wif/wif.h"

namespace weftlight::gui {

/// A straight draw of that size on a flat cloth.
inline std::string straight_draft(int threads = 24, int shafts = 8) {
  design::Design d;
  d.draft = draft::blank_draft(threads, threads, shafts, shafts);
  for (int i = 0; i < threads; ++i) {
    d.draft.threading.set(i, i % shafts, true);
    d.draft.treadling.set(i, i % shafts, true);
  }
  for (int i = 0; i < shafts; ++i)
    for (int k = 0; k < shafts / 2; ++k) d.draft.tieup.set(i, (i + k) % shafts, true);
  d.scene.mesh = "plane";
  return wif::write_new_wif(d);
}

inline design::Design design_of(const std::string& bytes) {
  const wif::WifRead read = wif::read_wif(bytes);
  return read.file ? read.file->design : design::Design{};
}

class OnDisplay : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string reason = why_not(); !reason.empty()) GTEST_SKIP() << "no graphics: " << reason;
    ASSERT_TRUE(display_.is_up()) << "Xvfb did not start";
    char name[] = "/tmp/weftlight_gui_XXXXXX";
    folder_ = mkdtemp(name);
    draft_ = folder_ / "straight.wif";
    std::filesystem::create_directories(folder_ / "config/weftlight");
    std::ofstream(folder_ / "config/weftlight/settings.json") << R"({"width": 1280, "height": 800})";
    put(draft_, straight_draft());
  }
  void TearDown() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }
  /// An environment without zenity, so that the window uses its own file dialogs.
  static std::vector<std::string> without_dialogs() { return {"PATH=/nowhere"}; }

  /// Paints an end on shaft 3 and waits for the window.
  void paint(const Window& w, int end = 1) const {
    const std::string before = w.live();
    display_.click(w.cell("threading", end, 3));
    ASSERT_TRUE(comes_true([&] { return w.live() != before; })) << "the click painted nothing";
  }
  /// Presses a button of a dialog.
  void press(const Window& w, const std::string& button) const {
    ASSERT_TRUE(comes_true([&] { return w.has("dialog:" + button); })) << "no dialog with the button " << button;
    display_.click(w.middle_of("dialog:" + button));
    ASSERT_TRUE(comes_true([&] { return !w.has("dialog:" + button); })) << button;
  }
  static void put(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
  }

  const Display display_{1280, 800};
  std::filesystem::path folder_, draft_;
};

}  // namespace weftlight::gui
