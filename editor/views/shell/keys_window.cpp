#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "session/shown_keys.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/shell/action_list.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr;
using session::ActionItem, session::Settings, session::shown_keys;
using ui::Colors, ui::blend, ui::content_right, ui::fitted, ui::key_pressed, ui::muted_text, ui::push_font,
    ui::text_button, ui::tooltip, ui::with_alpha;

namespace {

struct MouseHint {
  const char *input, *effect;  // marked texts
};
constexpr MouseHint kPaintHints[] = {
    {mark("Drag"), mark("paint; from a filled cell: clear")},
    {mark("Shift+drag"), mark("keep the thread's other shafts or treadles")},
    {mark("Right drag"), mark("clear")},
    {mark("Ctrl+drag"), mark("select, without changing the tool")},
    {mark("Alt+click on a colour bar"), mark("pick the colour and yarn of that thread")}};
constexpr MouseHint kShapeHints[] = {{mark("Drag"), mark("draw a line or rectangle; from a filled cell: clear")},
                                     {mark("Shift+drag"), mark("straight or at 45 degrees; square")},
                                     {mark("Right drag"), mark("clear")},
                                     {mark("Escape"), mark("cancel the shape")}};
constexpr MouseHint kTypeHints[] = {
    {mark("Digits"), mark("set a shaft or treadle; then the next thread")},
    {mark("Enter, comma, a pause"), mark("finish a number that could have more digits")},
    {mark("0, Delete"), mark("clear the thread and go on; clear and stay")},
    {mark("Space"), mark("invert the cell, in any grid")},
    {mark("Arrows, Home, End, Tab"), mark("move the cursor; to the next grid")},
    {mark("Escape"), mark("discard the number; leave the tool")}};
constexpr MouseHint kSelectHints[] = {{mark("Drag"), mark("select a rectangle")},
                                      {mark("Shift+click"), mark("extend the selection")},
                                      {mark("Drag inside"), mark("move the selected cells")},
                                      {mark("Ctrl+drag inside"), mark("copy them")},
                                      {mark("Right click"), mark("menu of the selection")}};
constexpr MouseHint kViewHints[] = {{mark("Wheel, middle drag"), mark("scroll the draft")},
                                    {mark("Ctrl+wheel"), mark("zoom the draft")}};

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

/// Only shortcuts that differ from the default are saved.
void assign_key(PanelContext& c, const ActionItem& item, const std::string& key) {
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

/// The shortcut, as a button that waits for a new one.
void draw_key(PanelContext& c, const ActionItem& item, bool taken, KeysWindow& w) {
  const bool waits = w.waiting == item.id;
  const std::string label = waits                   ? tr("Press keys\xE2\x80\xA6")
                            : item.shortcut.empty() ? tr("none")
                                                    : shown_keys(item.shortcut);
  const Colors& k = c.style.color;
  ImGui::PushStyleColor(ImGuiCol_Text, waits ? k.accent : taken ? k.warn : item.shortcut.empty() ? k.muted : k.text);
  ImGui::PushStyleColor(ImGuiCol_Button, with_alpha(waits ? k.accent : k.text, waits ? 0.14f : 0.06f));
  const bool pressed = text_button(c, ("key:" + item.id).c_str(), label.c_str(), nullptr);
  ImGui::PopStyleColor(2);
  if (!waits)
    tooltip(c, taken ? tr("Another command has the same shortcut; the first one in the menus takes precedence")
                     : tr("Click, then press the new shortcut"));
  if (!pressed) return;
  w.waiting = waits ? "" : item.id;
  w.requested.clear();
}

/// The buttons beside a shortcut that waits for a key.
void draw_choices(PanelContext& c, std::span<const ActionItem> items, const ActionItem& item, KeysWindow& w) {
  if (const ActionItem* holder = w.requested.empty() ? nullptr : action_with_key(items, w.requested, item.id)) {
    ImGui::Dummy({c.style.px(12), 0});
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.warn);
    ImGui::TextUnformatted(fitted(fill(tr("{key} is used by {command}"), arg("key", shown_keys(w.requested)),
                                       arg("command", holder->label)),
                                  c.style.px(280))
                               .c_str());
    ImGui::PopStyleColor();
    if (quiet_button(c, "key.take", tr("Reassign"), tr("Assign it to this command; the other one loses it"))) {
      assign_key(c, *holder, "");
      assign_key(c, item, w.requested);
      w.waiting.clear();
    }
    if (quiet_button(c, "key.leave", tr("Cancel"), tr("Press other keys"))) w.requested.clear();
    return;
  }
  if (!item.shortcut.empty() && quiet_button(c, "key.none", tr("Clear"), tr("Remove the shortcut")))
    assign_key(c, item, ""), w.waiting.clear();
  if (item.shortcut != item.shipped &&
      quiet_button(c, "key.shipped", tr("Default"), tr("Restore the default shortcut")))
    assign_key(c, item, item.shipped), w.waiting.clear();
}

void draw_action(PanelContext& c, std::span<const ActionItem> items, const ActionItem& item, KeysWindow& w) {
  ImGui::AlignTextToFramePadding();
  const float column = c.style.px(kKeyColumn);
  const ImVec2 at = ImGui::GetCursorPos();
  draw_key(c, item, action_with_key(items, item.shortcut, item.id) != nullptr, w);
  ImGui::SetCursorPos({at.x + column, at.y});
  ImGui::AlignTextToFramePadding();
  const std::string where = item.submenu.empty() ? item.label
                                                 : fill(tr("{menu}: {command}"), arg("menu", tr(item.submenu.c_str())),
                                                        arg("command", item.label));
  const float room = content_right() - at.x - column - c.style.px(w.waiting == item.id ? 150 : 0);
  ImGui::TextUnformatted(fitted(where, std::max(1.0f, room)).c_str());
  if (w.waiting == item.id) draw_choices(c, items, item, w);
}

/// Without a search text, the actions with a shortcut; otherwise all whose name or shortcut has it.
Fit listed_as(const ActionItem& item, const std::string& typed) {
  if (item.id.starts_with("recent:") || item.id.starts_with("view.kept:") || item.menu == "Library") return Fit::kNone;
  if (typed.empty()) return !item.shortcut.empty() || item.shortcut != item.shipped ? Fit::kWord : Fit::kNone;
  return std::max(fit_of(item.label, typed), fit_of(shown_keys(item.shortcut), typed));
}

/// By menus; those that have the search text inside of their words only come after all others.
void draw_keys(PanelContext& c, std::span<const ActionItem> items, KeysWindow& w) {
  std::vector<const ActionItem*> listed, inside;
  for (const ActionItem& item : items)
    if (const Fit fit = listed_as(item, w.typed); fit != Fit::kNone)
      (fit == Fit::kInside ? inside : listed).push_back(&item);
  listed.insert(listed.end(), inside.begin(), inside.end());
  std::string menu;
  for (const ActionItem* item : listed) {
    const std::string own = item->menu.empty() ? mark("Selection") : item->menu;
    if (own != menu) heading(c, tr(own.c_str()));
    menu = own;
    draw_action(c, items, *item, w);
  }
  if (listed.empty()) muted_text(c, tr("No command matches."));
}

void draw_mouse(const PanelContext& c) {
  const auto group = [&c](const char* title, std::span<const MouseHint> hints) {
    heading(c, title);
    for (const MouseHint& hint : hints) row(c, tr(hint.input), tr(hint.effect));
  };
  group(tr("Mouse: paint tool"), kPaintHints);
  group(tr("Mouse: line and rectangle tools"), kShapeHints);
  group(tr("Keys: typing numbers"), kTypeHints);
  group(tr("Mouse: select tool"), kSelectHints);
  group(tr("Mouse: view"), kViewHints);
}

/// Handles the key that was pressed for a waiting action. True if it was Escape, which only cancels.
bool handle_pressed(PanelContext& c, std::span<const ActionItem> items, KeysWindow& w) {
  const std::string key = std::exchange(w.pressed, {});
  if (key.empty() || w.waiting.empty()) return false;
  if (key == "Escape") {
    w.waiting.clear();
    w.requested.clear();
    return true;
  }
  w.requested = key;
  if (action_with_key(items, key, w.waiting) != nullptr) return false;
  for (const ActionItem& item : items)
    if (item.id == w.waiting) assign_key(c, item, key);
  w.waiting.clear();
  return false;
}

void draw_search(PanelContext& c, KeysWindow& w, bool any_own) {
  ImGui::SetNextItemWidth(c.style.px(any_own ? 330 : 500));
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();  // else letters would choose tools behind the window
  ImGui::InputTextWithHint("##typed", tr("Search commands and shortcuts"), &w.typed);
  c.map.add_item("keys.typed");
  if (any_own &&
      quiet_button(c, "keys.shipped", tr("Restore all"), tr("Restore the default shortcut of every command")))
    c.wanted.change_settings([](Settings& s) { s.keys.clear(); });
}

}  // namespace

