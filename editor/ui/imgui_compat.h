#pragma once
// What differs between the supported versions of Dear ImGui, 1.86 (Debian 12) to 1.92: input, key names, fonts. No
// other file checks the version.

#include <imgui.h>
#include <imgui_internal.h>

#if IMGUI_VERSION_NUM < 18600
#error "Weftlight takes Dear ImGui 1.86 or newer"
#endif

namespace weftlight::ui {

#if IMGUI_VERSION_NUM >= 19140
inline constexpr ImGuiCol kFocusColor = ImGuiCol_NavCursor;
#else
inline constexpr ImGuiCol kFocusColor = ImGuiCol_NavHighlight;
#endif

/// An invisible button that takes the keyboard.
#if IMGUI_VERSION_NUM >= 19140
inline constexpr ImGuiButtonFlags kTakesKeyboard = ImGuiButtonFlags_EnableNav;
#else
inline constexpr ImGuiButtonFlags kTakesKeyboard = 0;
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
/// True while any key of the keyboard is held.
bool any_key_down();

// The keyboard in dialogs and menus (keyboard.h).

/// True where ImGui walks with Tab through text fields only, and where Enter presses no button.
#if IMGUI_VERSION_NUM >= 18700
inline constexpr bool kOwnTabKey = false, kOwnEnterKey = false;
#else
inline constexpr bool kOwnTabKey = true, kOwnEnterKey = true;
#endif
/// Lets ImGui use arrows and Space, from the next frame on.
void use_keyboard(bool on);
/// The item that has the keyboard, or 0.
unsigned keyboard_item();
/// True if a frame shows which item has it, and it does not take text.
bool keyboard_frame_shown();
/// Shows that frame.
void show_keyboard_frame();
/// Gives the keyboard to the first item of the menu or dialog that is being drawn; call before its items.
void begin_at_first_item();
/// The arrow that was pressed is used up: ImGui leads it nowhere.
void use_up_arrow();
/// Draws it around the item drawn last, where ImGui does not.
void draw_keyboard_frame();
/// Gives the keyboard to the item drawn last; a text field is opened.
void give_keyboard_to_item(bool field);
/// Opens a text field of the current window in the next frame.
void give_keyboard(unsigned field);
/// Presses the item that has the keyboard, in the next frame.
void press_keyboard_item();
ImGuiItemFlags last_item_flags();
/// A list that the arrows enter and leave.
bool begin_list(const char* id, ImVec2 size);

/// Where text fields and panels copy to and paste from, instead of the backend's own way. `text` may give null; what it
/// gives stays until it is called again. `of` is passed to both.
struct ClipboardFunctions {
  const char* (*text)(void* of);
  void (*set_text)(void* of, const char* text);
  void* of;
};
void use_clipboard(const ClipboardFunctions& functions);

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
