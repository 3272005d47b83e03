#include "views/dialogs/gallery_cards.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::tr;
using session::Step, session::kThumbnailHeight, session::kThumbnailWidth, session::stepped;
using ui::Colors, ui::blend, ui::fitted, ui::font_size, ui::hit_area, ui::key_pressed, ui::keyboard_frame_shown,
    ui::push_font, ui::tooltip, ui::with_alpha;

namespace {

constexpr float kPictureWidth = kThumbnailWidth / 2.0f, kPictureHeight = kThumbnailHeight / 2.0f;
constexpr float kThreeLines = 60, kName = 30, kRound = 7, kCross = 22;

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
  line(c.style.font.small, c.style.color.muted, card.where, card.kept);
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

}  // namespace

ImVec2 card_size(const PanelContext& c, int page) {
  return {c.style.px(kPictureWidth) + 2 * c.style.px(kCardPadding),
          c.style.px(kPictureHeight) + 2 * c.style.px(kCardPadding) + c.style.px(page == 1 ? kName : kThreeLines)};
}

CardRequest draw_card(const PanelContext& c, GalleryPrompt& p, const GalleryCard& card, int index, ImVec2 at) {
  const ImVec2 size = card_size(c, p.page), end{at.x + size.x, at.y + size.y};
  const GalleryPictures::Entry& entry = p.pictures->entry(card.path);
  const std::string number = std::to_string(index + 1);
  const float padding = c.style.px(kCardPadding);
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
  if (!card.copy && card.kept && (over || gone) &&
      draw_cross(c, number, {b.x - half - c.style.px(2), a.y + half + c.style.px(2)}))
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

}  // namespace weftlight::views
