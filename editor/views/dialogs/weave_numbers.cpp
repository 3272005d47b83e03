// The list of weaves by family and the parameters of one, shared by both weave dialogs.

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <sstream>
#include <utility>

#include "base/text.h"
#include "base/utf8.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {

using base::arg, base::fill, base::tr;
using ui::begin_combo, ui::begin_padded_child, ui::end_combo, ui::fitted, ui::key_pressed, ui::letter_down,
    ui::muted_text, ui::row_label, ui::tooltip;
using weaves::ParameterKind, weaves::WeaveKind, weaves::WeaveParameter, weaves::WeaveValues, weaves::allowed_values,
    weaves::weave_kinds;

namespace {

/// What the user reads for a value of a choice.
const char* name_of(const WeaveParameter& n, const std::string& value) {
  const auto at = std::ranges::find(n.choices, value);
  const auto place = static_cast<size_t>(at - n.choices.begin());
  return tr(place < n.names.size() ? n.names[place] : value.c_str());
}

/// True if `value` changed.
bool pick_from(PanelContext& c, const WeaveParameter& n, const std::vector<std::string>& choices, std::string& value) {
  const std::string id = std::string("weave.").append(n.id), before = value;
  if (!begin_combo(c, id.c_str(), name_of(n, value))) return false;
  for (const std::string& choice : choices) {
    if (ImGui::Selectable(name_of(n, choice), value == choice)) value = choice;
    c.map.add_item(id + ":" + choice);
  }
  end_combo();
  return value != before;
}

bool draw_count(PanelContext& c, const WeaveParameter& n, std::string& value) {
  const std::string before = value;
  int count = n.low;
  std::from_chars(value.data(), value.data() + value.size(), count);
  number(c, std::string("weave.").append(n.id).c_str(), tr(n.label), count, n.low, n.high);
  value = std::to_string(count);
  return value != before;
}

bool draw_text(PanelContext& c, const WeaveParameter& n, std::string& value) {
  const std::string before = value;
  ImGui::PushID(n.id);
  ImGui::InputText("##text", &value);
  ImGui::PopID();
  c.map.add_item(std::string("weave.").append(n.id));
  return value != before;
}

std::vector<std::string> choices_of(const WeaveParameter& n, const WeaveValues& values) {
  std::vector<std::string> choices(n.choices.begin(), n.choices.end());
  if (n.allowed)
    for (const int one : n.allowed(n, values)) choices.push_back(std::to_string(one));
  return choices;
}

bool draw_value(PanelContext& c, const WeaveParameter& n, const WeaveValues& all, std::string& value) {
  if (n.kind == ParameterKind::kCount && !n.allowed) return draw_count(c, n, value);
  row_label(c, tr(n.label), tr(n.tip));
  ImGui::SetNextItemWidth(c.style.px(n.allowed ? 140 : 190));
  if (n.kind == ParameterKind::kText) return draw_text(c, n, value);
  return pick_from(c, n, choices_of(n, all), value);
}

bool any_letter_down() {
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (letter_down(letter)) return true;
  return false;
}

/// What is typed while no field has the keyboard, so that a letter in the list finds as in a list of files. True if
/// anything was.
bool take_typing(std::string& typed) {
  ImGuiIO& io = ImGui::GetIO();
  // The letter of the key that opened the dialog is none of it.
  bool& listens = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("listens"));
  if (ImGui::IsWindowAppearing()) listens = false;
  if (!listens) {
    listens = io.InputQueueCharacters.empty() && !any_letter_down();
    return false;
  }
  if (io.WantTextInput || io.KeyCtrl || io.KeyAlt) return false;
  const std::string before = typed;
  for (const ImWchar ch : io.InputQueueCharacters)
    if (ch < 0x80 && (ch > ' ' || (ch == ' ' && !typed.empty()))) typed += static_cast<char>(ch);
  if (key_pressed(ImGuiKey_Backspace) && !typed.empty()) typed.resize(base::cut_utf8(typed, typed.size() - 1).size());
  io.InputQueueCharacters.resize(0);  // or the field, which now gets the keyboard, could take them again
  return typed != before;
}

/// ImGui selects all of a field that is given the keyboard: what was typed in the list would be typed over.
int go_on_at_end(ImGuiInputTextCallbackData* data) {
  if (!std::exchange(*static_cast<bool*>(data->UserData), false)) return 0;
  data->CursorPos = data->BufTextLen;
  data->ClearSelection();
  return 0;
}

/// `given`: it gets the keyboard, for more to be typed.
void draw_find_field(PanelContext& c, std::string& typed, bool given) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID goes_on = ImGui::GetID("goes on");
  bool at_end = given || storage.GetBool(goes_on);
  if (given) ImGui::SetKeyboardFocusHere();
  ImGui::InputTextWithHint("##find", tr("Type to find"), &typed, ImGuiInputTextFlags_CallbackAlways, go_on_at_end,
                           &at_end);
  storage.SetBool(goes_on, at_end);
  c.map.add_item("weave.find");
  c.map.controls.back().row = true;  // Enter presses the dialog's button here, as in the list
}

