#include "views/cloth/preview_panel.h"

#include <algorithm>
#include <cmath>

#include "analysis/units.h"
#include "base/text.h"
#include "cloth/cloth.h"
#include "design/methods.h"
#include "light/formulas.h"
#include "scene/named_views.h"
#include "session/editing/true_distance.h"
#include "session/jobs/reference_tracer.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/cloth/cloth_rulers.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using cloth::srgb_from_linear;
using design::Design, design::Method, design::NamedView, design::kShadedMethods, design::method_facts;
using scene::ShippedView, scene::kShippedViews;
using session::Compare, session::DocumentView, session::Edit, session::Settings, session::kDifferenceScale,
    session::orbited, session::wrapped_degrees, session::zoomed;
using ui::Colors, ui::Style, ui::blend, ui::fitted, ui::fixed, ui::font_size, ui::hit_area, ui::letter_down,
    ui::note_background, ui::push_font, ui::segmented, ui::texture_of, ui::tooltip;

namespace {

using Panel = ViewContext<ClothView>;

constexpr const char* kHint =
    mark("Drag: turn the cloth; Shift+drag: move it; wheel: zoom; right drag (or L): move the light");
constexpr float kDegreesAPixel = 0.35f;

Edit move_light(ImVec2 by, float degrees_a_px) {
  return {tr("Move light"), [=](Design d) {
            d.scene.light_azimuth = wrapped_degrees(d.scene.light_azimuth + by.x * degrees_a_px);
            d.scene.light_elevation = std::clamp(d.scene.light_elevation - by.y * degrees_a_px, 0.0f, 90.0f);
            return d;
          }};
}

/// Leaves grazing light, so that the light that moves is the one shown.
void move_the_light(Panel& c, ImVec2 by, float degrees_a_px) {
  if (c.view.flat && c.view.grazing) c.wanted.change_view([](DocumentView& v) { v.cloth.grazing = false; });
  c.wanted.add(move_light(by, degrees_a_px));
}

bool light_key_down() { return letter_down('L') && !ImGui::GetIO().WantTextInput && !ImGui::GetIO().KeyCtrl; }

void drag(Panel& c, ImVec2 size) {
  const ImVec2 by = ImGui::GetIO().MouseDelta;
  if (by.x == 0 && by.y == 0) return;
  const float per_px = kDegreesAPixel / c.style.scale;
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  if (ImGui::IsMouseDown(ImGuiMouseButton_Right) || (left && light_key_down())) return move_the_light(c, by, per_px);
  if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) || (left && ImGui::GetIO().KeyShift))
    c.wanted.change_view([by, size](DocumentView& v) {
      v.cloth.camera.pan_x += by.x / size.x;
      v.cloth.camera.pan_y -= by.y / size.x;
    });
  else if (left)
    c.wanted.change_view([=](DocumentView& v) { v.cloth.camera = orbited(v.cloth.camera, by.x, by.y, per_px); });
}

void draw_note(const PanelContext& c, ImVec2 at, const std::string& text) {
  ImFont* font = c.style.font.small;
  const ImVec2 size = font->CalcTextSizeA(font_size(font), FLT_MAX, 0, text.c_str());
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const float x = c.style.px(8), y = c.style.px(4);
  dl->AddRectFilled({at.x - x, at.y - y}, {at.x + size.x + x, at.y + size.y + y}, note_background(c.style.color),
                    c.style.px(5));
  dl->AddText(font, font_size(font), at, c.style.color.muted, text.c_str());
}

/// The width of a note in a pane.
float note_room(const PanelContext& c, float pane_width) { return std::max(0.0f, pane_width - c.style.px(32)); }

bool is_room_for(const PanelContext& c, const std::string& text, float pane_width) {
  ImFont* font = c.style.font.small;
  return font->CalcTextSizeA(font_size(font), FLT_MAX, 0, text.c_str()).x <= note_room(c, pane_width);
}

