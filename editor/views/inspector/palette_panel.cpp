#include "views/inspector/palette_panel.h"

#include <algorithm>

#include "base/text.h"
#include "session/editing/paint.h"
#include "session/editing/palette_deletion.h"
#include "ui/icons.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr;
using design::Design, design::with_new_palette_color, design::with_palette_color;
using draft::Draft, draft::Rgb;
using session::BarPaint, session::DocumentView, session::Edit, session::GridId, session::bar_edit,
    session::delete_color_edit;
using ui::buttons_row, ui::draw_swatch, ui::hit_area, ui::icon_button, ui::push_font, ui::row_label, ui::section,
    ui::segmented, ui::text_button, ui::tooltip;

namespace {

using Panel = ViewContext<DrawingState>;

/// The menu of a swatch by the right button.
void draw_swatch_menu(Panel& c, int color) {
  if (!ImGui::BeginPopupContextItem("swatch menu")) return;
  const int active = c.view.color;
  const bool several = c.design.draft.palette.size() > 1;
  if (ImGui::MenuItem(tr("Delete"), nullptr, false, several)) {
    c.wanted.change_view([color](DocumentView& v) { v.drawing.color = color; });
    c.wanted.add_action("colors.delete");
  }
  c.map.add_item("palette.delete");
  if (ImGui::MenuItem(tr("Replace by the active colour"), nullptr, false, color != active))
    c.wanted.gesture([color, active](DocumentView& v, const Design&) -> MaybeEdit {
      v.drawing.color = active - (active > color ? 1 : 0);
      return delete_color_edit({color, active});
    });
  c.map.add_item("palette.replace");
  ImGui::EndPopup();
}

/// All swatches in rows. A click makes a colour active. Large palettes scroll.
void draw_swatches(Panel& c) {
  const auto& palette = c.design.draft.palette;
  const float side = c.style.pressed_px(24), gap = c.style.px(6);
  const int columns = std::max(1, static_cast<int>((ImGui::GetContentRegionAvail().x + gap - 4) / (side + gap)));
  const int rows = (static_cast<int>(palette.size()) + columns - 1) / columns;
  const float height = std::min(static_cast<float>(rows), 5.0f) * (side + gap) + gap;
  ImGui::BeginChild("swatches", {0, height});
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  for (int i = 0; i < static_cast<int>(palette.size()); ++i) {
    const ImVec2 a{origin.x + 3 + static_cast<float>(i % columns) * (side + gap),
                   origin.y + 3 + static_cast<float>(i / columns) * (side + gap)};
    ImGui::SetCursorScreenPos(a);
    ImGui::PushID(i);
    if (hit_area("swatch", {side, side}))
      c.wanted.change_view([i](DocumentView& v) {
        v.drawing.color = i;
        v.drawing.bar_paint = BarPaint::kColor;
      });
    draw_swatch_menu(c, i);
    ImGui::PopID();
    if (!ImGui::IsItemVisible()) continue;
    const std::string name = "palette:" + std::to_string(i + 1);
    c.map.add_item(name);
    tooltip(c, fill(tr("Colour {number}"), arg("number", i + 1)).c_str());
    draw_swatch(c, a, {a.x + side, a.y + side}, to_u32(palette[static_cast<size_t>(i)]), i == c.view.color);
  }
  ImGui::EndChild();
}

MaybeEdit draw_active_color(Panel& c) {
  const int index = c.view.color;
  Rgb color = c.design.draft.palette[static_cast<size_t>(index)];
  float rgb[3] = {color.r, color.g, color.b};
  row_label(c, fill(tr("Colour {number}"), arg("number", index + 1)).c_str(),
            tr("The active colour: click the swatch to edit it, or type its hex value"));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - c.style.px(12));
  push_font(c.style.font.mono);
  const bool changed =
      ImGui::ColorEdit3("##rgb", rgb, ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueWheel);
  ImGui::PopFont();
  c.map.add_item("palette.color");
  ImGui::SameLine();
  if (icon_button(c, "palette.add", icon::kPlus, "+", tr("Add a copy of this colour to the palette"))) {
    // The edit first: its undo brings back what was active before it.
    c.wanted.add(Edit{tr("Add colour"), [color](Design d) { return with_new_palette_color(std::move(d), color); }});
    c.wanted.change_view(
        [next = static_cast<int>(c.design.draft.palette.size())](DocumentView& v) { v.drawing.color = next; });
    return {};
  }
  if (!changed) return {};
  const Rgb next{rgb[0], rgb[1], rgb[2]};
  return Edit{tr("Edit colour"), [=](Design d) { return with_palette_color(std::move(d), index, next); }};
}

MaybeEdit paint_all(Panel& c) {
  const bool color = c.view.bar_paint == BarPaint::kColor;
  const int index = color ? c.view.color : c.view.yarn;
  const Draft& d = c.design.draft;
  if (text_button(c, "paint.warp", tr("All ends"), tr("Give every end the active colour or yarn")))
    return bar_edit(GridId::kWarpColors, {0, 0}, {d.ends() - 1, 0}, c.view.bar_paint, index);
  ImGui::SameLine();
  if (text_button(c, "paint.weft", tr("All picks"), tr("Give every pick the active colour or yarn")))
    return bar_edit(GridId::kWeftColors, {0, 0}, {0, d.picks() - 1}, c.view.bar_paint, index);
  return {};
}

}  // namespace

MaybeEdit draw_palette(const PanelContext& panel, const DrawingState& drawing) {
  Panel c{panel, drawing};
  if (!section(c, "section.palette", tr("Colours"))) return {};
  draw_swatches(c);
  MaybeEdit edit = draw_active_color(c);
  row_label(c, tr("Colour bars paint"),
            tr("What a drag along the colour bars of warp and weft sets: the colour of threads, or their yarn"));
  constexpr const char* kWhat[] = {mark("Colour"), mark("Yarn")};
  int what = static_cast<int>(c.view.bar_paint);
  if (segmented(c, "bars", kWhat, what))
    c.wanted.change_view([what](DocumentView& v) { v.drawing.bar_paint = static_cast<BarPaint>(what); });
  const char* const all_threads[] = {tr("All ends"), tr("All picks")};
  buttons_row(c, all_threads);
  if (MaybeEdit all = paint_all(c)) edit = std::move(all);
  return edit;
}

}  // namespace weftlight::views
