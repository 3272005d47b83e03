#include "ui/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

#include "base/decimals.h"
#include "base/text.h"
#include "ui/imgui_compat.h"

namespace weftlight::ui {

using base::tr, base::with_decimal_point;

namespace {

constexpr float kLabelColumn = 112, kFigureColumn = 70;  // pixels at 96 dpi
constexpr double kTipDelayS = 0.45;

float track_position(const SliderSpec& spec, float value) {
  const float t = (value - spec.min) / (spec.max - spec.min);
  return std::clamp(spec.logarithmic ? std::log1p(std::max(t, 0.0f) * 20) / std::log1p(20.0f) : t, 0.0f, 1.0f);
}

/// One value: a filled track with a knob. A range: the track between two smaller knobs.
void draw_track(const Context& c, const SliderSpec& spec, const SliderSpan& span, ImVec2 a, ImVec2 b,
                bool highlighted) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const Colors& k = c.style.color;
  const bool mixed = span.low != span.high;
  const float y = static_cast<float>(static_cast<int>((a.y + b.y) / 2)), r = c.style.px(highlighted ? 7 : 6),
              h = c.style.px(2);
  const auto at = [&](float value) { return a.x + r + (b.x - a.x - 2 * r) * track_position(spec, value); };
  const float low = at(span.low), high = at(span.high);
  const ImU32 fill = span.inherited ? blend(k.panel, k.accent, 0.45f) : k.accent;
  dl->AddRectFilled({a.x, y - h}, {b.x, y + h}, blend(k.panel, k.text, 0.14f), h);
  dl->AddRectFilled({mixed ? low : a.x, y - h}, {high, y + h}, fill, h);
  for (const float x : {low, high}) {
    const float radius = mixed ? r - c.style.px(2) : r;
    dl->AddCircleFilled({x, y}, radius, c.style.dark ? k.text : k.raised);
    dl->AddCircle({x, y}, radius, highlighted ? k.accent : k.line_strong, 0, 1.2f);
    if (!mixed) break;
  }
}

/// Inverse of track_position: the value at `t` of the track, 0..1.
float value_at(const SliderSpec& s, float t) {
  t = std::clamp(t, 0.0f, 1.0f);
  if (s.logarithmic) t = std::expm1(t * std::log1p(20.0f)) / 20.0f;
  return s.min + (s.max - s.min) * t;
}

bool drag_track(const Context& c, const SliderSpec& spec, ImVec2 a, ImVec2 b, float& value) {
  if (!ImGui::IsItemActive()) return false;
  const float r = c.style.px(6);
  const float next = value_at(spec, (ImGui::GetIO().MousePos.x - a.x - r) / std::max(1.0f, b.x - a.x - 2 * r));
  if (next == value || (!ImGui::IsItemActivated() && !ImGui::IsMouseDragging(ImGuiMouseButton_Left, 0))) return false;
  value = next;
  return true;
}

enum class FigureAlign { kRight, kMiddle };

void draw_figure(const char* text, FigureAlign align, ImU32 color) {
  const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax(), size = ImGui::CalcTextSize(text);
  const float x =
      align == FigureAlign::kRight ? b.x - ImGui::GetStyle().FramePadding.x - size.x : (a.x + b.x - size.x) / 2;
  ImGui::GetWindowDrawList()->AddText(
      {static_cast<float>(static_cast<int>(x)), static_cast<float>(static_cast<int>((a.y + b.y - size.y) / 2))}, color,
      text);
}

/// While a number is typed, a comma does for the point, as weavers of most languages write it.
void take_commas_as_points() {
  for (ImWchar& c : ImGui::GetIO().InputQueueCharacters)
    if (c == ',') c = '.';
}

/// The figure: drag it, or click to type. Its text is drawn here, because ImGui would centre it and cannot show
/// "mixed".
bool figure(const Context& c, const SliderSpec& spec, bool mixed, FigureAlign align, ImU32 color, float& value) {
  push_font(c.style.font.mono_small);
  float typed = value;
  const bool typing = ImGui::TempInputIsActive(ImGui::GetID("##figure"));
  if (typing) take_commas_as_points();
  else ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(0, 0, 0, 0));
  take_focus(c, spec.id);
  const bool wider = spec.figure_min < spec.figure_max;
  const float low = wider ? spec.figure_min : spec.min, high = wider ? spec.figure_max : spec.max;
  const bool changed = ImGui::DragFloat("##figure", &typed, (spec.max - spec.min) / 400, low, high, spec.format,
                                        ImGuiSliderFlags_AlwaysClamp);
  if (!typing) {
    ImGui::PopStyleColor();
    char text[48];
    std::snprintf(text, sizeof text, spec.format, static_cast<double>(typed));
    draw_figure(mixed && !changed ? tr("mixed") : with_decimal_point(text).c_str(), align, color);
  }
  ImGui::PopFont();
  if (changed) value = typed;
  return changed;
}