std::string note_that_fits(const PanelContext& c, const std::string& text, float pane_width) {
  push_font(c.style.font.small);
  std::string shown = fitted(text, note_room(c, pane_width));
  ImGui::PopFont();
  return shown;
}

/// "yarn 80%, cell 20%".
std::string weights_text(const std::array<float, 4>& weights) {
  std::string text;
  for (size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] < 0.005f) continue;
    text.append(text.empty() ? "" : ", ")
        .append(fill(tr("{method} {percent:.0f}%"), arg("method", tr(method_facts(kShadedMethods[i]).label)),
                     arg("percent", 100 * weights[i])));
  }
  return text;
}

std::string error_text(const PreviewPicture& p, bool with_limit) {
  const float error = 100 * p.stats.estimated_error;
  if (!with_limit || p.stats.method != Method::kAuto || p.tolerance <= 0)
    return fill(tr("error about {error:.0f}%"), arg("error", error));
  if (p.budget_ms > 0)
    return fill(tr("error about {error:.0f}% in {limit:.0f} ms"), arg("error", error), arg("limit", p.budget_ms));
  return fill(tr("error about {error:.0f}%, limit {limit:.0f}%"), arg("error", error), arg("limit", 100 * p.tolerance));
}

std::vector<std::string> stats_parts(const PreviewPicture& p, bool with_limit) {
  std::vector<std::string> parts{tr(method_facts(p.stats.method).label)};
  if (p.stats.method == Method::kAuto) parts.push_back(weights_text(p.stats.method_weights));
  if (p.stats.gpu_ms > 0)
    parts.push_back(
        fill(tr("{time} ms"), arg("time", fixed(static_cast<float>(p.stats.gpu_ms), p.stats.gpu_ms < 10 ? 1 : 0))));
  if (p.stats.yarns_per_pixel > 0) {
    const float yarns = p.stats.yarns_per_pixel;
    parts.push_back(yarns < 1 ? fill(tr("{count:.1f} px per yarn"), arg("count", 1 / yarns))
                              : fill(tr("{count:.1f} yarns per px"), arg("count", yarns)));
  }
  if (p.stats.estimated_error > 0) parts.push_back(error_text(p, with_limit));
  return parts;
}

/// What there is room for: first without the limit of the error, then without the last parts.
std::string stats_line(const PanelContext& c, const PreviewPicture& p, float pane_width) {
  const std::string gap = "   ";
  const std::string busy = p.busy ? gap + tr("updating\xE2\x80\xA6") : "";
  const auto line = [&](const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text.append(text.empty() ? "" : gap).append(part);
    return text + busy;
  };
  std::vector<std::string> parts = stats_parts(p, true);
  if (!is_room_for(c, line(parts), pane_width)) parts = stats_parts(p, false);
  while (parts.size() > 1 && !is_room_for(c, line(parts), pane_width)) parts.pop_back();
  return line(parts);
}

/// The legend of the methods in false colours.
void draw_method_legend(const PanelContext& c, ImVec2 at, Method method) {
  if (method != Method::kAuto) return draw_note(c, at, tr("Only the automatic method mixes several"));
  ImFont* font = c.style.font.small;
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const float line = font_size(font) + c.style.px(4), box = c.style.px(10), pad = c.style.px(8);
  float width = 0;
  for (const Method m : kShadedMethods)
    width = std::max(width, font->CalcTextSizeA(font_size(font), FLT_MAX, 0, tr(method_facts(m).label)).x);
  width += box + c.style.px(6);
  dl->AddRectFilled({at.x - pad, at.y - pad / 2}, {at.x + width + pad, at.y + 4 * line + pad / 2},
                    note_background(c.style.color), c.style.px(5));
  for (size_t row = 0; row < kShadedMethods.size(); ++row) {
    const float y = at.y + (line - box) / 2;
    const glm::vec3 k = formulas::method_color(static_cast<int>(row));
    dl->AddRectFilled({at.x, y}, {at.x + box, y + box}, to_u32(srgb_from_linear({k.r, k.g, k.b})), 2);
    dl->AddText(font, font_size(font), {at.x + box + c.style.px(6), at.y + c.style.px(2)}, c.style.color.text,
                tr(method_facts(kShadedMethods[row]).label));
    at.y += line;
  }
}

