#include "views/loom/loom_drawing.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/common/cell_image.h"

namespace weftlight::views {

using base::arg, base::fill, base::tr;
using draft::System;
using session::DentEnds, session::LoomWork, session::dents_on_loom, session::ends_in_dent, session::ends_on_loom;
using ui::draw_swatch, ui::fitted, ui::font_size, ui::reading_color, ui::with_alpha;

namespace {

// Pixels at 96 dpi.
constexpr float kLargestShaft = 64, kStripPitch = 20;
constexpr float kWovenShare = 0.6f;     // fraction of the strip before the current pick
constexpr float kThreadedShare = 0.4f;  // and before the current end or dent
constexpr float kPaleAhead = 0.35f;     // opacity of what comes later

/// The shafts, numbered from the left, in rows where one is too narrow; those of the step are filled. Returns the
/// height.
float draw_shafts(const PanelContext& c, const std::vector<bool>& filled, PixelRect room) {
  const int shafts = static_cast<int>(filled.size());
  if (shafts == 0) return 0;
  const float gap = c.style.px(shafts > 16 ? 3 : 6), least = c.style.px(24);
  const int rows = std::max(1, static_cast<int>(std::ceil(static_cast<float>(shafts) * (least + gap) / room.width())));
  const int of_row = (shafts + rows - 1) / rows;
  const float side =
      std::floor(std::min(c.style.px(kLargestShaft), (room.width() + gap) / static_cast<float>(of_row) - gap));
  if (side < 4) return 0;
  ImDrawList* dl = ImGui::GetWindowDrawList();
  int row = 0;
  for (; row * of_row < shafts && room.min.y + static_cast<float>(row) * (side + gap) + side <= room.max.y; ++row)
    for (int s = row * of_row; s < std::min(shafts, (row + 1) * of_row); ++s) {
      const bool on = filled[static_cast<size_t>(s)];
      const ImVec2 a{room.min.x + static_cast<float>(s - row * of_row) * (side + gap),
                     room.min.y + static_cast<float>(row) * (side + gap)};
      const ImVec2 b{a.x + side, a.y + side};
      dl->AddRectFilled(a, b, on ? c.style.color.accent : c.style.color.raised, c.style.px(4));
      if (!on) dl->AddRect(a, b, c.style.color.line_strong, c.style.px(4));
      const std::string number = std::to_string(s + 1);
      const float size = std::min(side * 0.5f, font_size(c.style.font.title));
      if (size < 8) continue;
      draw_text(c.style.font.title, size,
                {a.x + (side - width_of(c.style.font.title, size, number)) / 2, a.y + (side - size) / 2},
                on ? reading_color(c.style.color.accent) : c.style.color.muted, number);
    }
  return static_cast<float>(row) * (side + gap);
}

/// The drawdown around the pick, with woven picks above it and later ones below, or reversed if pick 1 is at the
/// bottom.
void draw_drawdown(const PanelContext& c, int pick, PixelRect room) {
  const Draft& d = c.design.draft;
  const float pitch = c.style.px(kStripPitch);
  const int rows = std::max(1, static_cast<int>(room.height() / pitch));
  const int woven = static_cast<int>(static_cast<float>(rows) * kWovenShare);
  const bool up = c.settings.pick1_bottom;
  const int pick_row = up ? rows - 1 - woven : woven;  // the row of the pick
  const int columns = std::min(d.ends(), static_cast<int>(room.width() / pitch));
  const CrossingColors colors = crossing_colors(c.design);
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const float width = static_cast<float>(columns) * pitch;
  for (int row = 0; row < rows; ++row) {
    const int p = up ? pick + pick_row - row : pick - pick_row + row;
    if (p < 0 || p >= d.picks()) continue;
    const float y = room.min.y + static_cast<float>(row) * pitch;
    const float alpha = p > pick ? kPaleAhead : 1.0f;
    for (int i = 0; i < columns; ++i) {
      const int end = c.settings.end1_right ? columns - 1 - i : i;
      const ImU32 color = c.cells.get(p, end) ? colors.of(System::kWarp, end, p) : colors.of(System::kWeft, p, end);
      const float x = room.min.x + static_cast<float>(i) * pitch;
      dl->AddRectFilled({x, y}, {x + pitch - 1, y + pitch - 1}, with_alpha(color, alpha));
    }
    draw_text(c.style.font.mono_small, font_size(c.style.font.mono_small),
              {room.min.x + width + c.style.px(8), y + (pitch - font_size(c.style.font.mono_small)) / 2},
              p == pick ? c.style.color.accent : c.style.color.muted, std::to_string(p + 1));
  }
  const float y = room.min.y + static_cast<float>(pick_row) * pitch;
  dl->AddRect({room.min.x - 3, y - 2}, {room.min.x + width + 2, y + pitch + 1}, c.style.color.accent, 2, 0, 2);
}

/// Columns of threads or dents around the current one, in the order in which the draft shows its ends.
struct Columns {
  float pitch = 0, width = 0;
  int count = 0, first = 0;  // `first`: the earliest that is shown
  bool from_right = true;