/// As high as the controls beside it, though its letters are smaller: all have one middle.
void push_figure_padding(const Context& c) {
  const float pad = std::max(0.0f, (ImGui::GetFrameHeight() - font_size(c.style.font.mono_small)) / 2);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {c.style.px(3), pad});
}

/// In the column of figures, `room_after` pixels before the end.
bool column_figure(const Context& c, const SliderSpec& spec, const SliderSpan& span, float& value) {
  ImGui::PushStyleColor(ImGuiCol_FrameBg, IM_COL32(0, 0, 0, 0));
  push_figure_padding(c);
  ImGui::SetNextItemWidth(span.room_after > 0 ? -span.room_after : -FLT_MIN);
  const bool mixed = span.low != span.high;
  const ImU32 color = mixed || span.inherited ? c.style.color.muted : c.style.color.text;
  const bool changed = figure(c, spec, mixed, FigureAlign::kRight, color, value);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  return changed;
}

}  // namespace

SliderSpec translated(SliderSpec spec) {
  spec.label = tr(spec.label);
  spec.format = tr(spec.format);
  spec.tip = tr(spec.tip);
  return spec;
}

bool span_slider(const Context& c, const SliderSpec& spec, const SliderSpan& span, float& value) {
  ImGui::PushID(spec.id);
  row_label(c, spec.label, spec.tip);
  const float width =
      std::max(c.style.px(40), ImGui::GetContentRegionAvail().x - c.style.px(kFigureColumn) - span.room_after);
  hit_area("track", {width, ImGui::GetFrameHeight()});
  c.map.add_item(spec.id);
  const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
  bool changed = drag_track(c, spec, a, b, value);
  const SliderSpan shown = changed ? SliderSpan{value, value, false, span.room_after} : span;
  draw_track(c, spec, shown, a, b, ImGui::IsItemHovered() || ImGui::IsItemActive());
  tooltip(c, spec.tip);
  ImGui::SameLine();
  changed |= column_figure(c, spec, shown, value);
  c.map.add_item(std::string(spec.id) + ":figure");
  ImGui::PopID();
  return changed;
}

bool slider(const Context& c, const SliderSpec& spec, float& value) {
  return span_slider(c, spec, {value, value, false, 0}, value);
}

bool number_field(const Context& c, const SliderSpec& spec, bool mixed, float width, float& value) {
  ImGui::PushID(spec.id);
  ImGui::SetNextItemWidth(width);
  push_figure_padding(c);
  const bool changed =
      figure(c, spec, mixed, FigureAlign::kMiddle, mixed ? c.style.color.muted : c.style.color.text, value);
  ImGui::PopStyleVar();
  c.map.add_item(spec.id);
  tooltip(c, spec.tip);
  ImGui::PopID();
  return changed;
}

void draw_swatch(const Context& c, ImVec2 a, ImVec2 b, ImU32 color, bool chosen) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const float r = c.style.px(4);
  dl->AddRectFilled(a, b, color, r);
  dl->AddRect(a, b, with_alpha(c.style.color.text, 0.25f), r);
  if (chosen) dl->AddRect({a.x - 2, a.y - 2}, {b.x + 2, b.y + 2}, c.style.color.accent, r + 2, 0, 2.0f);
}

void take_focus(const Context& c, const char* id) {
  if (c.focus != id) return;
  ImGui::SetKeyboardFocusHere();
  c.focus.clear();
}

void row_label(const Context& c, const char* label, const char* tip) {
  ImGui::AlignTextToFramePadding();
  const float x = ImGui::GetCursorPosX();
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.muted);
  ImGui::TextUnformatted(label);
  ImGui::PopStyleColor();
  tooltip(c, tip);
  // A label longer than its column moves its own row only.
  const float field = x + std::max(c.style.px(kLabelColumn), ImGui::GetItemRectSize().x + c.style.px(6));
  ImGui::SameLine();
  ImGui::SetCursorPosX(field);  // SameLine's own offset counts from the group
}

void buttons_row(const Context& c, std::span<const char* const> labels) {
  const ImGuiStyle& style = ImGui::GetStyle();
  float width = 0;
  for (const char* label : labels)
    width += ImGui::CalcTextSize(label).x + 2 * style.FramePadding.x + (width > 0 ? style.ItemSpacing.x : 0);
  if (width <= ImGui::GetContentRegionAvail().x - c.style.px(kLabelColumn)) row_label(c, "", "");
}

