#include "ui/imgui_compat.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui_freetype.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace weftlight::ui {

#if IMGUI_VERSION_NUM >= 18700

namespace {

struct KeyPair {
  int glfw;
  ImGuiKey key;
};
// The keys that text fields, lists and the panels use.
constexpr KeyPair kKeys[] = {{GLFW_KEY_TAB, ImGuiKey_Tab},
                             {GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
                             {GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
                             {GLFW_KEY_UP, ImGuiKey_UpArrow},
                             {GLFW_KEY_DOWN, ImGuiKey_DownArrow},
                             {GLFW_KEY_PAGE_UP, ImGuiKey_PageUp},
                             {GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown},
                             {GLFW_KEY_HOME, ImGuiKey_Home},
                             {GLFW_KEY_END, ImGuiKey_End},
                             {GLFW_KEY_INSERT, ImGuiKey_Insert},
                             {GLFW_KEY_DELETE, ImGuiKey_Delete},
                             {GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
                             {GLFW_KEY_SPACE, ImGuiKey_Space},
                             {GLFW_KEY_ENTER, ImGuiKey_Enter},
                             {GLFW_KEY_KP_ENTER, ImGuiKey_KeypadEnter},
                             {GLFW_KEY_ESCAPE, ImGuiKey_Escape}};

ImGuiKey key_of(int glfw) {
  if (glfw >= GLFW_KEY_A && glfw <= GLFW_KEY_Z) return static_cast<ImGuiKey>(ImGuiKey_A + (glfw - GLFW_KEY_A));
  for (const KeyPair& pair : kKeys)
    if (pair.glfw == glfw) return pair.key;
  return ImGuiKey_None;
}

}  // namespace

void feed_pointer(ImVec2 at) { ImGui::GetIO().AddMousePosEvent(at.x, at.y); }
void feed_button(int button, bool down) { ImGui::GetIO().AddMouseButtonEvent(button, down); }
void feed_wheel(float x, float y) { ImGui::GetIO().AddMouseWheelEvent(x, y); }

void feed_key(int glfw_key, bool down) {
  if (const ImGuiKey key = key_of(glfw_key); key != ImGuiKey_None) ImGui::GetIO().AddKeyEvent(key, down);
}

void feed_modifiers(bool ctrl, bool shift, bool alt, bool super) {
  ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM >= 18837
  io.AddKeyEvent(ImGuiMod_Ctrl, ctrl);
  io.AddKeyEvent(ImGuiMod_Shift, shift);
  io.AddKeyEvent(ImGuiMod_Alt, alt);
  io.AddKeyEvent(ImGuiMod_Super, super);
#else
  io.AddKeyEvent(ImGuiKey_ModCtrl, ctrl);
  io.AddKeyEvent(ImGuiKey_ModShift, shift);
  io.AddKeyEvent(ImGuiKey_ModAlt, alt);
  io.AddKeyEvent(ImGuiKey_ModSuper, super);
#endif
}

void feed_whole_frames() { ImGui::GetIO().ConfigInputTrickleEventQueue = false; }
bool key_pressed(ImGuiKey key, bool repeat) { return ImGui::IsKeyPressed(key, repeat); }
bool letter_down(char letter) { return ImGui::IsKeyDown(static_cast<ImGuiKey>(ImGuiKey_A + (letter - 'A'))); }
bool any_key_down() {
  for (int key = ImGuiKey_Tab; key <= ImGuiKey_KeypadEqual; ++key)
    if (ImGui::IsKeyDown(static_cast<ImGuiKey>(key))) return true;
  return false;
}

#else

void feed_pointer(ImVec2 at) { ImGui::GetIO().MousePos = at; }
void feed_button(int button, bool down) { ImGui::GetIO().MouseDown[button] = down; }

void feed_wheel(float x, float y) {
  ImGui::GetIO().MouseWheelH += x;
  ImGui::GetIO().MouseWheel += y;
}

void feed_key(int glfw_key, bool down) {
  if (glfw_key >= 0 && glfw_key < IM_ARRAYSIZE(ImGuiIO::KeysDown)) ImGui::GetIO().KeysDown[glfw_key] = down;
}

void feed_modifiers(bool ctrl, bool shift, bool alt, bool super) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyCtrl = ctrl;
  io.KeyShift = shift;
  io.KeyAlt = alt;
  io.KeySuper = super;
}

void feed_whole_frames() {}
bool key_pressed(ImGuiKey key, bool repeat) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeat); }
// 1.86 uses the window system's key codes; GLFW's code of a letter is its capital.
bool letter_down(char letter) { return ImGui::IsKeyDown(letter); }
bool any_key_down() { return std::ranges::find(ImGui::GetIO().KeysDown, true) != std::end(ImGui::GetIO().KeysDown); }

#endif

void use_clipboard(const ClipboardFunctions& functions) {
#if IMGUI_VERSION_NUM >= 19110
  static ClipboardFunctions kept;
  kept = functions;
  ImGuiPlatformIO& io = ImGui::GetPlatformIO();
  io.Platform_GetClipboardTextFn = [](ImGuiContext*) { return kept.text(kept.of); };
  io.Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) { kept.set_text(kept.of, text); };