const ActionItem* action_with_key(std::span<const ActionItem> items, const std::string& key,
                                  const std::string& except) {
  if (key.empty()) return nullptr;
  for (const ActionItem& item : items)
    if (item.shortcut == key && item.id != except) return &item;
  return nullptr;
}

void draw_keys_window(PanelContext& c, std::span<const ActionItem> items, KeysWindow& w) {
  if (!w.open) {
    w = {};
    return;
  }
  const bool left_waiting = handle_pressed(c, items, w);
  const ImGuiViewport* view = ImGui::GetMainViewport();
  ImGui::SetNextWindowSize({c.style.px(560), c.style.px(600)}, ImGuiCond_Appearing);
  ImGui::SetNextWindowPos({view->WorkPos.x + view->WorkSize.x / 2, view->WorkPos.y + view->WorkSize.y / 2},
                          ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, c.style.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, c.style.color.raised);
  ImGui::PushStyleColor(ImGuiCol_FrameBg, blend(c.style.color.raised, c.style.color.text, 0.06f));
  if (ImGui::Begin(tr("Keyboard and mouse"), &w.open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
    draw_search(c, w, !c.settings.keys.empty());
    ImGui::BeginChild("keys");
    draw_keys(c, items, w);
    if (w.typed.empty()) draw_mouse(c);
    ImGui::EndChild();
    w.focused = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
    if (!left_waiting && w.waiting.empty() && w.focused && key_pressed(ImGuiKey_Escape) && !c.frame.popup_closed)
      w.open = false;
  }
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(2);
}

}  // namespace weftlight::views
