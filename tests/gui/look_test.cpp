// Screenshots of all views and dialogs in both themes against stored pictures (pictures/), from one window.
// WEFTLIGHT_UPDATE_GOLDENS=1 in the environment updates them; a failure leaves reference, result and difference in the
// build folder. The cloth is left out (tests/golden has it): the window may draw it by EGL alone, and runs without.

#include <algorithm>
#include <cmath>

#include "files/files.h"
#include "on_display.h"

namespace weftlight::gui {

using base::problem_of;
using files::Image;

namespace {

namespace fs = std::filesystem;

// Root mean square of 0..1 over all pixels, and over the worst block. Another version of FreeType moves the edges of
// letters (about 0.01 and 0.1); a control that is missing or another colour is above.
constexpr double kTolerance = 0.02, kBlockTolerance = 0.16;
constexpr int kBlock = 64;        // pixels
constexpr int kCaretPixels = 80;  // may differ between two screenshots of an idle window, because of a blinking caret
constexpr int kStillMs = 450;

struct Difference {
  double whole = 0, block = 0;
};

/// Difference of two pictures of the same size; `seen`: the differing pixels, highlighted.
Difference difference_of(const Image& a, const Image& b, Image& seen) {
  seen = a;
  Difference out;
  double sum = 0;
  const auto n = static_cast<size_t>(a.channels);
  for (int y0 = 0; y0 < a.height; y0 += kBlock)
    for (int x0 = 0; x0 < a.width; x0 += kBlock) {
      double block = 0;
      size_t texels = 0;
      for (int y = y0; y < std::min(y0 + kBlock, a.height); ++y)
        for (int x = x0; x < std::min(x0 + kBlock, a.width); ++x)
          for (size_t k = 0; k < n; ++k, ++texels) {
            const size_t at = (static_cast<size_t>(y) * static_cast<size_t>(a.width) + static_cast<size_t>(x)) * n + k;
            const float d = a.texels[at] - b.texels[at];
            seen.texels[at] = std::min(1.0f, std::abs(d) * 4);
            block += static_cast<double>(d) * static_cast<double>(d);
          }
      sum += block;
      out.block = std::max(out.block, std::sqrt(block / static_cast<double>(texels)));
    }
  out.whole = std::sqrt(sum / static_cast<double>(a.texels.size()));
  return out;
}

class LookTest : public OnDisplay {
 protected:
  void SetUp() override {
    OnDisplay::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    design::Design overshot = design_of(bytes_of(WEFTLIGHT_DRAFTS "/overshot.wif"));
    overshot.loom.shafts = overshot.draft.shafts, overshot.loom.treadles = overshot.draft.treadles;
    put(folder_ / "overshot.wif", wif::write_new_wif(overshot));
    fs::copy_file(WEFTLIGHT_DRAFTS "/summer_and_winter.wif", folder_ / "other.wif");
    put(folder_ / "config/weftlight/settings.json", R"({"width": 1280, "height": 800, "toured": true})");
  }

  void leave(const Window& w, const std::string& until_gone) const {
    display_.key("Escape");
    ASSERT_TRUE(comes_true([&] { return !w.has(until_gone); })) << until_gone;
  }

  /// A screenshot once the window no longer changes.
  Image still() const {
    std::string before;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(15);
    for (;;) {
      std::string now = display_.picture({0, 0}, {1280, 800});
      int other = 0;
      for (size_t i = 0; i < std::min(before.size(), now.size()); ++i) other += before[i] != now[i] ? 1 : 0;
      const bool same = before.size() == now.size() && other <= 3 * kCaretPixels;
      if (same || std::chrono::steady_clock::now() > end) return image_of(now);
      before = std::move(now);
      usleep(kStillMs * 1000);
    }
  }
  static Image image_of(const std::string& ppm) {
    constexpr size_t kValues = size_t{1280} * 800 * 3;
    Image image{1280, 800, 3, {}};
    if (ppm.size() < kValues) return image;
    for (size_t i = ppm.size() - kValues; i < ppm.size(); ++i)
      image.texels.push_back(static_cast<float>(static_cast<unsigned char>(ppm[i])) / 255);
    return image;
  }

