#include "views/dialogs/gallery.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "session/document/bring_back.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {

using base::mark, base::tr;
using session::Settings, session::Step, session::Thumbnail, session::forget, session::found_cards,
    session::kThumbnailHeight, session::kThumbnailWidth, session::stepped, session::time_in_words;
using ui::Colors, ui::blend, ui::fitted, ui::font_size, ui::hit_area, ui::key_pressed, ui::keyboard_frame_shown,
    ui::muted_text, ui::push_font, ui::segmented, ui::tooltip, ui::with_alpha;

GalleryPictures::GalleryPictures(std::string cache_folder, std::function<void()> wake, int64_t now_ns)
    : now_ns_(now_ns), thumbnails_(std::move(cache_folder), std::move(wake)) {}

const GalleryPictures::Entry& GalleryPictures::entry(const std::string& path) {
  const auto [at, is_new] = entries_.try_emplace(path);
  if (is_new) thumbnails_.ask(path);
  return at->second;
}

bool GalleryPictures::poll() {
  const auto finished = thumbnails_.take();
  for (const auto& [path, thumbnail] : finished) {
    Entry& e = entries_[path];
    e.known = true;
    e.state = thumbnail.state;
    if (thumbnail.state != DraftThumbnail::State::kMissing) e.when = time_in_words(thumbnail.modified_ns, now_ns_);
    const Thumbnail& picture = thumbnail.picture;
    if (!picture.pixels.empty()) e.texture.set(picture.width, picture.height, picture.pixels, true);
  }
  return !finished.empty();
}

namespace {

// Pixels at 96 dpi.
constexpr float kPictureWidth = kThumbnailWidth / 2.0f, kPictureHeight = kThumbnailHeight / 2.0f;
constexpr float kPadding = 8, kGap = 10, kThreeLines = 60, kName = 30, kRound = 7, kCross = 22;
constexpr int kMaxColumns = 5;
constexpr float kRowsShown = 2.6f;  // the cut row shows that there are more

/// A card of the library has only a name below its thumbnail.
ImVec2 card_size(const PanelContext& c, int page) {
  return {c.style.px(kPictureWidth) + 2 * c.style.px(kPadding),
          c.style.px(kPictureHeight) + 2 * c.style.px(kPadding) + c.style.px(page == 0 ? kThreeLines : kName)};
}

/// Shortened at its start, because the end of a path tells most.
std::string fitted_end(const std::string& text, float width) {
  constexpr const char* kEllipsis = "\xE2\x80\xA6";
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  size_t from = 0;
  while (from < text.size() && ImGui::CalcTextSize((kEllipsis + text.substr(from)).c_str()).x > width) {
    ++from;
    while (from < text.size() && (static_cast<unsigned char>(text[from]) & 0xC0) == 0x80) ++from;
  }
  return kEllipsis + text.substr(from);
}

void draw_picture(const PanelContext& c, const GalleryPictures::Entry& entry, ImVec2 a, ImVec2 b) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const Colors& k = c.style.color;
  const float r = c.style.px(kRound - 2);
  if (!entry.texture.empty()) {
    dl->AddImageRounded(entry.texture.id(), a, b, {0, 0}, {1, 1}, IM_COL32_WHITE, r);
    return dl->AddRect(a, b, with_alpha(k.text, 0.18f), r);
  }
  dl->AddRectFilled(a, b, blend(k.raised, k.text, 0.05f), r);
  if (!entry.known) return;
  const char* words = entry.state == DraftThumbnail::State::kMissing ? tr("File not found") : tr("Cannot be read");
  ImFont* font = c.style.font.small;
  const ImVec2 size = font->CalcTextSizeA(font_size(font), FLT_MAX, 0, words);
  dl->AddText(font, font_size(font), {std::floor((a.x + b.x - size.x) / 2), std::floor((a.y + b.y - size.y) / 2)},
              k.muted, words);
}

void draw_words(const PanelContext& c, const GalleryCard& card, const GalleryPictures::Entry& entry, ImVec2 at,
                float width) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const bool gone = entry.known && entry.state == DraftThumbnail::State::kMissing;
  const auto line = [&](ImFont* font, ImU32 color, const std::string& text, bool keep_end) {
    push_font(font);
    const std::string shown = keep_end ? fitted_end(text, width) : fitted(text, width);
    dl->AddText(at, color, shown.c_str());
    at.y += std::floor(font_size(font) * 1.3f);
    ImGui::PopFont();
  };
  line(c.style.font.bold, gone ? c.style.color.muted : c.style.color.text, card.name, false);
  if (card.copy) return;
  line(c.style.font.small, c.style.color.muted, card.where, true);
  if (!entry.when.empty()) line(c.style.font.small, c.style.color.muted, entry.when, false);
}

/// True if clicked.
bool draw_cross(const PanelContext& c, const std::string& number, ImVec2 middle) {
  const float half = c.style.px(kCross) / 2, r = c.style.px(4);
  ImGui::SetCursorScreenPos({middle.x - half, middle.y - half});
  const bool pressed = hit_area("remove", {2 * half, 2 * half});
  c.map.add_item("gallery.remove:" + number);
  const bool hovered = ImGui::IsItemHovered();
  tooltip(c, tr("Remove from this list; the file is kept"));
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const Colors& k = c.style.color;
  dl->AddCircleFilled(middle, half - c.style.px(1), with_alpha(k.raised, hovered ? 1 : 0.85f));
  const ImU32 color = hovered ? k.text : k.muted;
  const ImVec2 m{middle.x - 0.5f, middle.y - 0.5f};
  dl->AddLine({m.x - r, m.y - r}, {m.x + r, m.y + r}, color, 1.4f);
  dl->AddLine({m.x - r, m.y + r}, {m.x + r, m.y - r}, color, 1.4f);
  return pressed;
}