#else
  ImGuiIO& io = ImGui::GetIO();
  io.GetClipboardTextFn = functions.text;
  io.SetClipboardTextFn = functions.set_text;
  io.ClipboardUserData = functions.of;
#endif
}

void use_keyboard(bool on) {
  ImGuiIO& io = ImGui::GetIO();
  if (on) io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  else io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
#if IMGUI_VERSION_NUM < 18700
  io.KeyMap[ImGuiKey_Tab] = on ? -1 : GLFW_KEY_TAB;
#endif
}

unsigned keyboard_item() {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  return g.ActiveId != 0 ? g.ActiveId : g.NavId;
}

bool keyboard_frame_shown() {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
#if IMGUI_VERSION_NUM >= 19140
  const bool shown = g.NavCursorVisible;
#else
  const bool shown = !g.NavDisableHighlight;
#endif
  return shown && g.NavId != 0 && g.ActiveId == 0;
}

void show_keyboard_frame() {
  ImGuiContext& g = *ImGui::GetCurrentContext();
#if IMGUI_VERSION_NUM >= 19140
  g.NavCursorVisible = true;
#else
  g.NavDisableHighlight = false;
#endif
}

void begin_at_first_item() { ImGui::NavInitWindow(ImGui::GetCurrentWindow(), true); }

void use_up_arrow() {
  ImGui::NavMoveRequestCancel();
  ImGuiContext& g = *ImGui::GetCurrentContext();  // the pointer may rest on another menu
#if IMGUI_VERSION_NUM >= 19140
  g.NavHighlightItemUnderNav = true;
#else
  g.NavDisableMouseHover = true;
#endif
}

void draw_keyboard_frame() {
#if IMGUI_VERSION_NUM < 19140
  ImGui::RenderNavHighlight({ImGui::GetItemRectMin(), ImGui::GetItemRectMax()}, ImGui::GetItemID());
#endif
}

void give_keyboard_to_item(bool field) {
  const ImGuiID item = ImGui::GetItemID();
  if (field) return give_keyboard(item);
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  ImGui::ClearActiveID();
  ImGui::SetFocusID(item, window);
  ImGui::GetCurrentContext()->NavDisableMouseHover = true;
  show_keyboard_frame();
  ImGui::ScrollToItem();
}

#if IMGUI_VERSION_NUM >= 18700
void give_keyboard(unsigned) {}
void press_keyboard_item() {}
#else
void give_keyboard(unsigned field) {
  ImGuiContext& g = *ImGui::GetCurrentContext();
  ImGui::ClearActiveID();
  ImGui::SetFocusID(field, ImGui::GetCurrentWindow());
  g.NavNextActivateId = field;
  g.NavNextActivateFlags = ImGuiActivateFlags_PreferInput;
  ImGui::ScrollToItem();
}
void press_keyboard_item() { ImGui::ActivateItem(ImGui::GetCurrentContext()->NavId); }
#endif

ImGuiItemFlags last_item_flags() {
#if IMGUI_VERSION_NUM >= 19120
  return ImGui::GetCurrentContext()->LastItemData.ItemFlags;
#else
  return ImGui::GetCurrentContext()->LastItemData.InFlags;
#endif
}

bool begin_list(const char* id, ImVec2 size) {
#if IMGUI_VERSION_NUM >= 19090
  return ImGui::BeginChild(id, size, ImGuiChildFlags_NavFlattened);
#else
  return ImGui::BeginChild(id, size, false, ImGuiWindowFlags_NavFlattened);
#endif
}

ImTextureID texture_of(unsigned gl_name) {
#if IMGUI_VERSION_NUM >= 19140
  return static_cast<ImTextureID>(gl_name);
#else
  // NOLINTNEXTLINE(performance-no-int-to-ptr): names of textures are pointers in this version of ImGui
  return reinterpret_cast<ImTextureID>(static_cast<intptr_t>(gl_name));
#endif
}

#if IMGUI_VERSION_NUM >= 19200
float font_size(const ImFont* font) { return font->LegacySize; }
void push_font(ImFont* font) { ImGui::PushFont(font, font->LegacySize); }
#else
float font_size(const ImFont* font) { return font->FontSize; }
void push_font(ImFont* font) { ImGui::PushFont(font); }
#endif

float begin_fonts(float ratio) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
#if IMGUI_VERSION_NUM >= 19200
  // Glyphs are rasterised on demand, at the resolution of the framebuffer.
  io.Fonts->SetFontLoader(ImGuiFreeType::GetFontLoader());
  io.Fonts->FontLoaderFlags = ImGuiFreeTypeLoaderFlags_LightHinting;
  return 1 / ratio;
#else
  io.Fonts->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  io.Fonts->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  io.FontGlobalScale = 1 / ratio;
  return 1;
#endif
}

void end_fonts() {
#if IMGUI_VERSION_NUM < 19200
  ImGui::GetIO().Fonts->Build();
#endif
}

float content_right() {
  return ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x - ImGui::GetWindowPos().x;
}

bool begin_padded_child(const char* id, ImVec2 size) {
#if IMGUI_VERSION_NUM >= 19090
  return ImGui::BeginChild(id, size, ImGuiChildFlags_AlwaysUseWindowPadding | ImGuiChildFlags_NavFlattened);
#else
  return ImGui::BeginChild(id, size, false, ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NavFlattened);
#endif
}

}  // namespace weftlight::ui