  void shoot(const std::string& name) {
    display_.move({640, 798});  // where nothing is highlighted
    const Image now = still();
    const std::string result = WEFTLIGHT_LOOK_RESULTS "/" + name + theme_,
                      stored = WEFTLIGHT_LOOKS "/" + name + theme_ + ".png";
    ASSERT_EQ(problem_of(files::write_image(result + "_result.png", now, files::PixelType::kU8)), "");
    if (std::getenv("WEFTLIGHT_UPDATE_GOLDENS") != nullptr) {
      // 255 colours: a fifth of the size without a visible difference.
      ASSERT_EQ(
          std::system(("convert '" + result + "_result.png' +dither -colors 255 -strip PNG8:'" + stored + "'").c_str()),
          0);
      return;
    }
    const base::Result<files::Image> reference = files::read_image(stored);
    ASSERT_TRUE(reference) << problem_of(reference);
    Image expected{1280, 800, 3, {}};
    const auto channels = static_cast<size_t>(reference->channels);
    for (size_t i = 0; i < reference->texels.size(); ++i)
      if (i % channels < 3) expected.texels.push_back(reference->texels[i]);
    ASSERT_EQ(expected.texels.size(), now.texels.size()) << stored;
    Image seen;
    const Difference d = difference_of(expected, now, seen);
    if (d.whole > kTolerance || d.block > kBlockTolerance) {
      files::write_image(result + "_reference.png", expected, files::PixelType::kU8);
      files::write_image(result + "_difference.png", seen, files::PixelType::kU8);
    }
    EXPECT_LE(d.whole, kTolerance) << "see " << result << "_{reference,result,difference}.png";
    EXPECT_LE(d.block, kBlockTolerance) << "see " << result << "_{reference,result,difference}.png";
  }

