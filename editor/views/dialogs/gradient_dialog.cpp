// Colours from one to another across the ends or picks: in stripes, or blended. The draft follows. Cancel restores it.

#include <imgui.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/prompts.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using design::Design, design::Gradient, design::with_gradient;
using draft::Rgb, draft::System;
using session::Edit, session::MaybeEdit;
using ui::draw_swatch, ui::hit_area, ui::muted_text, ui::push_font, ui::row_label, ui::segmented;

namespace {

constexpr float kWidth = 400, kBand = 40, kSwatch = 20, kGap = 4;  // pixels at 96 dpi
constexpr int kMaxSteps = 64;

std::vector<int> threads_of(const GradientPrompt& p) {
  if (!p.chosen.empty() && p.system == p.chosen_of) return p.chosen;
  std::vector<int> all(static_cast<size_t>(p.base->draft.threads(p.system).size()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::string counted(const GradientPrompt& p) {
  const auto n = static_cast<long long>(threads_of(p).size());
  const bool warp = p.system == System::kWarp;
  if (!p.chosen.empty() && p.system == p.chosen_of)
    return fill(warp ? tr_n("{count} selected end", "{count} selected ends", n)
                     : tr_n("{count} selected pick", "{count} selected picks", n),
                arg("count", n));
  return fill(warp ? tr_n("{count} end", "{count} ends", n) : tr_n("{count} pick", "{count} picks", n),
              arg("count", n));
}

/// Every change in the dialog starts again from the draft as it was, and all of them are one undo step.
MaybeEdit preview_edit(GradientPrompt& p) {
  p.shown = true;
  auto made = std::make_shared<const Design>(with_gradient(*p.base, p.system, threads_of(p), p.gradient));
  return Edit{tr("Apply gradient"), [made = std::move(made)](const Design&) { return *made; }, p.stroke};
}

/// The colour as a field, and below it those of the palette to click.
void draw_color(PanelContext& c, const GradientPrompt& p, const char* id, const char* label, Rgb& color) {
  row_label(c, label, nullptr);
  const float left = ImGui::GetCursorPosX();
  float rgb[3] = {color.r, color.g, color.b};
  ImGui::PushID(id);
  ImGui::SetNextItemWidth(c.style.px(kWidth) - left);
  push_font(c.style.font.mono);
  if (ImGui::ColorEdit3("##rgb", rgb, ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueWheel))
    color = {rgb[0], rgb[1], rgb[2]};
  ImGui::PopFont();
  c.map.add_item(id);
  const float side = c.style.px(kSwatch), gap = c.style.px(kGap);
  ImGui::SetCursorPosX(left);
  const ImVec2 first = ImGui::GetCursorScreenPos();
  const auto room = static_cast<size_t>(std::max(1.0f, (c.style.px(kWidth) - left) / (side + gap)));
  const auto& palette = p.base->draft.palette;
  for (size_t i = 0; i < std::min(room, palette.size()); ++i) {
    const ImVec2 at{first.x + static_cast<float>(i) * (side + gap), first.y};
    ImGui::SetCursorScreenPos(at);
    ImGui::PushID(static_cast<int>(i));
    if (hit_area("swatch", {side, side})) color = palette[i];
    ImGui::PopID();
    c.map.add_item(std::string(id).append(":").append(std::to_string(i + 1)));
    draw_swatch(c, at, {at.x + side, at.y + side}, to_u32(palette[i]), palette[i] == color);
  }
  ImGui::PopID();
}

/// The threads side by side in their colours, as the draft has them now.
void draw_band(PanelContext& c, const GradientPrompt& p) {
  const std::vector<int> threads = threads_of(p);
  const ImVec2 at = ImGui::GetCursorScreenPos(), size{c.style.px(kWidth), c.style.px(kBand)};
  const auto columns = static_cast<size_t>(std::min(size.x, static_cast<float>(threads.size())));
  const draft::Draft& d = c.design.draft;
  ImDrawList* dl = ImGui::GetWindowDrawList();
  for (size_t i = 0; i < columns; ++i) {
    const auto thread = static_cast<size_t>(threads[i * threads.size() / columns]);
    const Rgb color = d.palette[static_cast<size_t>(d.threads(p.system).color[thread])];
    const float x0 = at.x + size.x * static_cast<float>(i) / static_cast<float>(columns);
    const float x1 = at.x + size.x * static_cast<float>(i + 1) / static_cast<float>(columns);
    dl->AddRectFilled({x0, at.y}, {x1, at.y + size.y}, to_u32(color));
  }
  ImGui::Dummy(size);
  c.map.add_item("gradient.band");
}

}  // namespace

DialogResult draw_prompt(PanelContext& c, GradientPrompt& p) {
  heading(c, tr("Gradient"));
  constexpr const char* kSystems[] = {mark("Ends"), mark("Picks")};
  constexpr const char* kWays[] = {mark("Stripes"), mark("Blended")};
  const Gradient before = p.gradient;
  const System system_before = p.system;
  int system = p.system == System::kWarp ? 0 : 1, way = p.gradient.blended ? 1 : 0;
  segmented(c, "gradient.system", kSystems, system, c.style.px(kWidth));
  p.system = system == 0 ? System::kWarp : System::kWeft;
  muted_text(c, counted(p));
  begin_here();
  draw_color(c, p, "gradient.from", tr("From"), p.gradient.from);
  draw_color(c, p, "gradient.to", tr("To"), p.gradient.to);
  number(c, "gradient.steps", tr("Colours"), p.gradient.steps, 2, kMaxSteps);
  segmented(c, "gradient.way", kWays, way, c.style.px(kWidth));
  p.gradient.blended = way == 1;
  muted_text(c, p.gradient.blended ? tr("Neighbouring colours alternate, more and more of the next one.")
                                   : tr("One stripe of each colour, all of the same width."));
  draw_band(c, p);
  MaybeEdit edit;
  if (!p.shown || !(before == p.gradient) || system_before != p.system) edit = preview_edit(p);
  return edited(std::move(edit), dialog_result(draw_buttons(c, {mark("Apply"), mark("Cancel")}, true)));
}

MaybeEdit restored(const GradientPrompt& p) {
  return Edit{tr("Apply gradient"), [base = p.base](const Design&) { return *base; }, p.stroke};
}

}  // namespace weftlight::views