std::string reference_line(const ReferencePicture& r, Compare compare) {
  if (!r.problem.empty()) return r.problem;
  if (r.texture == 0) return tr("Ray tracing\xE2\x80\xA6");
  std::string line = compare == Compare::kSplit
                         ? std::string(tr("ray traced"))
                         : fill(tr("difference \xC3\x97 {factor:.0f}"), arg("factor", kDifferenceScale));
  const auto say = [&line](const std::string& text) { line.append("   ").append(text); };
  if (r.samples == 0) say(tr("coarse"));
  else say(fill(tr_n("{count} sample per pixel", "{count} samples per pixel", r.samples), arg("count", r.samples)));
  if (r.samples > 0) say(fill(tr("error {percent:.1f}%"), arg("percent", 100 * r.difference)));
  return r.tracing ? line + "\xE2\x80\xA6" : line;
}

/// The handle of the comparison. Called before the view below it, so that it gets the pointer first.
void drag_split(PanelContext& c, ImVec2 a, ImVec2 pane) {
  const float half = c.style.px(7), x = a.x + pane.x * c.settings.compare_split;
  ImGui::SetCursorScreenPos({x - half, a.y});
  hit_area("compare", {2 * half, pane.y});
  c.map.add_item("view.compare");
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    c.frame.hint = tr("Drag the divider: preview on the left, ray traced on the right");
  }
  if (ImGui::IsItemActive() && !ImGui::IsItemActivated())
    c.wanted.change_settings([to = std::clamp((ImGui::GetIO().MousePos.x - a.x) / pane.x, 0.02f, 0.98f)](Settings& s) {
      s.compare_split = to;
    });
  ImGui::SetCursorScreenPos(a);
}

/// `note_y` is where its note stands, below the buttons.
void draw_comparison(const PanelContext& c, const ReferencePicture& r, ImVec2 a, ImVec2 b, float note_y) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const float x = std::floor(a.x + (b.x - a.x) * c.settings.compare_split);
  if (r.texture != 0) {
    dl->PushClipRect({x, a.y}, b, true);
    dl->AddImage(texture_of(r.texture), a, b);
    dl->PopClipRect();
    c.map.add(r.samples > 0 ? "view.reference" : "view.reference.coarse", x, a.y, b.x - x, b.y - a.y);
  }
  const float grip = c.style.px(9), y = (a.y + b.y) / 2;
  dl->AddRectFilled({x - 1, a.y}, {x + 1, b.y}, c.style.color.raised);
  dl->AddRectFilled({x - c.style.px(4), y - 2 * grip}, {x + c.style.px(4), y + 2 * grip}, c.style.color.raised,
                    c.style.px(4));
  dl->AddRect({x - c.style.px(4), y - 2 * grip}, {x + c.style.px(4), y + 2 * grip}, c.style.color.line_strong,
              c.style.px(4));
  const std::string text = note_that_fits(c, reference_line(r, c.settings.compare), b.x - a.x);
  ImFont* font = c.style.font.small;
  const ImVec2 size = font->CalcTextSizeA(font_size(font), FLT_MAX, 0, text.c_str());
  const ImVec2 at{b.x - size.x - c.style.px(16), note_y};
  draw_note(c, at, text);
  c.map.add("view.comparison", at.x, at.y, size.x, size.y);
}

