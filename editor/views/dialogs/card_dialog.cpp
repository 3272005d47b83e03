// The dialog that measures the screen: an outline of a credit card is dragged to the size of a real one.

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "session/editing/true_distance.h"
#include "ui/widgets.h"
#include "views/dialogs/prompts.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr;
using session::kCardCorner_mm, session::kCardHeight_mm, session::kCardWidth_mm;
using ui::Colors, ui::SliderSpec, ui::blend, ui::hit_area, ui::text_button, ui::with_alpha;

namespace {

constexpr float kStep = 0.0025f;  // of the size, for a press of a button: a fifth of a millimetre of the card

/// The room that the outline has, the same while it is dragged.
ImVec2 room_of(const PanelContext& c) {
  const ImVec2 window = ImGui::GetMainViewport()->WorkSize;
  return {std::max(c.style.px(200), std::min(c.style.px(680), window.x - c.style.px(90))),
          std::max(c.style.px(130), std::min(c.style.px(430), window.y - c.style.px(300)))};
}

float held(float px_a_mm, ImVec2 room) {
  const float most = std::min({session::kMaxPx_a_mm, room.x / kCardWidth_mm, room.y / kCardHeight_mm});
  return std::clamp(px_a_mm, std::min(session::kMinPx_a_mm * 2, most), most);
}

/// The outline, its chip and stripe, so that it is known for a card at once.
void draw_outline(const PanelContext& c, ImVec2 a, float px_a_mm, bool hot) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const Colors& k = c.style.color;
  const ImVec2 b{a.x + kCardWidth_mm * px_a_mm, a.y + kCardHeight_mm * px_a_mm};
  const float corner = kCardCorner_mm * px_a_mm;
  dl->AddRectFilled(a, b, blend(k.raised, k.accent, 0.10f), corner);
  dl->AddRect(a, b, k.accent, corner, 0, c.style.px(2));
  // Where ISO/IEC 7816-2 has the contacts of the chip.
  const ImVec2 chip{a.x + 10.25f * px_a_mm, a.y + 19.23f * px_a_mm};
  dl->AddRect(chip, {chip.x + 12 * px_a_mm, chip.y + 9.32f * px_a_mm}, with_alpha(k.text, 0.35f), 1.5f * px_a_mm);
  const float grip = c.style.px(hot ? 9 : 7);
  dl->AddCircleFilled(b, grip, k.accent);
  dl->AddCircleFilled(b, grip - c.style.px(3), k.raised);
}

/// Drags the lower right corner along the diagonal.
void drag_corner(PanelContext& c, CardPrompt& p, ImVec2 a, ImVec2 room) {
  hit_area("card", {room.x + c.style.px(12), room.y + c.style.px(12)});
  c.map.add_item("card");
  const ImVec2 hand = ImGui::GetIO().MousePos;
  const float to_x = hand.x - a.x, to_y = hand.y - a.y;
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNWSE);
  p.dragging = ImGui::IsItemActive();
  if (p.dragging && !ImGui::IsItemActivated())
    p.px_a_mm = held((to_x * kCardWidth_mm + to_y * kCardHeight_mm) /
                         (kCardWidth_mm * kCardWidth_mm + kCardHeight_mm * kCardHeight_mm),
                     room);
}

}  // namespace

DialogResult draw_prompt(PanelContext& c, CardPrompt& p) {
  const ImVec2 room = room_of(c);
  p.px_a_mm = held(p.px_a_mm, room);
  heading(c, tr("Measure the screen"));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room.x);
  const bool inches = c.settings.imperial;
  ImGui::TextUnformatted(fill(tr("Hold a bank card, a library card or a driving licence to the screen ({size}; all are "
                                 "the same size) and drag the corner until the outline matches."),
                              arg("size", inches ? tr("3.37 \xC3\x97 2.13 in") : tr("85.6 \xC3\x97 54.0 mm")))
                             .c_str());
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, c.style.px(4)});
  const ImVec2 a = ImGui::GetCursorScreenPos();
  drag_corner(c, p, a, room);
  draw_outline(c, a, p.px_a_mm, p.dragging);
  c.map.add("card.corner", a.x + kCardWidth_mm * p.px_a_mm - 1, a.y + kCardHeight_mm * p.px_a_mm - 1, 2, 2);
  if (text_button(c, "card.smaller", tr("A little smaller"), nullptr)) p.px_a_mm = held(p.px_a_mm * (1 - kStep), room);
  ImGui::SameLine();
  if (text_button(c, "card.larger", tr("A little larger"), nullptr)) p.px_a_mm = held(p.px_a_mm * (1 + kStep), room);
  ImGui::Dummy({0, c.style.px(4)});
  const SliderSpec eyes{"card.eyes",
                        tr("Distance to screen"),
                        session::kNearestEye_cm,
                        100,
                        inches ? tr("%.0f in") : "%.0f cm",
                        tr("How far your eyes are from the screen; about the length of your arm"),
                        false,
                        session::kNearestEye_cm,
                        session::kFurthestEye_cm};
  scaled_slider(c, eyes, inches ? static_cast<float>(10 / analysis::kInch_mm) : 1, p.eye_to_screen_cm);
  return dialog_result(draw_buttons(c, {mark("Save"), mark("Cancel")}, true));
}

}  // namespace weftlight::views
