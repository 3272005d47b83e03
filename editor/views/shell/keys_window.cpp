#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <string>
#include <utility>

#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/shell/action_list.h"

namespace weftlight::views {
namespace {

struct MouseHint {
  const char *what, *does;
};
constexpr MouseHint kPaintHints[] = {{"Drag", "paint; from a filled cell: clear"},
                                     {"Shift+drag", "keep the thread's other shafts or treadles"},
                                     {"Right drag", "clear"},
                                     {"Ctrl+drag", "select, without changing the tool"},
                                     {"Alt+click on a colour bar", "take that thread's colour and yarn in hand"}};
constexpr MouseHint kShapeHints[] = {{"Drag", "a line or rectangle; from a filled cell: clear"},
                                     {"Shift+drag", "straight or at 45 degrees; a square"},
                                     {"Right drag", "clear"},
                                     {"Escape", "give up what is being drawn"}};
constexpr MouseHint kTypeHints[] = {{"Digits", "a shaft or treadle; then the next thread"},
                                    {"Enter, comma, a second", "take a number that could go on"},
                                    {"0, Delete", "clear the thread and go on; clear and stay"},
                                    {"Space", "turn the cell over, in any grid"},
                                    {"Arrows, Home, End, Tab", "move the cursor; to the next grid"},
                                    {"Escape", "drop the number; done"}};
constexpr MouseHint kSelectHints[] = {{"Drag", "select a rectangle"},
                                      {"Shift+click", "extend it to there"},
                                      {"Drag inside", "move the marks"},
                                      {"Ctrl+drag inside", "copy them"},
                                      {"Right click", "everything that can be done with it"}};
constexpr MouseHint kViewHints[] = {{"Wheel, middle drag", "scroll the draft"},
                                    {"Ctrl+wheel", "larger or smaller cells"}};

constexpr float kKeyColumn = 150;  // pixels at 96 dpi

void row(const PanelContext& c, const std::string& left, const std::string& right) {
  ImGui::TextUnformatted(left.c_str());
  ImGui::SameLine(c.style.px(210));
  muted_text(c, right);
}

void heading(const PanelContext& c, const char* text) {
  ImGui::Dummy({0, c.style.px(4)});
  push_font(c.style.font.bold);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

/// As the table ships it, it is no choice of the weaver's.
void give_key(PanelContext& c, const ActionItem& item, const std::string& key) {
  c.wanted.change_settings([id = item.id, shipped = item.shipped, key](Settings& s) {
    if (key == shipped) s.keys.erase(id);
    else s.keys[id] = key;
  });
}

bool quiet_button(PanelContext& c, const std::string& id, const char* label, const char* tip) {
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.muted);
  const bool pressed = text_button(c, id.c_str(), label, nullptr);
  ImGui::PopStyleColor();
  tooltip(c, tip);
  return pressed;
}

/// The key, as a button that waits for another.
void draw_key(PanelContext& c, const ActionItem& item, bool taken, KeysWindow& w) {
  const bool waits = w.waiting == item.id;
  const std::string label = waits ? "Press keys\xE2\x80\xA6" : item.shortcut.empty() ? "none" : item.shortcut;
  const Colors& k = c.style.color;
  ImGui::PushStyleColor(ImGuiCol_Text, waits ? k.accent : taken ? k.warn : item.shortcut.empty() ? k.muted : k.text);
  ImGui::PushStyleColor(ImGuiCol_Button, with_alpha(waits ? k.accent : k.text, waits ? 0.14f : 0.06f));
  const bool pressed = text_button(c, ("key:" + item.id).c_str(), label.c_str(), nullptr);
  ImGui::PopStyleColor(2);
  if (!waits)
    tooltip(c, taken ? "Another command has the same key; the first in the menus gets it"
                     : "Click, then press the keys that shall run it");
  if (!pressed) return;
  w.waiting = waits ? "" : item.id;
  w.wanted.clear();
}

/// What can be done besides pressing keys.
void draw_choices(PanelContext& c, std::span<const ActionItem> items, const ActionItem& item, KeysWindow& w) {
  if (const ActionItem* holder = w.wanted.empty() ? nullptr : holder_of(items, w.wanted, item.id)) {
    ImGui::Dummy({c.style.px(12), 0});
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.warn);
    ImGui::TextUnformatted(fitted(w.wanted + " runs " + holder->label, c.style.px(280)).c_str());
    ImGui::PopStyleColor();
    if (quiet_button(c, "key.take", "Take it", "It then runs this command, and the other has no key")) {
      give_key(c, *holder, "");
      give_key(c, item, w.wanted);
      w.waiting.clear();
    }
    if (quiet_button(c, "key.leave", "Leave it", "Press other keys")) w.wanted.clear();
    return;
  }
  if (!item.shortcut.empty() && quiet_button(c, "key.none", "None", "Leave it without a key"))
    give_key(c, item, ""), w.waiting.clear();
  if (item.shortcut != item.shipped && quiet_button(c, "key.shipped", "As it was", "The key that it came with"))
    give_key(c, item, item.shipped), w.waiting.clear();
}

void draw_action(PanelContext& c, std::span<const ActionItem> items, const ActionItem& item, KeysWindow& w) {
  ImGui::AlignTextToFramePadding();
  const float column = c.style.px(kKeyColumn);
  const ImVec2 at = ImGui::GetCursorPos();
  draw_key(c, item, holder_of(items, item.shortcut, item.id) != nullptr, w);
  ImGui::SetCursorPos({at.x + column, at.y});
  ImGui::AlignTextToFramePadding();
  const std::string where = item.submenu.empty() ? item.label : item.submenu + ": " + item.label;
  const float room = content_right() - at.x - column - c.style.px(w.waiting == item.id ? 150 : 0);
  ImGui::TextUnformatted(fitted(where, std::max(1.0f, room)).c_str());
  if (w.waiting == item.id) draw_choices(c, items, item, w);
}

/// Without a word those that have a key; else all that match it by name or key.
bool is_listed(const ActionItem& item, const std::string& typed) {
  if (item.id.starts_with("recent:") || item.id.starts_with("view.kept:") || item.menu == "Library") return false;
  int score = 0;
  if (typed.empty()) return !item.shortcut.empty() || item.shortcut != item.shipped;
  return matches(item.label, typed, score) || matches(item.shortcut, typed, score);
}

void draw_keys(PanelContext& c, std::span<const ActionItem> items, KeysWindow& w) {
  std::string menu;
  bool any = false;
  for (const ActionItem& item : items) {
    if (!is_listed(item, w.typed)) continue;
    const std::string own = item.menu.empty() ? "Selection" : item.menu;
    if (own != menu) heading(c, own.c_str());
    menu = own;
    any = true;
    draw_action(c, items, item, w);
  }
  if (!any) muted_text(c, "No command is called that");
}

void draw_mouse(const PanelContext& c) {
  heading(c, "Mouse, paint tool");
  for (const MouseHint& hint : kPaintHints) row(c, hint.what, hint.does);
  heading(c, "Mouse, line and rectangle tools");
  for (const MouseHint& hint : kShapeHints) row(c, hint.what, hint.does);
  heading(c, "Keys, typing numbers");
  for (const MouseHint& hint : kTypeHints) row(c, hint.what, hint.does);
  heading(c, "Mouse, select tool");
  for (const MouseHint& hint : kSelectHints) row(c, hint.what, hint.does);
  heading(c, "Mouse, view");
  for (const MouseHint& hint : kViewHints) row(c, hint.what, hint.does);
}

/// The key that was waited for has come. True when it was Escape, which only ends the waiting.
bool take_pressed(PanelContext& c, std::span<const ActionItem> items, KeysWindow& w) {
  const std::string key = std::exchange(w.pressed, {});
  if (key.empty() || w.waiting.empty()) return false;
  if (key == "Escape") {
    w.waiting.clear();
    w.wanted.clear();
    return true;
  }
  w.wanted = key;
  if (holder_of(items, key, w.waiting) != nullptr) return false;
  for (const ActionItem& item : items)
    if (item.id == w.waiting) give_key(c, item, key);
  w.waiting.clear();
  return false;
}

void draw_search(PanelContext& c, KeysWindow& w, bool any_own) {
  ImGui::SetNextItemWidth(c.style.px(any_own ? 330 : 500));
  ImGui::InputTextWithHint("##typed", "Look for a command or a key", &w.typed);
  c.map.add_item("keys.typed");
  if (any_own && quiet_button(c, "keys.shipped", "All as they were", "Every command gets back the key it came with"))
    c.wanted.change_settings([](Settings& s) { s.keys.clear(); });
}

}  // namespace

