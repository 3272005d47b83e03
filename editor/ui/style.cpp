#include "ui/style.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ui/imgui_compat.h"

namespace weftlight::ui {
namespace {

constexpr ImU32 hex(uint32_t rgb) { return IM_COL32((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255, 255); }

ImVec4 vec(ImU32 c, float alpha = 1.0f) {
  ImVec4 v = ImGui::ColorConvertU32ToFloat4(c);
  v.w *= alpha;
  return v;
}

void set_colors(ImVec4* at, const Colors& c) {
  at[ImGuiCol_Text] = vec(c.text);
  at[ImGuiCol_TextDisabled] = vec(c.muted);
  at[ImGuiCol_WindowBg] = vec(c.panel);
  at[ImGuiCol_ChildBg] = vec(c.panel, 0);
  at[ImGuiCol_PopupBg] = vec(c.raised);
  at[ImGuiCol_Border] = vec(c.line);
  at[ImGuiCol_FrameBg] = vec(blend(c.panel, c.text, 0.06f));
  at[ImGuiCol_FrameBgHovered] = vec(blend(c.panel, c.text, 0.10f));
  at[ImGuiCol_FrameBgActive] = vec(blend(c.panel, c.accent, 0.18f));
  at[ImGuiCol_TitleBg] = at[ImGuiCol_TitleBgActive] = vec(c.raised);
  at[ImGuiCol_MenuBarBg] = vec(c.window);
  at[ImGuiCol_ScrollbarBg] = vec(c.panel, 0);
  at[ImGuiCol_ScrollbarGrab] = vec(blend(c.panel, c.text, 0.18f));
  at[ImGuiCol_ScrollbarGrabHovered] = at[ImGuiCol_ScrollbarGrabActive] = vec(blend(c.panel, c.text, 0.35f));
  at[ImGuiCol_CheckMark] = vec(c.accent);
  at[ImGuiCol_SliderGrab] = at[ImGuiCol_SliderGrabActive] = vec(c.accent);
  at[ImGuiCol_Button] = vec(blend(c.panel, c.text, 0.06f));
  at[ImGuiCol_ButtonHovered] = vec(blend(c.panel, c.text, 0.11f));
  at[ImGuiCol_ButtonActive] = vec(blend(c.panel, c.accent, 0.25f));
  at[ImGuiCol_Header] = vec(c.accent, 0.14f);
  at[ImGuiCol_HeaderHovered] = vec(c.accent, 0.10f);
  at[ImGuiCol_HeaderActive] = vec(c.accent, 0.20f);
  at[ImGuiCol_Separator] = vec(c.line);
  at[ImGuiCol_SeparatorHovered] = at[ImGuiCol_SeparatorActive] = vec(c.accent);
  at[ImGuiCol_ResizeGrip] = vec(c.line_strong, 0);
  at[ImGuiCol_ResizeGripHovered] = at[ImGuiCol_ResizeGripActive] = vec(c.line_strong, 0.6f);
  at[ImGuiCol_TextSelectedBg] = vec(c.accent, 0.28f);
  at[kFocusColor] = vec(c.accent, 0.8f);
  at[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, kDim);
}

}  // namespace

Colors light_colors() {
  return {.window = hex(0xECE9E3),
          .panel = hex(0xF7F5F1),
          .raised = hex(0xFFFFFF),
          .line = hex(0xDDD9D1),
          .line_strong = hex(0xB9B3A8),
          .text = hex(0x26241F),
          .muted = hex(0x6B665C),
          .accent = hex(0x2F5597),
          .accent_soft = hex(0xC9D6EE),
          .ink = hex(0x302D28),
          .paper = hex(0xFFFFFF),
          .warn = hex(0x9A5B00),
          .error = hex(0xA8281E)};
}

Colors dark_colors() {
  return {.window = hex(0x17181A),
          .panel = hex(0x1F2124),
          .raised = hex(0x292C30),
          .line = hex(0x34373C),
          .line_strong = hex(0x50555C),
          .text = hex(0xE9E6E0),
          .muted = hex(0xA09C94),
          .accent = hex(0x8DB0F2),
          .accent_soft = hex(0x35486B),
          .ink = hex(0xDCD7CE),
          .paper = hex(0x25282C),
          .warn = hex(0xE3A84F),
          .error = hex(0xF08377)};
}

void apply(const Style& style) {
  ImGuiStyle& s = ImGui::GetStyle();
  s = ImGuiStyle();
  set_colors(s.Colors, style.color);
  s.WindowPadding = ImVec2(12, 10);
  s.FramePadding = ImVec2(8, 5);
  s.ItemSpacing = ImVec2(8, 6);
  s.ItemInnerSpacing = ImVec2(6, 4);
  s.WindowMinSize = ImVec2(1, 1);
  s.WindowRounding = 0;
  s.ChildRounding = s.FrameRounding = s.GrabRounding = 5;
  s.PopupRounding = 8;
  s.WindowBorderSize = 0;
  s.PopupBorderSize = 1;
  s.FrameBorderSize = 0;
  s.ScrollbarSize = 10;
  s.ScrollbarRounding = 5;
  s.WindowMenuButtonPosition = ImGuiDir_None;
  s.ScaleAllSizes(style.scale);
  if (style.finger <= 0) return;
  // Frames of the smallest letters are as high as a finger needs.
  s.FramePadding.y = std::max(s.FramePadding.y, std::ceil((style.finger - font_size(style.font.small)) / 2));
  s.ScrollbarSize = style.px(16);
}

void dim_behind_dialogs(float dim) { ImGui::GetStyle().Colors[ImGuiCol_ModalWindowDimBg].w = dim; }

ImU32 blend(ImU32 from, ImU32 to, float t) {
  ImU32 out = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const float a = static_cast<float>((from >> shift) & 255), b = static_cast<float>((to >> shift) & 255);
    out |= static_cast<ImU32>(std::lround(a + (b - a) * std::clamp(t, 0.0f, 1.0f))) << shift;
  }
  return out;
}

ImU32 with_alpha(ImU32 color, float alpha) {
  return (color & ~IM_COL32_A_MASK) | (static_cast<ImU32>(std::lround(alpha * 255)) << IM_COL32_A_SHIFT);
}

ImU32 choices_background(const Colors& colors) { return blend(colors.panel, colors.text, 0.08f); }

ImU32 chosen_background(const Style& style) {
  return style.dark ? blend(style.color.raised, style.color.text, 0.16f) : style.color.raised;
}

ImU32 note_background(const Colors& colors) { return with_alpha(colors.panel, 0.94f); }

ImU32 reading_color(ImU32 c) {
  // Luma of the encoded colour (ITU-R BT.601 weights) is close enough to choose between two.
  const ImVec4 v = ImGui::ColorConvertU32ToFloat4(c);
  const float luma = 0.299f * v.x + 0.587f * v.y + 0.114f * v.z;
  return luma > 0.55f ? IM_COL32(24, 22, 18, 255) : IM_COL32(255, 255, 255, 255);
}

}  // namespace weftlight::ui