void begin_rows(const Context& c) {
  ImVec2 spacing = ImGui::GetStyle().ItemSpacing;  // between rows, which ImGui adds to their height
  spacing.y = std::max(spacing.y, c.style.finger - ImGui::GetFontSize());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, spacing);
}

void end_rows() { ImGui::PopStyleVar(); }

bool begin_combo(const Context& c, const char* id, const char* shown) {
  ImGui::PushID(id);
  const ImGuiComboFlags tall = c.style.finger > 0 ? ImGuiComboFlags_HeightLarge : ImGuiComboFlags_None;
  const float r = c.style.px(4), arrow = c.style.px(14);  // its size, and its middle from the right edge
  const std::string text = fitted(shown, ImGui::CalcItemWidth() - arrow - 2 * r - ImGui::GetStyle().FramePadding.x);
  const bool open = ImGui::BeginCombo("##combo", text.c_str(), ImGuiComboFlags_NoArrowButton | tall);
  if (!open) {
    c.map.add_item(id);
    const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
    const float x = b.x - arrow, y = (a.y + b.y) / 2;
    ImDrawList* dl = ImGui::GetWindowDrawList();
    dl->AddTriangleFilled({x - r, y - r / 2}, {x + r, y - r / 2}, {x, y + r * 0.7f}, c.style.color.muted);
    if (text != shown) tooltip(c, shown);
    ImGui::PopID();
    return false;
  }
  begin_rows(c);
  return true;
}

void end_combo() {
  end_rows();
  ImGui::EndCombo();
  ImGui::PopID();
}

namespace {

/// Equal widths where every label has room beside it; else each by its label, with the same room beside all of them,
/// and all no wider than there is room.
std::vector<float> segment_widths(const Context& c, std::span<const char* const> labels, float width) {
  std::vector<float> widths;
  float widest = 0, sum = 0;
  for (const char* label : labels) {
    widths.push_back(ImGui::CalcTextSize(tr(label)).x + c.style.px(8));
    widest = std::max(widest, widths.back());
    sum += widths.back();
  }
  const auto count = static_cast<float>(labels.size());
  const float each = static_cast<float>(static_cast<int>(width / count));
  if (widest + c.style.px(8) <= each) return std::vector<float>(labels.size(), each);
  const float room = std::max(width, std::min(sum, ImGui::GetContentRegionAvail().x));
  const float spare = std::max(0.0f, room - sum) / count, shrunk = std::min(1.0f, room / sum);
  for (float& own : widths) own = static_cast<float>(static_cast<int>(own * shrunk + spare));
  return widths;
}

}  // namespace

bool segmented(const Context& c, const char* id, std::span<const char* const> labels, int& chosen, float width) {
  const auto count = static_cast<int>(labels.size());
  if (width <= 0) width = ImGui::GetContentRegionAvail().x;
  const float h = ImGui::GetFrameHeight();
  const std::vector<float> widths = segment_widths(c, labels, width);
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float r = ImGui::GetStyle().FrameRounding;
  dl->AddRectFilled(at, {std::accumulate(widths.begin(), widths.end(), at.x), at.y + h},
                    choices_background(c.style.color), r);
  bool changed = false;
  float x = at.x;
  ImGui::PushID(id);
  for (int i = 0; i < count; ++i) {
    const char* label = labels[static_cast<size_t>(i)];
    const float own = widths[static_cast<size_t>(i)];
    const std::string shown = fitted(tr(label), own - c.style.px(2));
    const ImVec2 a{x, at.y}, b{x + own, a.y + h};
    x = b.x;
    ImGui::SetCursorScreenPos(a);
    if (hit_area(label, {own, h}) && chosen != i) {
      chosen = i;
      changed = true;
    }
    c.map.add_item(std::string(id) + ":" + label);
    const bool on = chosen == i;
    c.map.controls.back().tab_stop &= on;
    if (on) {
      dl->AddRectFilled({a.x + 2, a.y + 2}, {b.x - 2, b.y - 2}, chosen_background(c.style), r - 1);
      dl->AddRect({a.x + 2, a.y + 2}, {b.x - 2, b.y - 2}, c.style.color.line, r - 1);
    }
    const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
    dl->AddText({static_cast<float>(static_cast<int>((a.x + b.x - size.x) / 2)),
                 static_cast<float>(static_cast<int>((a.y + b.y - size.y) / 2))},
                on || ImGui::IsItemHovered() ? c.style.color.text : c.style.color.muted, shown.c_str());
  }
  ImGui::PopID();
  return changed;
}

void open_section(const char* id) { ImGui::GetStateStorage()->SetBool(ImGui::GetID(id), true); }

