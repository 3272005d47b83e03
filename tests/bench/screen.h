#pragma once
// A screen for benchmarks of the panels, and the large drafts for it.

#include <imgui.h>

#include <memory>
#include <random>
#include <string>
#include <variant>

#include "design/edits.h"
#include "gl/open_headless.h"
#include "session/document/document.h"
#include "ui/fonts.h"
#include "ui/style.h"
#include "views/common/panel.h"
#include "weaves/weaves.h"

namespace weftlight::bench {

using base::problem_of;
using design::Design, design::to_liftplan;
using draft::ShedControl;
using ui::Style, ui::Tip, ui::UiMap, ui::apply, ui::light_colors, ui::load_fonts;
using weaves::Lean, weaves::twill;

using session::Document, session::DocumentView, session::Gesture, session::Intent, session::Intents, session::Settings;
using views::FrameNotes, views::PanelContext;

struct Size {
  int ends, picks;
};
inline constexpr Size kJacquard{1285, 3058}, kLarge{10000, 10000};

/// 32 shafts; with treadling, or with a random liftplan.
inline Design design_of(Size size, ShedControl shed_control) {
  Design design = twill({3, 2, 1, 2, 5, 3, 4, 3, 2, 3, 1, 3}, Lean::kRight, {size.ends, size.picks});
  if (shed_control == ShedControl::kTreadling) return design;
  design = to_liftplan(std::move(design));
  std::mt19937 random(1);
  for (int p = 0; p < size.picks; ++p)
    for (int s = 0; s < design.draft.shafts; ++s) design.draft.liftplan.set(p, s, random() % 2 == 0);
  return design;
}

/// The context of panels without a window.
class Screen {
 public:
  Screen() {
    auto opened = gl::open_headless();
    problem_ = problem_of(opened);
    if (!opened) return;
    context_ = std::move(*opened);
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1600, 1000};
    io.DeltaTime = 1.0f / 60;
    style_.color = light_colors();
    style_.font = load_fonts(1, 1);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    apply(style_);
  }
  ~Screen() {
    if (context_) ImGui::DestroyContext();
  }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  const std::string& problem() const { return problem_; }
  Settings& settings() { return settings_; }
  const Style& style() const { return style_; }
  ImDrawData& drawn() { return *ImGui::GetDrawData(); }

  /// One frame of the document, drawn by draw(PanelContext&). Only its gestures are applied.
  template <typename Draw>
  void frame(const Document& document, DocumentView& view, const Draw& draw) {
    map_.clear();
    tip_.begin(0);
    FrameNotes notes;
    Intents wanted;
    PanelContext c{
        {style_, map_, tip_, focus_}, document.now(), document.cells(), document.revision(), settings_, notes, wanted};
    ImGui::NewFrame();
    draw(c);
    ImGui::Render();
    for (const Intent& one : wanted.take())
      if (const auto* gesture = std::get_if<Gesture>(&one)) gesture->run(view, document.now());
  }

 private:
  std::string problem_, focus_;
  std::unique_ptr<gl::HeadlessContext> context_;
  Style style_;
  UiMap map_;
  Tip tip_;
  Settings settings_;
};

}  // namespace weftlight::bench
