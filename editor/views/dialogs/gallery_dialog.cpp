#include "views/dialogs/gallery_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/gallery_cards.h"

namespace weftlight::views {

using base::mark, base::tr;
using session::Settings, session::forget, session::found_cards;
using ui::muted_text, ui::segmented;

namespace {

constexpr int kMaxColumns = 5;
constexpr float kPagesWidth = 300;  // pixels at 96 dpi
constexpr float kRowsShown = 2.6f;  // the cut row shows that there are more

struct ClickedCard {
  CardRequest requested = CardRequest::kNone;
  int card = -1;  // of the page
};

/// The cards in rows; those of the library grouped under headings.
ClickedCard draw_cards(PanelContext& c, GalleryPrompt& p, const std::vector<GalleryCard>& cards,
                       const std::vector<int>& found, int columns) {
  const ImVec2 size = card_size(c, p.page), first = ImGui::GetCursorScreenPos();
  const float gap = c.style.px(kCardGap), top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
  const float head = ImGui::GetTextLineHeight() + c.style.px(10);
  ClickedCard clicked;
  ImVec2 at = first;
  int column = 0;
  const std::string* group = nullptr;
  for (size_t i = 0; i < found.size(); ++i) {
    const GalleryCard& card = cards[static_cast<size_t>(found[i])];
    if (card.copy && (group == nullptr || *group != card.where)) {
      if (column > 0) at = {first.x, at.y + size.y + gap};
      column = 0;
      group = &card.where;
      ImGui::SetCursorScreenPos({at.x + c.style.px(kCardPadding), at.y + c.style.px(4)});
      muted_text(c, card.where);
      at.y += head;
    } else if (column == columns) {
      column = 0;
      at = {first.x, at.y + size.y + gap};
    }
    at.x = first.x + static_cast<float>(column++) * (size.x + gap);
    if (p.follow && static_cast<int>(i) == p.chosen) {
      ImGui::SetScrollFromPosY(at.y + size.y / 2 - top, 0.5f);
      p.follow = false;
    }
    if (at.y + size.y < top || at.y > bottom) continue;
    const CardRequest requested = draw_card(c, p, card, static_cast<int>(i), at);
    if (requested != CardRequest::kNone) clicked = {requested, found[i]};
  }
  ImGui::SetCursorScreenPos({first.x, at.y + (found.empty() ? 0 : size.y)});
  ImGui::Dummy({1, 1});
  return clicked;
}

void draw_head(PanelContext& c, GalleryPrompt& p, float width) {
  constexpr const char* kPages[] = {mark("Recent"), mark("Library"), mark("Folder")};
  heading(c, tr("Open draft"));
  const float search = c.style.px(260);
  if (segmented(c, "gallery.page", kPages, p.page, c.style.px(kPagesWidth))) p.chosen = -1, p.focus = true;
  ImGui::SameLine(width - search + ImGui::GetStyle().WindowPadding.x);
  ImGui::SetNextItemWidth(search);
  if (ImGui::IsWindowAppearing() || std::exchange(p.focus, false)) ImGui::SetKeyboardFocusHere();
  // Up and down are for the cards: a field with a history keeps them from the keyboard's way through the controls.
  const auto no_history = [](ImGuiInputTextCallbackData*) { return 0; };
  const char* hint = p.page == kFolderPage ? tr("Search by title, author or path") : tr("Search by name or folder");
  if (ImGui::InputTextWithHint("##typed", hint, &p.typed, ImGuiInputTextFlags_CallbackHistory, no_history))
    p.chosen = p.typed.empty() ? -1 : 0;
  c.map.add_item("gallery.typed");
  ImGui::Dummy({0, c.style.px(4)});
}

const char* nothing_to_show(const GalleryPrompt& p) {
  if (!p.typed.empty()) return tr("No draft matches.");
  return p.page == 0 ? tr("Drafts that you open or save appear here.") : tr("The library is not installed.");
}

DialogResult draw_folder(PanelContext& c, GalleryPrompt& p, ImVec2 size, int columns) {
  bool choose = false;
  p.open.path = draw_folder_page(c, p, size, columns, choose);
  p.open.copy = false;
  const bool can_open = p.chosen >= 0;
  int button = draw_buttons(c, {mark("Open"), mark("Close"), mark("Choose folder\xE2\x80\xA6")}, can_open);
  if (button == GalleryPrompt::kOpen) {
    button = -1;
    const auto& found = p.browser->found();
    if (can_open && p.chosen < static_cast<int>(found.size()))
      p.open.path = (*p.browser->entries())[static_cast<size_t>(found[static_cast<size_t>(p.chosen)])].path;
  }
  if (!p.open.path.empty()) button = GalleryPrompt::kOpen;
  else if (choose || button == 2) button = GalleryPrompt::kFolder;
  return dialog_result(button, GalleryPrompt::kClose);
}

}  // namespace

DialogResult draw_prompt(PanelContext& c, GalleryPrompt& p) {
  p.pictures->begin_frame();
  const ImGuiViewport* view = ImGui::GetMainViewport();
  const ImVec2 size = card_size(c, p.page);
  const float gap = c.style.px(kCardGap), bar = ImGui::GetStyle().ScrollbarSize + c.style.px(4);
  const float room_x = view->WorkSize.x - c.style.px(88) - bar, room_y = view->WorkSize.y - c.style.px(220);
  const int columns = std::clamp(static_cast<int>((room_x + gap) / (size.x + gap)), 1, kMaxColumns);
  const float width = static_cast<float>(columns) * (size.x + gap) - gap + bar;
  const float height = std::max(c.style.px(80), std::min(room_y, std::floor(kRowsShown * (card_size(c, 0).y + gap))));
  draw_head(c, p, width);
  if (p.page == kFolderPage) return draw_folder(c, p, {width, height}, columns);
  const std::vector<GalleryCard>& cards = p.page == 0 ? p.recent : p.library;
  const std::vector<int> found = found_cards(cards, p.typed);
  p.chosen = std::min(p.chosen, static_cast<int>(found.size()) - 1);
  move_choice(p, static_cast<int>(found.size()), columns);
  ImGui::BeginChild("cards", {width, height});
  ClickedCard clicked = draw_cards(c, p, cards, found, columns);
  if (found.empty()) muted_text(c, nothing_to_show(p));
  ImGui::EndChild();
  bool at_start = c.settings.start_page;
  const ImVec2 below = ImGui::GetCursorPos();
  ImGui::SetCursorPosY(below.y + c.style.px(12));
  if (ImGui::Checkbox(tr("Show at startup"), &at_start))
    c.wanted.change_settings([at_start](Settings& s) { s.start_page = at_start; });
  c.map.add_item("gallery.start_page");
  ImGui::SetCursorPos(below);
  const bool can_open = p.chosen >= 0;
  int button = draw_buttons(c, {mark("Open"), mark("Close"), mark("Browse\xE2\x80\xA6"), mark("New draft\xE2\x80\xA6")},
                            can_open);
  if (button == GalleryPrompt::kOpen && can_open) clicked = {CardRequest::kOpen, found[static_cast<size_t>(p.chosen)]};
  if (button == GalleryPrompt::kOpen) button = -1;
  if (clicked.requested == CardRequest::kOpen) {
    p.open = cards[static_cast<size_t>(clicked.card)];
    button = GalleryPrompt::kOpen;
  } else if (clicked.requested == CardRequest::kRemove) {
    c.wanted.change_settings([path = cards[static_cast<size_t>(clicked.card)].path](Settings& s) { forget(s, path); });
    p.recent.erase(p.recent.begin() + clicked.card);
    p.focus = true;
  }
  return dialog_result(button, GalleryPrompt::kClose);
}

}  // namespace weftlight::views