void draw_problem(const PanelContext& c, ImVec2 a, ImVec2 b, const std::string& text) {
  const float width = std::min(b.x - a.x - c.style.px(48), c.style.px(420));
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
  ImGui::GetWindowDrawList()->AddText(c.style.font.text, font_size(c.style.font.text),
                                      {(a.x + b.x - size.x) / 2, (a.y + b.y - size.y) / 2}, c.style.color.muted,
                                      text.c_str(), nullptr, width);
}

void draw_views_menu(PanelContext& c) {
  const auto item = [&c](const std::string& label, const std::string& id, const char* key = nullptr) {
    if (ImGui::MenuItem(label.c_str(), key)) c.wanted.add_action(id);
    c.map.add_item("views." + id);
  };
  for (const ShippedView& view : kShippedViews) item(tr(view.label), std::string("view.") + view.id);
  if (!c.design.views.empty()) ImGui::Separator();
  for (const NamedView& view : c.design.views) item(view.name, "view.kept:" + view.name);
  ImGui::Separator();
  item(tr("True distance"), "true_distance");
  item(tr("Save view as\xE2\x80\xA6"), "view_keep_as");
  if (!c.design.views.empty()) item(tr("Rename or delete views\xE2\x80\xA6"), "views_change");
}

// The buttons over the picture, pixels at 96 dpi.
constexpr float kWaysWidth = 120, kViewsWidth = 64, kGrazingWidth = 72, kButtonGap = 8, kButtonMargin = 14;

/// Wider where a language has a longer word.
float button_width(const PanelContext& c, const char* label, float usual) {
  return std::max(c.style.px(usual), ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x);
}

void draw_views_button(PanelContext& c, ImVec2 at, float width) {
  const Colors& k = c.style.color;
  ImGui::SetCursorScreenPos(at);
  ImGui::PushStyleColor(ImGuiCol_Button, blend(k.panel, k.text, 0.08f));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, blend(k.panel, k.text, 0.14f));
  if (ImGui::Button(tr("Views"), {width, 0})) ImGui::OpenPopup("views");
  c.map.add_item("views");
  tooltip(c, tr("Views of the cloth, and your own, which are saved with the draft"));
  ImGui::PopStyleColor(2);
  ImGui::SetNextWindowPos({at.x, at.y + ImGui::GetFrameHeight() + c.style.px(4)});
  if (ImGui::BeginPopup("views")) {
    draw_views_menu(c);
    ImGui::EndPopup();
  }
}

/// While the swatch is flat.
void draw_grazing_button(Panel& c, ImVec2 at, float width) {
  const Colors& k = c.style.color;
  const bool on = c.view.grazing;
  ImGui::SetCursorScreenPos(at);
  ImGui::PushStyleColor(ImGuiCol_Button, on ? k.accent_soft : blend(k.panel, k.text, 0.08f));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, on ? k.accent_soft : blend(k.panel, k.text, 0.14f));
  if (ImGui::Button(tr("Grazing"), {width, 0})) c.wanted.add_action("grazing");
  c.map.add_item(on ? "grazing.on" : "grazing");
  tooltip(c, tr("Light low from the side, which shows the relief of every thread"));
  ImGui::PopStyleColor(2);
}

/// Draped or flat, and the views, at the upper right; in a narrow pane one below the other. Called before the view
/// below them, so that they get the pointer first. Returns their lower edge.
float draw_view_buttons(Panel& c, ImVec2 a, ImVec2 pane) {
  constexpr const char* kWays[] = {mark("Drape"), mark("Flat")};
  const Style& s = c.style;
  const float margin = s.px(kButtonMargin), row = ImGui::GetFrameHeight() + s.px(6);
  if (pane.x < s.px(kWaysWidth) + 2 * margin || pane.y < 2 * row) return a.y;
  ImDrawList* dl = ImGui::GetWindowDrawList();
  dl->ChannelsSetCurrent(1);
  const float right = a.x + pane.x - margin;
  ImVec2 left{right - s.px(kWaysWidth), a.y + s.px(12)};
  // Places a button to the left, or in the next row.
  const auto place = [&](float width) {
    left.x -= width + s.px(kButtonGap);
    if (left.x < a.x + margin) left = {right - width, left.y + row};
    return left;
  };
  ImGui::SetCursorScreenPos(left);
  int way = c.view.flat ? 1 : 0;
  if (segmented(c, "hanging", kWays, way, s.px(kWaysWidth))) c.wanted.add_action("flat");
  const float views = button_width(c, tr("Views"), kViewsWidth);
  draw_views_button(c, place(views), views);
  if (c.view.flat) {
    const float grazing = button_width(c, tr("Grazing"), kGrazingWidth);
    draw_grazing_button(c, place(grazing), grazing);
  }
  dl->ChannelsSetCurrent(0);
  ImGui::SetCursorScreenPos(a);
  return left.y + ImGui::GetFrameHeight();
}

