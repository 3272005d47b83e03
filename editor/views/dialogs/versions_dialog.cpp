#include "views/dialogs/versions_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "design/versions.h"
#include "session/editing/version_edits.h"
#include "session/library/gallery.h"
#include "ui/imgui_compat.h"
#include "ui/keyboard.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::mark, base::tr;
using design::Version, design::free_version_name, design::version_name, design::version_of;
using session::Step, session::delete_version_edit, session::go_to_version_edit, session::keep_version_edit,
    session::rename_version_edit, session::stepped, session::version_words;
using ui::Colors, ui::blend, ui::fitted, ui::font_size, ui::hit_area, ui::key_pressed, ui::keyboard_frame_shown,
    ui::muted_text, ui::push_font, ui::segmented, ui::text_button, ui::with_alpha;

const PixelTexture* VersionPictures::picture(const std::shared_ptr<const Design>& design, int width, int height,
                                             float across_mm) {
  if (width != width_ || height != height_ || across_mm != across_mm_) {
    entries_.clear();
    width_ = width, height_ = height, across_mm_ = across_mm;
  }
  const auto [at, is_new] = entries_.try_emplace(design.get());
  if (is_new) {
    at->second.design = design;
    pictures_.ask(design, width, height, across_mm);
  }
  return at->second.texture.empty() ? nullptr : &at->second.texture;
}

bool VersionPictures::poll() {
  const auto finished = pictures_.take();
  for (const auto& [design, picture] : finished) {
    const auto entry = entries_.find(design.get());
    if (entry == entries_.end() || picture.width != width_ || picture.height != height_) continue;
    entry->second.texture.set(picture.width, picture.height, picture.pixels, true);
  }
  return !finished.empty();
}

namespace {

// Pixels at 96 dpi.
constexpr float kPictureWidth = 216, kPictureHeight = 144, kPadding = 8, kGap = 10, kTwoLines = 42, kRound = 7;
constexpr int kMaxColumns = 4;
// Of the cloth across a picture.
constexpr float kSwatchWidths_mm[] = {12, 30, 75, 200}, kSwatchWidthsInInches_mm[] = {12.7f, 31.75f, 76.2f, 203.2f};
constexpr const char* kSwatchWords[] = {"12 mm", "30 mm", "75 mm", "200 mm"};
constexpr const char* kSwatchWordsInInches[] = {mark("1/2 in"), mark("1 1/4 in"), mark("3 in"), mark("8 in")};

ImVec2 card_size(const PanelContext& c) {
  return {c.style.px(kPictureWidth) + 2 * c.style.px(kPadding),
          c.style.px(kPictureHeight) + 2 * c.style.px(kPadding) + c.style.px(kTwoLines)};
}

struct Card {
  std::string id, name, words;
  std::shared_ptr<const Design> design;
  bool chosen = false;
};

void draw_words(const PanelContext& c, const Card& card, ImVec2 at, float width) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  push_font(c.style.font.bold);
  dl->AddText(at, c.style.color.text, fitted(card.name, width).c_str());
  at.y += std::floor(font_size(c.style.font.bold) * 1.3f);
  ImGui::PopFont();
  push_font(c.style.font.small);
  dl->AddText(at, c.style.color.muted, fitted(card.words, width).c_str());
  ImGui::PopFont();
}

