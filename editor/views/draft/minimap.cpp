#include "views/draft/minimap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/text.h"
#include "ui/pixel_rect.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::tr;
using session::DocumentView, session::DrawdownStyle;
using ui::PixelRect, ui::Axis, ui::Colors, ui::clamp_scroll, ui::hit_area, ui::with_alpha;

namespace {

// Pixels at 96 dpi.
constexpr float kLongest = 150, kShortest = 26, kMargin = 10, kPad = 4, kMinPane = 150;
constexpr float kMaxOfPane = 0.42f;  // at most this fraction of each side of the pane

/// The rectangle of the minimap's image, in the corner opposite to end 1 and pick 1. None if the whole draft is visible
/// or the pane is too small.
std::optional<PixelRect> image_rect(const DraftContext& c, const DraftLayout& l) {
  const GridPane& pane = l.drawdown;
  const float min_pane = c.style.px(kMinPane);
  if (!c.settings.minimap || !(l.scroll_ends || l.scroll_picks)) return {};
  if (pane.x.length < min_pane || pane.y.length < min_pane) return {};
  const float ends = static_cast<float>(pane.x.count), picks = static_cast<float>(pane.y.count);
  const float scale = std::min({c.style.px(kLongest) / std::max(ends, picks), kMaxOfPane * pane.x.length / ends,
                                kMaxOfPane * pane.y.length / picks});
  const float short_side = c.style.px(kShortest);
  const float w = std::round(std::clamp(ends * scale, short_side, kMaxOfPane * pane.x.length));
  const float h = std::round(std::clamp(picks * scale, short_side, kMaxOfPane * pane.y.length));
  const float margin = c.style.px(kMargin + kPad);
  const float y = pane.y.reversed ? pane.min().y + margin : std::floor(pane.max().y - margin - h);
  const float x = pane.x.reversed ? pane.min().x + margin : std::floor(pane.max().x - margin - w);
  return PixelRect{{x, y}, {x + w, y + h}};
}

/// Pixel range of the visible threads.
std::pair<float, float> visible_range(const Axis& axis, float low, float length) {
  const float all = static_cast<float>(axis.count), seen = std::min(all, axis.length / axis.pitch);
  const float first = axis.scroll / all * length, wide = std::max(3.0f, seen / all * length);
  const float begins = axis.reversed ? length - first - wide : first;
  return {std::round(low + std::max(0.0f, begins)), std::round(low + std::min(length, begins + wide))};
}

/// The scroll that centres the thread at `t` of the axis, 0..1.
float scroll_at(const Axis& axis, float t) {
  const float all = static_cast<float>(axis.count);
  return clamp_scroll(axis, (axis.reversed ? 1 - t : t) * all - axis.length / axis.pitch / 2);
}

}  // namespace

/// True while it is shown, from the first move of the draft on.
void Minimap::follow(const DraftContext& c, const DraftLayout& l) {
  constexpr double kShownS = 2.5;
  const Part now{l.pitch, l.drawdown.x.scroll, l.drawdown.y.scroll};
  const double seconds = c.frame.now_s;
  const bool switched_on = c.settings.minimap && !std::exchange(wanted_, c.settings.minimap) && part_.pitch > 0;
  const bool moved = part_.pitch > 0 && !(now == part_);
  part_ = now;
  if (std::exchange(called_, false) || moved || switched_on || on_) goes_at_s_ = seconds + kShownS;
  if (goes_at_s_ >= 0 && seconds >= goes_at_s_) goes_at_s_ = -1;
}

void Minimap::apply_input(DraftContext& c, const DraftLayout& l) {
  follow(c, l);
  on_ = false;
  const std::optional<PixelRect> at = goes_at_s_ < 0 ? std::nullopt : image_rect(c, l);
  if (!at) return;
  const float pad = c.style.px(kPad);
  ImGui::SetCursorScreenPos({at->min.x - pad, at->min.y - pad});
  hit_area("minimap", {at->width() + 2 * pad, at->height() + 2 * pad});
  c.map.add_item("minimap");
  on_ = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (on_) {
    c.map.add_item("minimap.stays");
    c.frame.hint = tr("Whole drawdown: click or drag to go there");
  }
  if (!ImGui::IsItemActive()) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const float end = scroll_at(l.drawdown.x, (mouse.x - at->min.x) / at->width());
  const float pick = scroll_at(l.drawdown.y, (mouse.y - at->min.y) / at->height());
  if (end == c.view.scroll_end && pick == c.view.scroll_pick) return;
  c.wanted.change_view([=](DocumentView& v) {
    v.draft.scroll_end = end;
    v.draft.scroll_pick = pick;
  });
}

void Minimap::update(const DraftContext& c, int width, int height) {
  const bool structure = c.settings.drawdown_style == DrawdownStyle::kStructure;
  const Key key{c.revision, c.view.face, structure, c.style.dark, width, height};
  if (key == key_) return;
  key_ = key;
  const CrossingColors colors =
      structure ? two_colors(c.design.draft, c.style.color.ink, c.style.color.paper) : crossing_colors(c.design);
  if (!overview_.update(c.cells, c.view.face == Face::kFront, colors, width, height)) return;
  const CellImage& image = overview_.image();
  texture_.set(image.width, image.height, image.pixels);
}

void Minimap::draw(ImDrawList* dl, const DraftContext& c, const DraftLayout& l) {
  const std::optional<PixelRect> at = goes_at_s_ < 0 ? std::nullopt : image_rect(c, l);
  if (!at) return;
  update(c, static_cast<int>(at->width()), static_cast<int>(at->height()));
  if (texture_.empty()) return;
  const Colors& k = c.style.color;
  const float pad = c.style.px(kPad), r = c.style.px(5);
  const ImVec2 a{at->min.x - pad, at->min.y - pad}, b{at->max.x + pad, at->max.y + pad};
  dl->AddRectFilled({a.x - 1, a.y + 1}, {b.x + 1, b.y + 3}, IM_COL32(0, 0, 0, 40), r);
  dl->AddRectFilled(a, b, k.raised, r);
  dl->AddRect(a, b, k.line_strong, r);
  const float u = l.drawdown.x.reversed ? 1.0f : 0.0f, v = l.drawdown.y.reversed ? 1.0f : 0.0f;
  dl->AddImage(texture_.id(), at->min, at->max, {u, v}, {1 - u, 1 - v});
  const auto [x0, x1] = visible_range(l.drawdown.x, at->min.x, at->width());
  const auto [y0, y1] = visible_range(l.drawdown.y, at->min.y, at->height());
  // What is not visible is dimmed.
  const ImU32 veil = with_alpha(k.raised, 0.3f);
  dl->AddRectFilled(at->min, {at->max.x, y0}, veil);
  dl->AddRectFilled({at->min.x, y1}, at->max, veil);
  dl->AddRectFilled({at->min.x, y0}, {x0, y1}, veil);
  dl->AddRectFilled({x1, y0}, {at->max.x, y1}, veil);
  dl->AddRect({x0 - 1, y0 - 1}, {x1 + 1, y1 + 1}, k.paper, 0, 0, 1.0f);
  dl->AddRect({x0, y0}, {x1, y1}, k.accent, 0, 0, c.style.px(1.5f));
}

}  // namespace weftlight::views