std::string lowered(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// How well a weave matches typed words: the name is these words, begins with them, has them all; with its family, with
/// its description; or not at all.
enum class Match { kName, kBeginning, kInName, kInFamily, kInDescription, kNone };
Match match(std::string text, const char* family, const char* description, const std::vector<std::string>& words) {
  std::string typed;
  for (const std::string& word : words) typed += (typed.empty() ? "" : " ") + word;
  if (text == typed) return Match::kName;
  if (text.starts_with(typed)) return Match::kBeginning;
  const auto has_all = [&] {
    return std::ranges::all_of(words, [&](const std::string& word) { return text.find(word) != std::string::npos; });
  };
  if (has_all()) return Match::kInName;
  text += " " + lowered(family);
  if (has_all()) return Match::kInFamily;
  text += " " + lowered(description);
  return has_all() ? Match::kInDescription : Match::kNone;
}
/// In the user's language or, as books name the weaves, in English.
Match match(const WeaveKind& kind, const std::vector<std::string>& words) {
  return std::min(match(lowered(tr(kind.name)), tr(kind.family), tr(kind.description), words),
                  match(lowered(kind.name), kind.family, kind.description, words));
}

/// The found weaves below the names of their families.
void draw_found(PanelContext& c, const std::vector<int>& found, const std::string& typed, int& chosen, ImVec2 size) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, c.style.color.panel);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {c.style.px(8), c.style.px(6)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {c.style.px(8), c.style.px(4)});
  begin_padded_child("weaves", size);
  // What was chosen before the list appeared, or by typing, is scrolled to until it is seen: a dialog's first frame is
  // hidden, and the list may still stand where another dialog left it.
  int seen = ImGui::IsWindowAppearing() ? -1 : ImGui::GetStateStorage()->GetInt(ImGui::GetID("seen"), -1);
  std::string family;
  for (const int i : found) {
    const WeaveKind& kind = weave_kinds()[static_cast<size_t>(i)];
    if (family != kind.family) muted_text(c, tr((family = kind.family).c_str()));
    const std::string id = std::string("weave:") + kind.id;
    const bool was = i == chosen;
    const std::string name = std::string("  ") + tr(kind.name), shown = fitted(name, ImGui::GetContentRegionAvail().x);
    if (list_row(c, id.c_str(), shown.c_str(), was)) chosen = i;
    if (shown != name) tooltip(c, tr(kind.name));
    if (!was || seen == chosen) continue;
    if (ImGui::IsItemVisible() && !ImGui::GetCurrentWindow()->Hidden) seen = chosen;
    else ImGui::SetScrollHereY();
  }
  if (found.empty()) {
    ImGui::PushTextWrapPos(0);
    muted_text(c, fill(tr("No weave matches \"{typed}\"."), arg("typed", typed)));
    ImGui::PopTextWrapPos();
    c.map.add_item("weave.none");
  }
  ImGui::GetStateStorage()->SetInt(ImGui::GetID("seen"), seen);
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
}

/// Up and Down in the field go through what it found.
void step_choice(const std::vector<int>& found, int& chosen) {
  const int by = key_pressed(ImGuiKey_DownArrow) ? 1 : key_pressed(ImGuiKey_UpArrow) ? -1 : 0;
  const auto at = std::ranges::find(found, chosen);
  if (by == 0 || at == found.end()) return;
  const auto next =
      std::clamp<std::ptrdiff_t>(at - found.begin() + by, 0, static_cast<std::ptrdiff_t>(found.size()) - 1);
  chosen = found[static_cast<size_t>(next)];
}

}  // namespace

std::vector<int> found_weaves(const std::string& typed) {
  std::istringstream read(lowered(typed));
  const std::vector<std::string> words{std::istream_iterator<std::string>(read), {}};
  std::vector<std::pair<Match, int>> matches;
  for (int i = 0; i < static_cast<int>(weave_kinds().size()); ++i)
    if (const Match m = match(weave_kinds()[static_cast<size_t>(i)], words); m != Match::kNone)
      matches.emplace_back(m, i);
  std::ranges::sort(matches);
  std::vector<int> found;
  for (const auto& [how, weave] : matches) found.push_back(weave);
  return found;
}

bool draw_weave_list(PanelContext& c, int& chosen, std::string& typed, float width, float height) {
  const int before = chosen;
  const std::string typed_before = typed;
  const float field = ImGui::GetFrameHeight() + c.style.px(6);
  const ImVec2 at = ImGui::GetCursorPos();
  const bool goes_on = take_typing(typed);
  const std::vector<int> found = found_weaves(typed);
  ImGui::BeginGroup();
  // The field stands above the list and comes after it for the keyboard, which begins in the list.
  ImGui::SetCursorPosY(at.y + field);
  draw_found(c, found, typed, chosen, {c.style.px(width), c.style.px(height) - field});
  ImGui::SetCursorPos(at);
  ImGui::SetNextItemWidth(c.style.px(width));
  draw_find_field(c, typed, goes_on);
  if (ImGui::IsItemActive()) step_choice(found, chosen);
  ImGui::EndGroup();
  // What is typed chooses the best match.
  if (typed != typed_before && !typed.empty())
    if (const std::vector<int> best = found_weaves(typed); !best.empty()) chosen = best.front();
  return chosen != before;
}

bool draw_weave_numbers(PanelContext& c, const WeaveKind& kind, WeaveValues& values) {
  bool changed = false;
  for (const WeaveParameter& n : kind.parameters)
    for (auto& [key, value] : values)
      if (key == n.id && (!n.used || n.used(values))) changed |= draw_value(c, n, values, value);
  if (changed) values = allowed_values(kind, values);
  return changed;
}

}  // namespace weftlight::views
