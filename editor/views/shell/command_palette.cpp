#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <sstream>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/text.h"
#include "base/utf8.h"
#include "session/shown_keys.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/shell/action_list.h"

namespace weftlight::views {

using base::arg, base::fill, base::plain_latin, base::tr, base::utf8_sequence;
using session::ActionItem;
using ui::content_right, ui::key_pressed, ui::muted_text;

namespace {

/// In small letters without marks, and with blanks for dots and dashes.
std::string plain(std::string_view text) {
  std::string out;
  for (size_t at = 0; at < text.size();) {
    uint32_t code = 0;
    const size_t length = std::max<size_t>(1, utf8_sequence(text.substr(at), code));
    const std::string latin = code >= 0x2000 && code < 0x2070 ? " " : plain_latin(code);
    out += latin.empty() ? text.substr(at, length) : latin;
    at += length;
  }
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

std::vector<std::string> words_of(const std::string& typed) {
  std::istringstream read(plain(typed));
  return {std::istream_iterator<std::string>(read), {}};
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
}

/// Both in plain letters.
Fit fit_of_word(std::string_view label, std::string_view word) {
  Fit best = Fit::kNone;
  for (size_t at = label.find(word); at != std::string_view::npos; at = label.find(word, at + 1)) {
    const size_t end = at + word.size();
    const bool begins = at == 0 || !is_letter(label[at - 1]) || !is_letter(word.front());
    const bool ends = end == label.size() || !is_letter(label[end]) || !is_letter(word.back());
    best = std::max(best, !begins ? Fit::kInside : ends ? Fit::kWord : Fit::kBeginning);
  }
  return best;
}

Fit fit_of_words(std::string_view label, const std::vector<std::string>& words) {
  Fit worst = Fit::kWord;
  for (const std::string& word : words) worst = std::min(worst, fit_of_word(label, word));
  return worst;
}

constexpr const char* kSeparator = "  \xE2\x80\xBA  ";

void move_choice(CommandPalette& palette, int count) {
  if (key_pressed(ImGuiKey_DownArrow)) ++palette.chosen;
  if (key_pressed(ImGuiKey_UpArrow)) --palette.chosen;
  palette.chosen = std::clamp(palette.chosen, 0, std::max(0, count - 1));
}

std::string draw_matches(const PanelContext& c, const std::vector<const ActionItem*>& found, CommandPalette& palette) {
  std::string run;
  ImGui::BeginChild("matches",
                    {0, std::clamp(ImGui::GetMainViewport()->WorkSize.y - c.style.px(140), 1.0f, c.style.px(300))});
  for (int i = 0; i < static_cast<int>(found.size()); ++i) {
    const ActionItem& item = *found[static_cast<size_t>(i)];
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
std::string why_not_now(const std::vector<const ActionItem*>& found, const CommandPalette& palette) {
  if (found.empty()) return {};
  const ActionItem& item = *found[static_cast<size_t>(palette.chosen)];
  if (item.enabled) return {};
  return item.on_selection ? tr("Needs a selection: S, then drag over a grid.") : tr("Not available now.");
}

}  // namespace

Fit fit_of(const std::string& label, const std::string& typed) { return fit_of_words(plain(label), words_of(typed)); }

std::vector<const ActionItem*> found_actions(std::span<const ActionItem> items, const std::string& typed) {
  const std::vector<std::string> words = words_of(typed);
  // Labels that begin with the first word before others, and of these the shortest.
  using Rank = std::tuple<Fit, bool, ptrdiff_t>;
  std::vector<std::pair<Rank, const ActionItem*>> ranked;
  for (const ActionItem& item : items) {
    const std::string label = plain(item.label);
    const Fit fit = fit_of_words(label, words);
    if (fit == Fit::kNone) continue;
    ranked.emplace_back(words.empty() ? Rank() : Rank(fit, label.starts_with(words.front()), -std::ssize(label)),
                        &item);
  }
  std::ranges::stable_sort(ranked, std::greater(), [](const auto& one) { return one.first; });
  std::vector<const ActionItem*> found;
  for (const auto& [rank, item] : ranked) found.push_back(item);
  return found;
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
  const std::vector<const ActionItem*> found = found_actions(items, palette.typed);
  move_choice(palette, static_cast<int>(found.size()));
  std::string run = draw_matches(c, found, palette);
  const std::string why = why_not_now(found, palette);
  if (!why.empty()) {
    muted_text(c, why);
    c.map.add_item("commands.why");
  }
  if (enter && !found.empty() && why.empty()) run = found[static_cast<size_t>(palette.chosen)]->id;
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