const ActionItem* holder_of(std::span<const ActionItem> items, const std::string& key, const std::string& but) {
  if (key.empty()) return nullptr;
  for (const ActionItem& item : items)
    if (item.shortcut == key && item.id != but) return &item;
  return nullptr;
}

void draw_keys_window(PanelContext& c, std::span<const ActionItem> items, KeysWindow& w) {
  if (!w.open) {
    w = {};
    return;
  }
  const bool left_waiting = take_pressed(c, items, w);
  const ImGuiViewport* view = ImGui::GetMainViewport();
  ImGui::SetNextWindowSize({c.style.px(560), c.style.px(600)}, ImGuiCond_Appearing);
  ImGui::SetNextWindowPos({view->WorkPos.x + view->WorkSize.x / 2, view->WorkPos.y + view->WorkSize.y / 2},
                          ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, c.style.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, c.style.color.raised);
  ImGui::PushStyleColor(ImGuiCol_FrameBg, blend(c.style.color.raised, c.style.color.text, 0.06f));
  if (ImGui::Begin("Keys and mouse", &w.open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
    draw_search(c, w, !c.settings.keys.empty());
    ImGui::BeginChild("keys");
    draw_keys(c, items, w);
    if (w.typed.empty()) draw_mouse(c);
    ImGui::EndChild();
    if (!left_waiting && w.waiting.empty() && ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
        key_pressed(ImGuiKey_Escape))
      w.open = false;
  }
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(2);
}

}  // namespace weftlight::views