/// True if clicked.
bool draw_card(const PanelContext& c, VersionsPrompt& p, const Card& card, ImVec2 at) {
  const ImVec2 size = card_size(c), end{at.x + size.x, at.y + size.y};
  const float padding = c.style.px(kPadding);
  const ImVec2 a{at.x + padding, at.y + padding};
  const ImVec2 b{a.x + std::floor(c.style.px(kPictureWidth)), a.y + std::floor(c.style.px(kPictureHeight))};
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const Colors& k = c.style.color;
  if (card.chosen || ImGui::IsMouseHoveringRect(at, end))
    dl->AddRectFilled(at, end, with_alpha(k.accent, card.chosen ? 0.12f : 0.07f), c.style.px(kRound));
  if (card.chosen) dl->AddRect(at, end, k.accent, c.style.px(kRound), 0, c.style.px(2));
  const float across_mm = (c.settings.imperial ? kSwatchWidthsInInches_mm : kSwatchWidths_mm)[p.scale];
  const PixelTexture* texture =
      p.pictures->picture(card.design, static_cast<int>(b.x - a.x), static_cast<int>(b.y - a.y), across_mm);
  if (texture) dl->AddImageRounded(texture->id(), a, b, {0, 0}, {1, 1}, IM_COL32_WHITE, c.style.px(kRound - 2));
  else dl->AddRectFilled(a, b, blend(k.raised, k.text, 0.05f), c.style.px(kRound - 2));
  dl->AddRect(a, b, with_alpha(k.text, 0.18f), c.style.px(kRound - 2));
  draw_words(c, card, {a.x, b.y + c.style.px(6)}, b.x - a.x);
  ImGui::SetCursorScreenPos(at);
  const bool clicked = hit_area(card.id.c_str(), size);
  c.map.add_item(card.id);
  if (texture) c.map.add(card.id + ":picture", a.x, a.y, b.x - a.x, b.y - a.y);
  return clicked;
}

/// The draft as it is now, and its versions after it.
std::vector<Card> cards_of(const PanelContext& c, VersionsPrompt& p) {
  if (!p.now || p.revision != c.revision) {
    p.now = std::make_shared<const Design>(version_of(c.design));
    p.revision = c.revision;
  }
  std::vector<Card> cards{{"version:now", tr("The draft"), tr("current"), p.now, p.chosen < 0}};
  for (size_t i = 0; i < c.design.versions.size(); ++i) {
    const Version& version = c.design.versions[i];
    cards.push_back({"version:" + std::to_string(i + 1), version.name, version_words(c.design, version), version.design,
                     p.chosen == static_cast<int>(i)});
  }
  return cards;
}

void choose(const PanelContext& c, VersionsPrompt& p, int version) {
  p.chosen = version;
  p.name = version < 0 ? free_version_name(c.design) : c.design.versions[static_cast<size_t>(version)].name;
}

void move_choice(const PanelContext& c, VersionsPrompt& p, int cards, int columns) {
  if (keyboard_frame_shown() || ImGui::GetIO().WantTextInput) return;
  const auto step = [&](ImGuiKey key, Step by) {
    if (!key_pressed(key)) return;
    choose(c, p, stepped(p.chosen + 1, cards, columns, by) - 1);
    p.follow = true;
  };
  step(ImGuiKey_UpArrow, Step::kUp);
  step(ImGuiKey_DownArrow, Step::kDown);
  step(ImGuiKey_LeftArrow, Step::kLeft);
  step(ImGuiKey_RightArrow, Step::kRight);
}

void draw_cards(PanelContext& c, VersionsPrompt& p, int columns) {
  const std::vector<Card> cards = cards_of(c, p);
  move_choice(c, p, static_cast<int>(cards.size()), columns);
  const ImVec2 size = card_size(c), first = ImGui::GetCursorScreenPos();
  const float gap = c.style.px(kGap), top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
  ImVec2 at = first;
  for (int i = 0; i < static_cast<int>(cards.size()); ++i) {
    at = {first.x + static_cast<float>(i % columns) * (size.x + gap),
          first.y + static_cast<float>(i / columns) * (size.y + gap)};
    if (i == p.chosen + 1 && std::exchange(p.follow, false)) ImGui::SetScrollFromPosY(at.y + size.y / 2 - top, 0.5f);
    // Only what is seen is computed.
    if (at.y + size.y < top || at.y > bottom) continue;
    if (draw_card(c, p, cards[static_cast<size_t>(i)], at)) choose(c, p, i - 1);
  }
  ImGui::SetCursorScreenPos({first.x, at.y + size.y});
  ImGui::Dummy({1, 1});
}