  void shoot_all(const Window& w);
  void shoot_dialogs(const Window& w);
  void shoot_menus(const Window& w);
  void shoot_comparison(const Window& w);
  void shoot_closest_weave(const Window& w);
  void open(const Window& w, const fs::path& file) const {
    ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
    display_.key("ctrl+a");
    display_.type(file.string());
    display_.key("Return");
    ASSERT_TRUE(comes_true([&] { return !w.has("dialog.path"); }));
  }
  std::string theme_ = "_light";
};

void LookTest::shoot_dialogs(const Window& w) {
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Cancel"); }));
  shoot("new_draft");
  ASSERT_NO_FATAL_FAILURE(leave(w, "dialog:Cancel"));
  display_.key("ctrl+shift+p");
  ASSERT_TRUE(comes_true([&] { return w.has("print.ready"); }));
  shoot("print");
  ASSERT_NO_FATAL_FAILURE(leave(w, "print.ready"));
  display_.key("ctrl+l");
  ASSERT_TRUE(comes_true([&] { return w.has("gallery.picture:1") && w.has("gallery.picture:10"); }));
  shoot("library");
  ASSERT_NO_FATAL_FAILURE(leave(w, "gallery:1"));
  display_.key("shift+w");
  ASSERT_TRUE(comes_true([&] { return w.has("sections.take"); }));
  shoot("sections");
  ASSERT_NO_FATAL_FAILURE(leave(w, "sections.take"));
  display_.key("w");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Apply"); }));
  shoot("weave_over");
  ASSERT_NO_FATAL_FAILURE(leave(w, "dialog:Apply"));
  display_.key("ctrl+e");
  ASSERT_TRUE(comes_true([&] { return w.has("export.ready"); }));
  display_.click(w.middle_of("export.folder"));
  display_.key("ctrl+a");
  display_.type("/home/weaver/textures");  // not the folder of this test, which changes with every run
  shoot("export");
  ASSERT_NO_FATAL_FAILURE(leave(w, "export.folder"));
}

void LookTest::shoot_menus(const Window& w) {
  ASSERT_NO_FATAL_FAILURE(click(w, "menu:View"));
  shoot("menu");
  ASSERT_NO_FATAL_FAILURE(leave(w, "menu.fit"));
  display_.key("ctrl+p");
  ASSERT_TRUE(comes_true([&] { return w.has("commands.typed"); }));
  display_.type("draw");
  shoot("commands");
  ASSERT_NO_FATAL_FAILURE(leave(w, "commands.typed"));
  ASSERT_NO_FATAL_FAILURE(click(w, "views"));
  ASSERT_TRUE(comes_true([&] { return w.has("views.view.grazing"); }));
  shoot("views");
  ASSERT_NO_FATAL_FAILURE(leave(w, "views.view.grazing"));
  display_.key("ctrl+o");
  ASSERT_NO_FATAL_FAILURE(open(w, folder_ / "other.wif"));
  ASSERT_TRUE(comes_true([&] { return w.has("tab.shown:2"); }));
  display_.right_click(w.middle_of("tab:1"));
  ASSERT_TRUE(comes_true([&] { return w.has("tab_menu.duplicate") && w.has("tab.shown:1"); }));
  shoot("tab_menu");
  ASSERT_NO_FATAL_FAILURE(leave(w, "tab_menu.duplicate"));
  display_.click(w.middle_of("tab.close:2"));
  ASSERT_TRUE(comes_true([&] { return !w.has("tab:1"); }));
  display_.key("ctrl+0");  // restores the width of the panes
}

void LookTest::shoot_comparison(const Window& w) {
  ASSERT_NO_FATAL_FAILURE(command(w, "compare with a draft"));
  ASSERT_NO_FATAL_FAILURE(open(w, folder_ / "other.wif"));
  ASSERT_TRUE(comes_true([&] { return w.has("difference.other"); }));
  shoot("compare");
  ASSERT_NO_FATAL_FAILURE(click(w, "difference.done"));
  ASSERT_NO_FATAL_FAILURE(click(w, "inspector:Threads"));
}

void LookTest::shoot_closest_weave(const Window& w) {
  const std::string before = w.live();
  ASSERT_NO_FATAL_FAILURE(command(w, "drawdown leads"));
  ASSERT_TRUE(comes_true([&] { return w.live() != before; }));
  display_.key("shift+u");
  display_.drag({w.cell("drawdown", 1, 1), w.cell("drawdown", 14, 12), w.cell("drawdown", 70, 120)});
  ASSERT_TRUE(comes_true([&] { return w.has("closest.see"); }));
  shoot("closest_weave_notice");
  display_.click(w.middle_of("closest.see"));
  ASSERT_TRUE(comes_true([&] { return w.has("closest.place:1"); }));
  shoot("closest_weave");
  ASSERT_NO_FATAL_FAILURE(click(w, "dialog:Cancel"));
  ASSERT_TRUE(comes_true([&] { return !w.has("closest.place:1"); }));
  display_.key("p");
  display_.key("ctrl+z");
  ASSERT_TRUE(comes_true([&] { return w.live() == before; }));
}

void LookTest::shoot_all(const Window& w) {
  for (const char* tab : {"Threads", "Yarns", "Cloth", "Analysis", "Plan"}) {
    ASSERT_NO_FATAL_FAILURE(click(w, std::string("inspector:") + tab));
    shoot(std::string("tab_") + static_cast<char>(std::tolower(tab[0])) + (tab + 1));
    if (HasFatalFailure()) return;
  }
  ASSERT_NO_FATAL_FAILURE(click(w, "inspector:Threads"));
  ASSERT_NO_FATAL_FAILURE(shoot_dialogs(w));
  display_.key("F1");
  ASSERT_TRUE(comes_true([&] { return w.has("keys.typed"); }));
  shoot("keys");
  display_.key("F1");
  ASSERT_TRUE(comes_true([&] { return !w.has("keys.typed"); }));
  display_.key("ctrl+h");
  ASSERT_TRUE(comes_true([&] { return w.has("history:0"); }));
  shoot("history");
  display_.key("ctrl+h");
  display_.key("F9");
  ASSERT_TRUE(comes_true([&] { return w.has("loom.address"); }));
  shoot("loom");
  display_.key("F9");
  ASSERT_TRUE(comes_true([&] { return w.has("threading") || w.has("view"); }));
  ASSERT_NO_FATAL_FAILURE(shoot_menus(w));
  ASSERT_NO_FATAL_FAILURE(shoot_comparison(w));
  ASSERT_NO_FATAL_FAILURE(shoot_closest_weave(w));
}

TEST_F(LookTest, EveryViewMatchesItsPictureInBothThemes) {
  Window w(display_, folder_, folder_ / "overshot.wif",
           {"PATH=/nowhere", "WEFTLIGHT_OFFSCREEN=egl", std::string("LD_PRELOAD=") + WEFTLIGHT_NO_EGL});
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(shoot_all(w));
  ASSERT_NO_FATAL_FAILURE(command(w, "light or dark"));
  theme_ = "_dark";
  ASSERT_NO_FATAL_FAILURE(shoot_all(w));
}

}  // namespace
}  // namespace weftlight::gui
