#include "app/panels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/fixed_window.h"
#include "base/text.h"
#include "ui/widgets.h"
#include "views/draft/closest_weave_notice.h"
#include "views/draft/draft_header.h"
#include "views/draft/draft_layout.h"
#include "views/inspector/accuracy_rows.h"
#include "views/inspector/palette_panel.h"
#include "views/inspector/scene_panel.h"
#include "views/inspector/threads_panel.h"
#include "views/inspector/yarn_panel.h"
#include "views/shell/status_bar.h"

namespace weftlight::app {

using base::mark, base::tr;
using session::DocumentView;
using ui::hit_area, ui::segmented, ui::tooltip;
using views::draw_accuracy, views::draw_closest_weave_notice, views::draw_draft, views::draw_draft_header,
    views::draw_palette, views::draw_scene, views::draw_status_bar, views::draw_threads, views::draw_yarns,
    views::fitting_width, views::is_stacked, views::lay_out_window, views::shared_width;

namespace {

/// Of a splitter that a finger drags.
void draw_handle(const PanelContext& c, ImVec2 middle, bool stacked, bool active) {
  const float along = c.style.px(22), across = c.style.px(3);
  const ImVec2 half = stacked ? ImVec2{along, across} : ImVec2{across, along};
  ImGui::GetWindowDrawList()->AddRectFilled({middle.x - half.x, middle.y - half.y},
                                            {middle.x + half.x, middle.y + half.y},
                                            active ? c.style.color.accent : c.style.color.line_strong, across);
}

}  // namespace

Panels::Panels(Editing& editing, const Settings& settings, ClothPane& cloth, LoomWindow& loom, Reports& reports,
               BackgroundTasks& tasks, Messages& messages)
    : editing_(editing),
      settings_(settings),
      cloth_(cloth),
      loom_(loom),
      reports_(reports),
      tasks_(tasks),
      messages_(messages),
      cloth_shown_(settings.cloth) {}

void Panels::draw(PanelContext& c, float tabs_height, const std::string& name, std::span<const ActionItem> items,
                  const StatusTexts& status) {
  const ImGuiViewport* view = ImGui::GetMainViewport();
  const ImVec2 at{view->WorkPos.x, view->WorkPos.y + tabs_height};
  const ImVec2 size{view->WorkSize.x, std::max(0.0f, view->WorkSize.y - tabs_height)};
  const WindowLayout l = lay_out_window(c.style, at, size, split_of(c.style, size),
                                        {.cloth = settings_.cloth, .inspector = settings_.inspector});
  if (editing_.view().at_loom.open) {
    loom_.draw(c, l);
    return draw_status(c, l, status);
  }
  const bool cloth_came_or_went = std::exchange(cloth_shown_, settings_.cloth) != settings_.cloth;
  const bool was_turned = std::exchange(stacked_, l.stacked) != l.stacked;
  if (cloth_came_or_went || was_turned)  // the draft is fitted to its new room
    c.wanted.change_view([](DocumentView& v) { v.draft.pitch = 0; });
  draw_draft_pane(c, l, name, items);
  if (l.cloth.shown() || (l.stacked && l.inspector.shown())) draw_splitter(c, l);
  if (l.cloth.shown()) {
    begin_fixed("Cloth", l.cloth, {0, 0}, kFixed | ImGuiWindowFlags_NoScrollWithMouse);
    cloth_.draw(c);
    ImGui::End();
  }
  if (l.inspector.shown()) draw_inspector(c, l);
  draw_status(c, l, status);
}

void Panels::draw_draft_pane(PanelContext& c, const WindowLayout& l, const std::string& name,
                             std::span<const ActionItem> items) {
  const DocumentView& v = editing_.view();
  // The title of a file stands here only; without a file it is part of the name.
  const bool titled = !editing_.document().path().empty() && !c.design.title.empty();
  begin_fixed("Draft", l.draft, {0, 0}, kFixed | ImGuiWindowFlags_NoScrollWithMouse);
  draw_draft_header(c, titled ? c.design.title : name, v.select.tool, items);
  draw_draft(c, v, reports_.last(), draft_pictures_);
  ImGui::End();
  draw_closest_weave_notice(c, v.rejected_edit, l.draft.at,
                            {l.draft.at.x + l.draft.size.x, l.draft.at.y + l.draft.size.y});
}

void Panels::draw_status(PanelContext& c, const WindowLayout& l, const StatusTexts& status) {
  const DocumentView& v = editing_.view();
  const bool touched = c.style.finger > 0;  // its buttons are as high as the bar
  begin_fixed("Status", l.status, {c.style.px(14), touched ? 0 : c.style.px(6)}, kFixed);
  if (touched) ImGui::AlignTextToFramePadding();
  tasks_.draw(c, status.awaits);
  if (draw_status_bar(c, v.select, v.drawing, status.trouble, messages_.shown(), messages_.remarks()))
    messages_.toggle_remarks();
  ImGui::End();
}

void Panels::draw_inspector(PanelContext& c, const WindowLayout& l) {
  constexpr const char* kTabs[] = {mark("Threads"), mark("Yarns"), mark("Cloth"), mark("Analysis"), mark("Plan")};
  begin_fixed("Inspector", l.inspector, {c.style.px(16), c.style.px(10)}, kFixed);
  int tab = c.focus.starts_with("threads.") ? 0 : c.settings.inspector_tab;
  segmented(c, "inspector", kTabs, tab);
  if (tab != c.settings.inspector_tab) c.wanted.change_settings([tab](Settings& s) { s.inspector_tab = tab; });
  ImGui::Dummy({0, c.style.px(2)});
  ImGui::BeginChild(kTabs[tab], {0, 0});
  const DocumentView& v = editing_.view();
  if (tab == 0) {
    c.wanted.add(draw_palette(c, v.drawing));
    c.wanted.add(draw_threads(c, v.chosen, v.units, typed_threads_));
  } else if (tab == 1) {
    c.wanted.add(draw_yarns(c, v.drawing, strip_));
  } else if (tab == 2) {
    c.wanted.add(draw_scene(c, cloth_.drape()));
    c.wanted.add(draw_accuracy(c));
  } else if (tab == Reports::kInspectorTab) {
    reports_.draw(c);
  } else {
    reports_.draw_plan(c);
  }
  ImGui::EndChild();
  ImGui::End();
}

float Panels::split_of(const Style& style, ImVec2 size) {
  constexpr float kMin = 0.42f, kMax = 0.6f, kAround = 76;  // header and status line, pixels at 96 dpi
  if (settings_.split > 0) return settings_.split;
  if (is_stacked(style, size)) return fitted_split_ = 0.5f;
  const float room = shared_width(style, size.x, settings_.inspector);
  // Computed with the first pitch, and kept while threads are added.
  if (editing_.view().draft.pitch <= 0)
    fitted_split_ = fitting_width(editing_.document().now().draft, settings_, style, room * kMin, room * kMax,
                                  std::max(1.0f, size.y - style.px(kAround))) /
                    room;
  return fitted_split_;
}

void Panels::draw_splitter(PanelContext& c, const WindowLayout& l) const {
  const auto [at, size] = l.splitter;
  begin_fixed("Splitter", l.splitter, {0, 0}, kFixed);
  hit_area("split", size);
  c.map.add_item("split");
  if (ImGui::IsItemHovered() || ImGui::IsItemActive())
    ImGui::SetMouseCursor(l.stacked ? ImGuiMouseCursor_ResizeNS : ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActive()) {
    const ImVec2 by = ImGui::GetIO().MouseDelta;
    const float moved = (l.stacked ? by.y : by.x) / l.room,
                now = std::clamp((c.settings.split > 0 ? c.settings.split : fitted_split_) + moved, 0.2f, 0.8f);
    if (moved != 0) c.wanted.change_settings([now](Settings& s) { s.split = now; });
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    c.wanted.change_settings([](Settings& s) { s.split = 0; });
    c.wanted.change_view([](DocumentView& v) { v.draft.pitch = 0; });
  }
  tooltip(c, tr("Drag to resize the draft. Double-click to fit it."));
  const bool active = ImGui::IsItemActive();
  const ImU32 color = active ? c.style.color.accent : c.style.color.line;
  const ImVec2 middle{at.x + std::floor(size.x / 2), at.y + std::floor(size.y / 2)};
  ImDrawList* dl = ImGui::GetWindowDrawList();
  if (l.stacked) dl->AddRectFilled({at.x, middle.y}, {at.x + size.x, middle.y + 1}, color);
  else dl->AddRectFilled({middle.x, at.y}, {middle.x + 1, at.y + size.y}, color);
  if (c.style.finger > 0) draw_handle(c, middle, l.stacked, active);
  ImGui::End();
}

}  // namespace weftlight::app
