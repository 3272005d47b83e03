#pragma once
// Fixture of the window tests: a display, and a folder with a draft.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

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
    settings({});
    put(draft_, straight_draft());
  }
  void TearDown() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }
  /// An environment without zenity, so that the window uses its own file dialogs.
  static std::vector<std::string> without_dialogs() { return {"PATH=/nowhere"}; }

  /// What the next window starts with. The cloth is hidden, so that it costs nothing where only the draft is tested.
  void settings(nlohmann::json more) const {
    more.merge_patch({{"width", 1280}, {"height", 800}});
    if (!more.contains("cloth")) more["cloth"] = false;
    put(folder_ / "config/weftlight/settings.json", more.dump());
  }
  void show_cloth() const { settings({{"cloth", true}}); }

  /// Paints an end on shaft 3 and waits for the window.
  void paint(const Window& w, int end = 1) const {
    const std::string before = w.live();
    display_.click(w.cell("threading", end, 3));
    ASSERT_TRUE(comes_true([&] { return w.live() != before; })) << "the click painted nothing";
  }
  /// Makes the cells larger, or smaller, so many times; returns when they are.
  void enlarge(const Window& w, int times) const { zoom(w, "ctrl+plus", times, 1); }
  void shrink(const Window& w, int times) const { zoom(w, "ctrl+minus", times, -1); }
  void zoom(const Window& w, const std::string& key, int times, int sign) const {
    const auto pitch = [&] { return std::abs(w.cell("drawdown", 1, 1).x - w.cell("drawdown", 2, 1).x); };
    for (int i = 0; i < times; ++i) {
      const double before = pitch();
      display_.key(key);
      ASSERT_TRUE(comes_true([&] { return sign * pitch() > sign * before; })) << "the cells stay as they are";
    }
  }
  /// Clicks a control once it is there.
  void click(const Window& w, const std::string& control) const {
    ASSERT_TRUE(comes_true([&] { return w.has(control); })) << control;
    display_.click(w.middle_of(control));
  }
  /// Runs an action by its name in the command palette.
  void command(const Window& w, const std::string& words) const {
    display_.key("ctrl+p");
    ASSERT_TRUE(comes_true([&] { return w.has("commands.typed"); })) << words;
    display_.type(words);
    display_.key("Return");
    ASSERT_TRUE(comes_true([&] { return !w.has("commands.typed"); })) << words;
  }
  /// Presses a button of a dialog.
  void press(const Window& w, const std::string& button) const {
    ASSERT_TRUE(comes_true([&] { return w.has("dialog:" + button); })) << "no dialog with the button " << button;
    display_.click(w.middle_of("dialog:" + button));
    ASSERT_TRUE(comes_true([&] { return !w.has("dialog:" + button); })) << button;
  }
  static bool is_settled(const Window& w) {
    return w.is_ready() && w.has("view.picture") && !w.has("view.busy") && !w.has("view.refining");
  }
  /// The cloth, without the line of statistics below it.
  std::string picture(const Window& w) const {
    const auto [place, size] = w.place_of("view");
    return display_.picture({place.x + 20, place.y + 60}, {size.x - 40, size.y - 140});
  }
  /// The cloth once two screenshots are the same.
  std::string still_picture(const Window& w) const {
    std::string last, now;
    comes_true([&] {
      last = std::move(now);
      now = picture(w);
      return is_settled(w) && !now.empty() && now == last;
    });
    return now;
  }
  /// RMSE of two pictures of the same size, relative to 1; 1 for different sizes. On a busy machine a picture may have
  /// fewer passes.
  static double apart(const std::string& a, const std::string& b) {
    if (a.size() != b.size() || a.empty()) return 1;
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) {
      const double d = (static_cast<unsigned char>(a[i]) - static_cast<unsigned char>(b[i])) / 255.0;
      sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
  }
  /// Bytes of the journals of unsaved work.
  uintmax_t journal_bytes() const {
    uintmax_t bytes = 0;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "state", ignored))
      if (entry.path().extension() == ".journal") bytes += entry.file_size(ignored);
    return bytes;
  }
  /// Until unsaved work is on the disk: that is promised after half a second, of a machine that has no other work.
  void wait_until_kept() const {
    EXPECT_TRUE(comes_true([&] {
      const uintmax_t before = journal_bytes();
      usleep(600'000);
      return before > 0 && journal_bytes() == before;
    })) << "the work is not kept";
  }
  void kill_once_kept(Window& w) const {
    wait_until_kept();
    w.process().kill_now();
    w.process().wait();
  }
  static void put(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
  }

  const Display display_{1280, 800};
  std::filesystem::path folder_, draft_;
};

}  // namespace weftlight::gui
