#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "base/text.h"
#include "session/shown_keys.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/shell/action_list.h"

namespace weftlight::views {

using base::arg, base::fill, base::tr;
using session::ActionItem;
using ui::content_right, ui::key_pressed, ui::muted_text;

namespace {

char lower(char ch) { return static_cast<char>(std::tolower(static_cast<unsigned char>(ch))); }

constexpr const char* kSeparator = "  \xE2\x80\xBA  ";

struct Match {
  const ActionItem* item;
  int score;
};

std::vector<Match> narrowed(std::span<const ActionItem> items, const std::string& typed) {
  std::vector<Match> out;
  for (const ActionItem& item : items) {
    int score = 0;
    if (matches(item.label, typed, score)) out.push_back({&item, score});
  }
  std::stable_sort(out.begin(), out.end(), [](const Match& a, const Match& b) { return a.score > b.score; });
  return out;
}

void move_choice(CommandPalette& palette, int count) {
  if (key_pressed(ImGuiKey_DownArrow)) ++palette.chosen;
  if (key_pressed(ImGuiKey_UpArrow)) --palette.chosen;
  palette.chosen = std::clamp(palette.chosen, 0, std::max(0, count - 1));
}

std::string draw_matches(const PanelContext& c, const std::vector<Match>& found, CommandPalette& palette) {
  std::string run;
  ImGui::BeginChild("matches",
                    {0, std::clamp(ImGui::GetMainViewport()->WorkSize.y - c.style.px(140), 1.0f, c.style.px(300))});
  for (int i = 0; i < static_cast<int>(found.size()); ++i) {
    const ActionItem& item = *found[static_cast<size_t>(i)].item;
    ImGui::PushID(item.id.c_str());
    ImGui::BeginDisabled(!item.enabled);
    std::string where = item.label;
    if (!item.submenu.empty()) where = tr(item.submenu.c_str()) + (kSeparator + where);
    if (!item.menu.empty()) where = tr(item.menu.c_str()) + (kSeparator + where);
    if (ImGui::Selectable(where.c_str(), i == palette.chosen)) run = item.id;
    ImGui::EndDisabled();
    c.map.add_item("command:" + item.id);
    if (!item.shortcut.empty()) {
      const std::string keys = session::shown_keys(item.shortcut);
      const float width = ImGui::CalcTextSize(keys.c_str()).x;
      ImGui::SameLine(content_right() - width - c.style.px(6));
      muted_text(c, keys);
    }
    ImGui::PopID();
  }
  if (found.empty()) {
    muted_text(c, fill(tr("No command matches \"{typed}\"."), arg("typed", palette.typed)));
    c.map.add_item("commands.none");
  }
  ImGui::EndChild();
  return run;
}

/// Why the chosen command cannot run now; empty if it can.
std::string why_not_now(const std::vector<Match>& found, const CommandPalette& palette) {
  if (found.empty()) return {};
  const ActionItem& item = *found[static_cast<size_t>(palette.chosen)].item;
  if (item.enabled) return {};
  return item.on_selection ? tr("Needs a selection: S, then drag over a grid.") : tr("Not available now.");
}

}  // namespace

bool matches(const std::string& label, const std::string& typed, int& score) {
  score = 0;
  size_t at = 0;
  bool run = false;
  for (char ch : typed) {
    if (ch == ' ') continue;
    const size_t before = at;
    while (at < label.size() && lower(label[at]) != lower(ch)) ++at;
    if (at == label.size()) return false;
    run = run && at == before;
    score += run ? 4 : (at == 0 || label[at - 1] == ' ') ? 3 : 0;
    run = true;
    ++at;
  }
  score = score * 100 - static_cast<int>(label.size());
  return true;
}

std::string draw_command_palette(const PanelContext& c, std::span<const ActionItem> items, CommandPalette& palette) {
  if (!palette.open) return {};
  const ImGuiViewport* view = ImGui::GetMainViewport();
  const float width = std::clamp(view->WorkSize.x - c.style.px(16), 1.0f, c.style.px(520));
  ImGui::SetNextWindowPos({view->WorkPos.x + (view->WorkSize.x - width) / 2, view->WorkPos.y + c.style.px(60)});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, c.style.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, c.style.color.raised);
  ImGui::Begin("Commands", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  if (palette.appearing) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-FLT_MIN);
  const bool enter =
      ImGui::InputTextWithHint("##typed", tr("Type a command"), &palette.typed, ImGuiInputTextFlags_EnterReturnsTrue);
  c.map.add_item("commands.typed");
  if (ImGui::IsItemEdited()) palette.chosen = 0;
  const std::vector<Match> found = narrowed(items, palette.typed);
  move_choice(palette, static_cast<int>(found.size()));
  std::string run = draw_matches(c, found, palette);
  const std::string why = why_not_now(found, palette);
  if (!why.empty()) {
    muted_text(c, why);
    c.map.add_item("commands.why");
  }
  if (enter && !found.empty() && why.empty()) run = found[static_cast<size_t>(palette.chosen)].item->id;
  const bool leave = key_pressed(ImGuiKey_Escape) ||
                     (!palette.appearing && !ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows));
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  palette.appearing = enter;  // what could not run leaves the field open
  if (leave || !run.empty()) palette = {};
  return run;
}

}  // namespace weftlight::views