enum class CardRequest { kNone, kOpen, kRemove };

CardRequest draw_card(const PanelContext& c, GalleryPrompt& p, const GalleryCard& card, int index, ImVec2 at) {
  const ImVec2 size = card_size(c, p.page), end{at.x + size.x, at.y + size.y};
  const GalleryPictures::Entry& entry = p.pictures->entry(card.path);
  const std::string number = std::to_string(index + 1);
  const float padding = c.style.px(kPadding);
  const ImVec2 a{at.x + padding, at.y + padding}, b{end.x - padding, a.y + c.style.px(kPictureHeight)};
  const bool gone = entry.known && entry.state == DraftThumbnail::State::kMissing;
  const bool over = ImGui::IsMouseHoveringRect(at, end), chosen = p.chosen == index;
  CardRequest requested = CardRequest::kNone;
  ImGui::PushID(index);
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const Colors& k = c.style.color;
  if (over || chosen) dl->AddRectFilled(at, end, with_alpha(k.accent, chosen ? 0.12f : 0.07f), c.style.px(kRound));
  if (chosen) dl->AddRect(at, end, k.accent, c.style.px(kRound), 0, c.style.px(2));
  draw_picture(c, entry, a, b);
  draw_words(c, card, entry, {a.x, b.y + c.style.px(7)}, b.x - a.x);
  // Drawn before the card below it, so that it gets the pointer first.
  const float half = c.style.px(kCross) / 2;
  if (!card.copy && (over || gone) && draw_cross(c, number, {b.x - half - c.style.px(2), a.y + half + c.style.px(2)}))
    requested = CardRequest::kRemove;
  ImGui::SetCursorScreenPos(at);
  if (hit_area("card", size) && requested == CardRequest::kNone) p.chosen = index, requested = CardRequest::kOpen;
  c.map.add_item("gallery:" + number);
  if (gone) c.map.add_item("gallery.missing:" + number);
  if (!entry.texture.empty()) c.map.add("gallery.picture:" + number, a.x, a.y, b.x - a.x, b.y - a.y);
  tooltip(c, card.copy ? nullptr : card.path.c_str());
  ImGui::PopID();
  return requested;
}

struct ClickedCard {
  CardRequest requested = CardRequest::kNone;
  int card = -1;  // of the page
};

/// The cards in rows; those of the library grouped under headings.
ClickedCard draw_cards(PanelContext& c, GalleryPrompt& p, const std::vector<GalleryCard>& cards,
                       const std::vector<int>& found, int columns) {
  const ImVec2 size = card_size(c, p.page), first = ImGui::GetCursorScreenPos();
  const float gap = c.style.px(kGap), top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
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
      ImGui::SetCursorScreenPos({at.x + c.style.px(kPadding), at.y + c.style.px(4)});
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

void move_choice(GalleryPrompt& p, int count, int columns) {
  if (keyboard_frame_shown()) return;  // they go through the controls
  const auto step = [&](ImGuiKey key, Step by) {
    if (!key_pressed(key)) return;
    p.chosen = stepped(p.chosen, count, columns, by);
    p.follow = true;
  };
  step(ImGuiKey_UpArrow, Step::kUp);
  step(ImGuiKey_DownArrow, Step::kDown);
  if (!p.typed.empty()) return;  // the keys move the caret of the search field
  step(ImGuiKey_LeftArrow, Step::kLeft);
  step(ImGuiKey_RightArrow, Step::kRight);
}

void draw_head(PanelContext& c, GalleryPrompt& p, float width) {
  constexpr const char* kPages[] = {mark("Recent"), mark("Library")};
  heading(c, tr("Open draft"));
  const float search = c.style.px(260);
  if (segmented(c, "gallery.page", kPages, p.page, c.style.px(220))) p.chosen = -1, p.focus = true;
  ImGui::SameLine(width - search + ImGui::GetStyle().WindowPadding.x);
  ImGui::SetNextItemWidth(search);
  if (ImGui::IsWindowAppearing() || std::exchange(p.focus, false)) ImGui::SetKeyboardFocusHere();
  // Up and down are for the cards: a field with a history keeps them from the keyboard's way through the controls.
  const auto no_history = [](ImGuiInputTextCallbackData*) { return 0; };
  if (ImGui::InputTextWithHint("##typed", tr("Search by name or folder"), &p.typed, ImGuiInputTextFlags_CallbackHistory,
                               no_history))
    p.chosen = p.typed.empty() ? -1 : 0;
  c.map.add_item("gallery.typed");
  ImGui::Dummy({0, c.style.px(4)});
}

const char* nothing_to_show(const GalleryPrompt& p) {
  if (!p.typed.empty()) return tr("No draft matches.");
  return p.page == 0 ? tr("Drafts that you open or save appear here.") : tr("The library is not installed.");
}

}  // namespace

DialogResult draw_gallery(PanelContext& c, GalleryPrompt& p) {
  const ImGuiViewport* view = ImGui::GetMainViewport();
  const ImVec2 size = card_size(c, p.page);
  const float gap = c.style.px(kGap), bar = ImGui::GetStyle().ScrollbarSize + c.style.px(4);
  const float room_x = view->WorkSize.x - c.style.px(88) - bar, room_y = view->WorkSize.y - c.style.px(220);
  const int columns = std::clamp(static_cast<int>((room_x + gap) / (size.x + gap)), 1, kMaxColumns);
  const float width = static_cast<float>(columns) * (size.x + gap) - gap + bar;
  const float height = std::max(c.style.px(80), std::min(room_y, std::floor(kRowsShown * (card_size(c, 0).y + gap))));
  draw_head(c, p, width);
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