// The bar of the true distance, pixels at 96 dpi.
constexpr float kBarMargin = 14, kBarSlider = 200;

std::string true_distance_text(const Panel& c) {
  return fill(
      tr("The cloth as it looks from {distance}: {percent:.0f}% of its real size on a screen {eyes} away"),
      arg("distance", session::distance_text(c.settings.seen_from_m, c.settings.imperial)),
      arg("percent", 100 * session::true_scale(c.settings)),
      arg("eyes", analysis::width_text(static_cast<double>(c.settings.eye_to_screen_cm) * 10, units_of(c.settings))));
}

/// How far the weaver stands from the cloth, at the lower edge. Called before the view below it, as are the buttons.
void draw_true_distance(Panel& c, ImVec2 a, ImVec2 pane) {
  if (!c.view.flat || !c.view.true_distance) return;
  const Style& s = c.style;
  ImDrawList* dl = ImGui::GetWindowDrawList();
  dl->ChannelsSetCurrent(1);
  const ClothRulers rulers = rulers_of(c, c.view);
  const float margin = s.px(kBarMargin), pad = s.px(8);
  const float width = std::max(s.px(60), pane.x - rulers.wide - 2 * margin - 2 * pad);
  const std::string text = true_distance_text(c);
  push_font(s.font.small);
  const ImVec2 words = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
  ImGui::PopFont();
  const float row = ImGui::GetFrameHeight(), high = words.y + row + s.px(6) + 2 * pad;
  const ImVec2 from{a.x + rulers.wide + margin, a.y + pane.y - rulers.high - s.px(40) - high};
  dl->AddRectFilled(from, {from.x + width + 2 * pad, from.y + high}, note_background(s.color), s.px(6));
  dl->AddText(s.font.small, font_size(s.font.small), {from.x + pad, from.y + pad}, s.color.text, text.c_str(), nullptr,
              width);
  ImGui::SetCursorScreenPos({from.x + pad, from.y + pad + words.y + s.px(6)});
  const char* card = tr("Measure the screen\xE2\x80\xA6");
  const float button = ImGui::CalcTextSize(card).x + 2 * ImGui::GetStyle().FramePadding.x;
  float metres = c.settings.seen_from_m;
  ImGui::SetNextItemWidth(std::max(s.px(40), std::min(s.px(kBarSlider), width - button - s.px(8))));
  // The words above it say the figure.
  if (ImGui::SliderFloat("##seen_from", &metres, session::kNearestSeen_m, session::kFurthestSeen_m, "",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput))
    c.wanted.change_settings([metres](Settings& to) {
      to.seen_from_m = std::clamp(metres, session::kNearestSeen_m, session::kFurthestSeen_m);
    });
  c.map.add_item("view.seen_from");
  const bool imperial = c.settings.imperial;
  tooltip(c, fill(tr("How far you stand from the cloth, {nearest} to {furthest}"),
                  arg("nearest", session::distance_text(session::kNearestSeen_m, imperial)),
                  arg("furthest", session::distance_text(session::kFurthestSeen_m, imperial)))
                 .c_str());
  ImGui::SameLine(0, s.px(8));
  if (ImGui::Button(card)) c.wanted.add_action("measure_screen");
  c.map.add_item("view.measure_screen");
  dl->ChannelsSetCurrent(0);
  ImGui::SetCursorScreenPos(a);
}

