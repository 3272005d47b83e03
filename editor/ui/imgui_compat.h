#pragma once
// What differs between the versions of Dear ImGui that Weftlight takes, 1.86 (Debian 12) to 1.92: how input is fed,
// how keys are named, how fonts are held. Nothing outside this file asks for a version.

#include <imgui.h>

#include "ui/names.h"

#if IMGUI_VERSION_NUM < 18600
#error "Weftlight takes Dear ImGui 1.86 or newer"
#endif

namespace weftlight::ui {

#if IMGUI_VERSION_NUM >= 19140
inline constexpr ImGuiCol kFocusColor = ImGuiCol_NavCursor;
#else
inline constexpr ImGuiCol kFocusColor = ImGuiCol_NavHighlight;
#endif

/// Which of the window system's moves ImGui shall see in this frame, after its backend's own new frame. The pointer is
/// fed in every frame.
void feed_pointer(ImVec2 at);
void feed_button(int button, bool down);
void feed_wheel(float x, float y);
/// By GLFW's code.
void feed_key(int glfw_key, bool down);
void feed_modifiers(bool ctrl, bool shift, bool alt, bool super);
/// The events of a frame are told apart by the caller, not by ImGui.
void feed_whole_frames();

/// Pressed in this frame.
bool key_pressed(ImGuiKey key, bool repeat = true);
/// 'A' to 'Z', held.
bool letter_down(char letter);

ImTextureID texture_of(unsigned gl_name);

/// Pixels of a loaded font.
float font_size(const ImFont* font);
void push_font(ImFont* font);
/// Starts the atlas anew, drawn by FreeType, for `ratio` framebuffer pixels a window unit. Fonts are to be added at
/// the answered share of their size in framebuffer pixels.
float begin_fonts(float ratio);
void end_fonts();

/// Right edge of what the window holds, from its left edge.
float content_right();
/// A child whose own padding parts it from what it holds.
bool begin_padded_child(const char* id, ImVec2 size);

}  // namespace weftlight::ui
