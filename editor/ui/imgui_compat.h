#pragma once
// What differs between the supported versions of Dear ImGui, 1.86 (Debian 12) to 1.92: input, key names, fonts. No
// other file checks the version.

#include <imgui.h>

#if IMGUI_VERSION_NUM < 18600
#error "Weftlight takes Dear ImGui 1.86 or newer"
#endif

namespace weftlight::ui {

#if IMGUI_VERSION_NUM >= 19140
inline constexpr ImGuiCol kFocusColor = ImGuiCol_NavCursor;
#else
inline constexpr ImGuiCol kFocusColor = ImGuiCol_NavHighlight;
#endif

/// The input that ImGui sees in this frame; call after the new frame of its backend. Feed the pointer in every frame.
void feed_pointer(ImVec2 at);
void feed_button(int button, bool down);
void feed_wheel(float x, float y);
/// By GLFW's key code.
void feed_key(int glfw_key, bool down);
void feed_modifiers(bool ctrl, bool shift, bool alt, bool super);
/// The caller splits input into frames; ImGui must not do it again.
void feed_whole_frames();

/// True if pressed in this frame.
bool key_pressed(ImGuiKey key, bool repeat = true);
/// True while the letter, 'A' to 'Z', is held.
bool letter_down(char letter);

ImTextureID texture_of(unsigned gl_name);

/// Height of a loaded font in pixels.
float font_size(const ImFont* font);
void push_font(ImFont* font);
/// Clears the atlas and selects FreeType, for `ratio` framebuffer pixels per window unit. Multiply the sizes of added
/// fonts, in framebuffer pixels, by the returned factor.
float begin_fonts(float ratio);
void end_fonts();

/// Right edge of the window's content, from the window's left edge.
float content_right();
/// A child window that has padding.
bool begin_padded_child(const char* id, ImVec2 size);

}  // namespace weftlight::ui