  float x(const PixelRect& room, int number) const {
    const int column = number - first;
    return room.min.x + static_cast<float>(from_right ? count - 1 - column : column) * pitch;
  }
};

Columns columns_around(const PanelContext& c, int number, int of, float pitch, const PixelRect& room) {
  Columns columns{pitch, 0, std::min(of, std::max(1, static_cast<int>(room.width() / pitch))), 0,
                  c.settings.end1_right};
  const int before = static_cast<int>(static_cast<float>(columns.count) * kThreadedShare);
  columns.first = std::clamp(number - before, 0, std::max(0, of - columns.count));
  columns.width = static_cast<float>(columns.count) * pitch;
  return columns;
}

void draw_number_below(const PanelContext& c, int number, bool current, ImVec2 at, float pitch) {
  if (!current && number % 5 != 0) return;
  const float size = font_size(c.style.font.mono_small);
  const std::string text = std::to_string(number);
  draw_text(c.style.font.mono_small, size, {at.x + (pitch - width_of(c.style.font.mono_small, size, text)) / 2, at.y},
            current ? c.style.color.accent : c.style.color.muted, text);
}

/// A tick, from its lower corner's middle.
void draw_tick(const PanelContext& c, ImVec2 middle, ImU32 color) {
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const float s = c.style.px(4), w = c.style.px(2);
  dl->AddLine({middle.x - s, middle.y}, {middle.x - s * 0.2f, middle.y + s * 0.8f}, color, w);
  dl->AddLine({middle.x - s * 0.2f, middle.y + s * 0.8f}, {middle.x + s, middle.y - s}, color, w);
}

/// The threading around the end, shaft 1 at the bottom. Ends that are threaded have a tick; later ones are pale.
void draw_threading(const PanelContext& c, const ShownStep& step, PixelRect room) {
  const Draft& d = c.design.draft;
  const int ends = ends_on_loom(c.design), now = step.number - 1;
  const float foot = c.style.px(44);
  const float pitch = std::floor(
      std::clamp((room.height() - foot) / static_cast<float>(std::max(1, d.shafts)), c.style.px(6), c.style.px(26)));
  const Columns columns = columns_around(c, now, ends, c.style.px(26), room);
  const int rows = std::min(d.shafts, static_cast<int>((room.height() - foot) / pitch));
  const auto warp = thread_colors(d, System::kWarp);
  const float bottom = room.min.y + static_cast<float>(rows) * pitch;
  ImDrawList* dl = ImGui::GetWindowDrawList();
  for (int end = columns.first; end < columns.first + columns.count; ++end) {
    const float x = columns.x(room, end), alpha = end > now ? kPaleAhead : 1.0f;
    for (int shaft = 0; shaft < rows; ++shaft) {
      const ImVec2 a{x, bottom - static_cast<float>(shaft + 1) * pitch};
      const ImVec2 b{a.x + columns.pitch - 1, a.y + pitch - 1};
      const bool on = d.threading.get(end % d.ends(), shaft);
      const ImU32 heddle = end == now ? c.style.color.accent : with_alpha(c.style.color.ink, alpha);
      dl->AddRectFilled(a, b, on ? heddle : c.style.color.raised);
    }
    const ImVec2 swatch{x, bottom + c.style.px(4)};
    dl->AddRectFilled(swatch, {x + columns.pitch - 1, swatch.y + c.style.px(8)},
                      with_alpha(warp[static_cast<size_t>(end % d.ends())], alpha));
    if (end < now) draw_tick(c, {x + columns.pitch / 2, bottom + c.style.px(19)}, c.style.color.accent);
    else draw_number_below(c, end + 1, end == now, {x, bottom + c.style.px(14)}, columns.pitch);
  }
  if (now >= ends) return;
  const float x = columns.x(room, now);
  dl->AddRect({x - 2, room.min.y - 3}, {x + columns.pitch + 1, bottom + c.style.px(14)}, c.style.color.accent, 2, 0, 2);
}

/// The reed around the dent: the ends in each, one above the other in their colours.
void draw_reed(const PanelContext& c, const ShownStep& step, PixelRect room) {
  const Draft& d = c.design.draft;
  const int dents = dents_on_loom(c.design), now = step.number - 1;
  const float pitch = c.style.px(34), bead = c.style.px(13), tall = std::min(room.height() * 0.6f, c.style.px(190));
  const Columns columns = columns_around(c, now, dents, pitch, room);
  const auto warp = thread_colors(d, System::kWarp);
  ImDrawList* dl = ImGui::GetWindowDrawList();
  for (int dent = columns.first; dent < columns.first + columns.count; ++dent) {
    const float x = columns.x(room, dent), alpha = dent > now ? kPaleAhead : 1.0f;
    const ImU32 wire = dent == now ? c.style.color.accent : c.style.color.line_strong;
    dl->AddRect({x + 2, room.min.y}, {x + pitch - 2, room.min.y + tall}, wire, c.style.px(3), 0,
                dent == now ? 2.5f : 1);
    const DentEnds in = ends_in_dent(c.design, dent);
    const int beads = in.floating ? 1 : in.count;
    const float apart = std::min(bead + c.style.px(5), tall / static_cast<float>(beads + 1));
    for (int i = 0; i < beads; ++i) {
      const ImVec2 at{x + pitch / 2,
                      room.min.y + tall / 2 + (static_cast<float>(i) - static_cast<float>(beads - 1) / 2) * apart};
      const ImU32 color = in.floating ? c.style.color.muted : warp[static_cast<size_t>((in.first + i) % d.ends())];
      dl->AddCircleFilled(at, bead / 2, with_alpha(color, alpha));
      dl->AddCircle(at, bead / 2, with_alpha(c.style.color.line_strong, alpha));
    }
    if (dent < now) draw_tick(c, {x + pitch / 2, room.min.y + tall + c.style.px(14)}, c.style.color.accent);
    else draw_number_below(c, dent + 1, dent == now, {x, room.min.y + tall + c.style.px(8)}, pitch);
  }
}

/// The colour of this step, and the next colour or how long this one lasts.
void draw_colors(const PanelContext& c, const ShownStep& step, ImVec2 at, float room) {
  if (!step.color) return;
  const float side = c.style.px(40), size = font_size(c.style.font.text);
  draw_swatch(c, at, {at.x + side, at.y + side}, to_u32(step.color->color));
  const float x = at.x + side + c.style.px(12);
  draw_text(c.style.font.text, size, {x, at.y + c.style.px(2)}, c.style.color.text,
            fitted(step.color->text, room - side));
  if (!step.next_color) return;
  const std::string& text = step.next_color->text;
  draw_text(c.style.font.text, size, {x, at.y + side / 2}, c.style.color.muted, text);
  if (step.next_color->color == step.color->color) return;
  const float then = x + width_of(c.style.font.text, size, text) + c.style.px(10);
  draw_swatch(c, {then, at.y + side / 2}, {then + c.style.px(18), at.y + side / 2 + c.style.px(18)},
              to_u32(step.next_color->color));
}

const char* map_name(const ShownStep& step) {
  if (step.tabby) return "loom.tabby_pick:";
  if (step.work == LoomWork::kThread) return "loom.end:";
  return step.work == LoomWork::kSley ? "loom.dent:" : "loom.pick:";
}

}  // namespace

void draw_text(ImFont* font, float size, ImVec2 at, ImU32 color, const std::string& text) {
  ImGui::GetWindowDrawList()->AddText(font, size, at, color, text.c_str());
}

float width_of(ImFont* font, float size, const std::string& text) {
  return font->CalcTextSizeA(size, FLT_MAX, 0, text.c_str()).x;
}

void draw_step(const PanelContext& c, const ShownStep& step, PixelRect room) {
  ImFont *big = c.style.font.big, *title = c.style.font.title;
  const float tall = std::min(font_size(big), room.height() * 0.34f), line = font_size(title), small = line * 0.6f;
  const std::string number = std::to_string(std::min(step.number, step.of));
  draw_text(title, small, room.min, c.style.color.muted, step.heading);
  float y = room.min.y + small;
  draw_text(big, tall, {room.min.x, y}, c.style.color.text, number);
  const float beside = room.min.x + width_of(big, tall, number) + c.style.px(16);
  draw_text(title, small, {beside, y + tall * 0.64f}, c.style.color.muted,
            fill(tr("of {count}"), arg("count", step.of)));
  c.map.add(map_name(step) + std::to_string(step.number), room.min.x, y, beside - room.min.x, tall);
  y += tall + c.style.px(6);
  if (!step.group.empty()) {
    draw_text(c.style.font.text, font_size(c.style.font.text), {room.min.x, y}, c.style.color.muted,
              fitted(step.group, room.width()));
    y += font_size(c.style.font.text) + c.style.px(8);
  }
  const float fits = std::min(1.0f, room.width() / std::max(1.0f, width_of(title, line, step.what)));
  draw_text(title, line * fits, {room.min.x, y}, c.style.color.text, step.what);
  y += line + c.style.px(12);
  if (const float height = draw_shafts(c, step.shafts, {{room.min.x, y}, room.max}); height > 0)
    y += height + c.style.px(12);
  if (y + c.style.px(40) < room.max.y) draw_colors(c, step, {room.min.x, y}, room.width());
}

void draw_surroundings(const PanelContext& c, const ShownStep& step, PixelRect room) {
  switch (step.work) {
    case LoomWork::kThread:
      return draw_threading(c, step, room);
    case LoomWork::kSley:
      return draw_reed(c, step, room);
    case LoomWork::kWeave:
      return draw_drawdown(c, step.number - 1, room);
  }
}

}  // namespace weftlight::views