/// The wheel over the cloth: nearer or further; `x`, `y` from the middle of the pane.
void turn_wheel(Panel& c, float steps, float x, float y) {
  if (c.view.flat && c.view.true_distance)
    return c.wanted.change_settings(
        [steps](Settings& s) { s.seen_from_m = session::stepped_distance_m(s.seen_from_m, steps); });
  c.wanted.change_view([=](DocumentView& v) { v.cloth.camera = zoomed(v.cloth.camera, steps, x, y); });
}

void draw_view(Panel& c, const PreviewPicture& picture, ImVec2& pane) {
  const ImVec2 a = ImGui::GetCursorScreenPos();
  pane = ImGui::GetContentRegionAvail();
  const ImVec2 b{a.x + pane.x, a.y + pane.y};
  if (pane.x < 8 || pane.y < 8) return;
  const bool comparing = c.settings.compare != Compare::kOff;
  if (comparing) drag_split(c, a, pane);
  const float below_buttons = draw_view_buttons(c, a, pane);
  draw_true_distance(c, a, pane);
  hit_area("view", pane,
           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  c.map.add_item("view");
  if (ImGui::IsItemActive() && !ImGui::IsItemActivated()) drag(c, pane);
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) c.frame.hint = tr(kHint);
  if (ImGui::IsItemHovered() && io.MouseWheel != 0)
    turn_wheel(c, io.MouseWheel, (io.MousePos.x - (a.x + b.x) / 2) / pane.x,
               ((a.y + b.y) / 2 - io.MousePos.y) / pane.x);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) c.wanted.add_action("reset_view");

  ImDrawList* dl = ImGui::GetWindowDrawList();
  if (picture.texture != 0) {
    dl->AddImage(texture_of(picture.texture), a, b, {0, 1}, {1, 0});
    if (comparing) draw_comparison(c, picture.reference, a, b, below_buttons + c.style.px(14));
    if (c.settings.show_methods)
      draw_method_legend(c, {a.x + rulers_of(c, c.view).wide + c.style.px(16), a.y + c.style.px(14)},
                         picture.stats.method);
    const ClothRulers rulers = rulers_of(c, c.view);
    draw_cloth_rulers(dl, c, c.view, rulers, a, b);
    draw_note(c, {a.x + rulers.wide + c.style.px(16), b.y - rulers.high - c.style.px(24)},
              note_that_fits(c, stats_line(c, picture, pane.x - rulers.wide), pane.x - rulers.wide));
    c.map.add("view.picture", a.x, a.y, pane.x, pane.y);
  } else {
    // Before the first picture: its background. A problem is shown on the colour of the panel.
    dl->AddRectFilled(a, b, picture.problem.empty() ? to_u32(c.design.scene.background) : c.style.color.panel);
  }
  if (picture.busy) c.map.add("view.busy", a.x, a.y, pane.x, pane.y);
  if (picture.refining) c.map.add("view.refining", a.x, a.y, pane.x, pane.y);
  if (!picture.problem.empty() && picture.texture == 0) draw_problem(c, a, b, picture.problem);
  else if (!picture.problem.empty()) draw_note(c, {a.x + c.style.px(16), a.y + c.style.px(12)}, picture.problem);
}

}  // namespace

void draw_preview(const PanelContext& panel, const ClothView& view, const PreviewPicture& picture, ImVec2& pane) {
  Panel c{panel, view};
  ImDrawList* dl = ImGui::GetWindowDrawList();
  dl->ChannelsSplit(2);
  draw_view(c, picture, pane);
  dl->ChannelsMerge();
}

}  // namespace weftlight::views