/// The name, and what is done with it.
MaybeEdit draw_name_row(PanelContext& c, VersionsPrompt& p) {
  const auto chosen = static_cast<size_t>(std::max(p.chosen, 0));
  const std::string name = version_name(p.name);
  const bool is_own = p.chosen >= 0 && c.design.versions[chosen].name == name;
  const bool is_taken = std::ranges::find(c.design.versions, name, &Version::name) != c.design.versions.end();
  MaybeEdit edit;
  if (c.design.versions.empty()) begin_here();  // otherwise the arrows go through them
  ImGui::SetNextItemWidth(c.style.px(260));
  const bool enter = ImGui::InputTextWithHint("##name", tr("Name of the version"), &p.name,
                                              ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  c.map.add_item("versions.name");
  ImGui::SameLine();
  if (text_button(c, "versions.keep", is_taken ? tr("Replace with the current draft") : tr("Save as a version"),
                  tr("Saves the current draft as a version of this name, in the draft's file")) ||
      (enter && !is_taken)) {
    if (!name.empty()) edit = keep_version_edit(name);
  }
  if (p.chosen < 0) return edit;
  ImGui::SameLine();
  if (text_button(c, "versions.rename", tr("Rename"), tr("Renames the selected version")) && !is_own)
    edit = rename_version_edit(chosen, name);
  ImGui::SameLine();
  if (text_button(c, "versions.delete", tr("Delete"), tr("Deletes the selected version; the draft does not change"))) {
    edit = delete_version_edit(c.design, chosen);
    choose(c, p, -1);
  }
  return edit;
}

}  // namespace

DialogResult draw_prompt(PanelContext& c, VersionsPrompt& p) {
  p.chosen = std::min(p.chosen, static_cast<int>(c.design.versions.size()) - 1);
  const ImGuiViewport* view = ImGui::GetMainViewport();
  const ImVec2 size = card_size(c);
  const float gap = c.style.px(kGap), bar = ImGui::GetStyle().ScrollbarSize + c.style.px(4);
  const float room_x = view->WorkSize.x - c.style.px(88) - bar, room_y = view->WorkSize.y - c.style.px(250);
  const int columns = std::clamp(static_cast<int>((room_x + gap) / (size.x + gap)), 1, kMaxColumns);
  const float width = static_cast<float>(columns) * (size.x + gap) - gap + bar;
  heading(c, tr("Versions and colourways"));
  const float scales = c.style.px(260);
  muted_text(c, tr("Saved in the draft's file; all shown at the same scale"));
  ImGui::SameLine(width - scales + ImGui::GetStyle().WindowPadding.x);
  segmented(c, "versions.scale", c.settings.imperial ? kSwatchWordsInInches : kSwatchWords, p.scale, scales);
  ImGui::Dummy({0, c.style.px(4)});
  const auto rows = (c.design.versions.size() + static_cast<size_t>(columns)) / static_cast<size_t>(columns);
  const float height = std::min(room_y, static_cast<float>(std::min<size_t>(rows, 3)) * (size.y + gap));
  ImGui::BeginChild("cards", {width, std::max(c.style.px(80), height)});
  draw_cards(c, p, columns);
  ImGui::EndChild();
  ImGui::Dummy({0, c.style.px(4)});
  DialogResult result;
  result.edit = draw_name_row(c, p);
  const bool can_go = p.chosen >= 0;
  const std::vector<std::string> labels = can_go ? std::vector<std::string>{mark("Restore this version"), mark("Close")}
                                                 : std::vector<std::string>{mark("Close")};
  const bool typing = ImGui::GetIO().WantTextInput;  // Enter keeps the typed name
  const int pressed = draw_buttons(c, labels, !typing);
  if (pressed < 0) return result;
  if (can_go && pressed == 0)
    result.edit = go_to_version_edit(c.design, c.design.versions[static_cast<size_t>(p.chosen)]);
  result.outcome = can_go && pressed == 0 ? DialogOutcome::kDone : DialogOutcome::kCancelled;
  return result;
}

}  // namespace weftlight::views