bool section(const Context& c, const char* id, const char* label, bool open_at_first) {
  ImGuiStorage* memory = ImGui::GetStateStorage();
  const ImGuiID key = ImGui::GetID(id);
  bool open = memory->GetBool(key, open_at_first);
  ImGui::Dummy({0, c.style.px(2)});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, h = ImGui::GetFrameHeight();
  if (hit_area(id, {width, h})) memory->SetBool(key, open = !open);
  c.map.add_item(id);
  ImDrawList* dl = ImGui::GetWindowDrawList();
  dl->AddRectFilled({at.x, at.y - c.style.px(3)}, {at.x + width, at.y - c.style.px(3) + 1}, c.style.color.line);
  ImFont* font = c.style.font.bold;
  const float x = at.x + c.style.px(14);
  dl->AddText(font, font_size(font), {x, at.y + (h - font_size(font)) / 2}, c.style.color.text, label);
  // A triangle that points right if closed and down if open.
  const float r = c.style.px(4);
  const ImVec2 m{at.x + r + 1, at.y + h / 2};
  if (open)
    dl->AddTriangleFilled({m.x - r, m.y - r / 2}, {m.x + r, m.y - r / 2}, {m.x, m.y + r * 0.7f}, c.style.color.muted);
  else
    dl->AddTriangleFilled({m.x - r / 2, m.y - r}, {m.x - r / 2, m.y + r}, {m.x + r * 0.7f, m.y}, c.style.color.muted);
  return open;
}

bool icon_button(const Context& c, const char* id, const char* icon, const char* word, const char* tip, bool enabled) {
  ImGui::PushID(id);
  ImGui::BeginDisabled(!enabled);
  ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
  const bool glyph = c.style.font.icons;
  const float side = ImGui::GetFrameHeight();
  const bool pressed = ImGui::Button(glyph ? icon : word, glyph ? ImVec2{side + c.style.px(4), side} : ImVec2{0, 0});
  ImGui::PopStyleColor();
  ImGui::EndDisabled();
  ImGui::PopID();
  c.map.add_item(id);
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) tooltip(c, tip);
  return pressed;
}

bool text_button(const Context& c, const char* id, const char* label, const char* tip) {
  ImGui::PushID(id);
  const bool pressed = ImGui::Button(label);
  ImGui::PopID();
  c.map.add_item(id);
  tooltip(c, tip);
  return pressed;
}

bool hit_area(const char* id, ImVec2 size, ImGuiButtonFlags flags) {
  // ImGui asserts on an empty size, and a tiny window has empty panes.
  const bool pressed =
      ImGui::InvisibleButton(id, {std::max(1.0f, size.x), std::max(1.0f, size.y)}, flags | kTakesKeyboard);
  draw_keyboard_frame();
  return pressed;
}

bool list_row(const Context& c, const char* id, const char* label, bool chosen, float height) {
  ImGui::PushID(id);
  begin_rows(c);
  const bool pressed = ImGui::Selectable(label, chosen, ImGuiSelectableFlags_SelectOnNav, {0, height});
  end_rows();
  ImGui::PopID();
  if (chosen && ImGui::IsWindowAppearing()) ImGui::SetItemDefaultFocus();
  c.map.add_row(id, chosen);
  return pressed;
}

void close_popups() { ImGui::ClosePopupToLevel(0, true); }

void tooltip(const Context& c, const char* tip) {
  if (tip == nullptr || *tip == 0 || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  if (ImGui::IsItemActive()) return;
  const ImVec2 at = ImGui::GetItemRectMin();
  const bool shown = c.tip.shown && c.tip.x == at.x && c.tip.y == at.y;
  if (!shown && c.tip.rest_s < kTipDelayS) return;
  c.tip = {c.tip.rest_s, shown, true, at.x, at.y};
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {c.style.px(10), c.style.px(7)});
  push_font(c.style.font.small);
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.text);  // not that of the control
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(c.style.px(280));
  ImGui::TextUnformatted(tip);
  ImGui::PopTextWrapPos();
  const ImVec2 a = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  c.map.add("tip", a.x, a.y, size.x, size.y);
  ImGui::EndTooltip();
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::PopStyleVar();
}

std::string fitted(const std::string& text, float width) {
  constexpr const char* kEllipsis = "\xE2\x80\xA6";
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  std::string start = text;
  while (!start.empty() && ImGui::CalcTextSize((start + kEllipsis).c_str()).x > width) {
    // Remove whole UTF-8 characters: continuation bytes start with the bits 10.
    while (start.size() > 1 && (static_cast<unsigned char>(start.back()) & 0xC0) == 0x80) start.pop_back();
    start.pop_back();
  }
  return start + kEllipsis;
}

void muted_text(const Context& c, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.muted);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

std::string fixed(float value, int decimals) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", decimals, static_cast<double>(value));
  return with_decimal_point(text);
}

}  // namespace weftlight::ui
