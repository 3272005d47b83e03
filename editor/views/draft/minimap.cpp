#include "views/draft/minimap.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/widgets.h"

namespace weftlight::views {
namespace {

// Pixels at 96 dpi.
constexpr float kLongest = 150, kShortest = 26, kMargin = 10, kPad = 4, kMinPane = 150;
constexpr float kMaxOfPane = 0.42f;  // along each side

struct Place {
  ImVec2 min, max;
  float width() const { return max.x - min.x; }
  float height() const { return max.y - min.y; }
};

/// Of its picture; none where the draft is in sight, or the pane too small. In the corner far from end 1 and pick 1.
std::optional<Place> place_of(const PanelContext& c, const DraftLayout& l) {
  const GridPane& pane = l.drawdown;
  const float least = c.style.px(kMinPane);
  if (!c.settings.minimap || !(l.scroll_ends || l.scroll_picks)) return {};
  if (pane.x.length < least || pane.y.length < least) return {};
  const float ends = static_cast<float>(pane.x.count), picks = static_cast<float>(pane.y.count);
  const float scale = std::min({c.style.px(kLongest) / std::max(ends, picks), kMaxOfPane * pane.x.length / ends,
                                kMaxOfPane * pane.y.length / picks});
  const float short_side = c.style.px(kShortest);
  const float w = std::round(std::clamp(ends * scale, short_side, kMaxOfPane * pane.x.length));
  const float h = std::round(std::clamp(picks * scale, short_side, kMaxOfPane * pane.y.length));
  const float margin = c.style.px(kMargin + kPad);
  const float y = pane.y.reversed ? pane.min().y + margin : std::floor(pane.max().y - margin - h);
  const float x = pane.x.reversed ? pane.min().x + margin : std::floor(pane.max().x - margin - w);
  return Place{{x, y}, {x + w, y + h}};
}

/// Pixels of a stretch of threads.
std::pair<float, float> stretch(const Axis& axis, float low, float length) {
  const float all = static_cast<float>(axis.count), seen = std::min(all, axis.length / axis.pitch);
  const float first = axis.scroll / all * length, wide = std::max(3.0f, seen / all * length);
  const float begins = axis.reversed ? length - first - wide : first;
  return {std::round(low + std::max(0.0f, begins)), std::round(low + std::min(length, begins + wide))};
}

/// Scroll that brings the thread under a pixel into the middle.
float scroll_at(const Axis& axis, float share) {
  const float all = static_cast<float>(axis.count);
  return clamp_scroll(axis, (axis.reversed ? 1 - share : share) * all - axis.length / axis.pitch / 2);
}

}  // namespace

void Minimap::apply_input(PanelContext& c, const DraftLayout& l) {
  const std::optional<Place> at = place_of(c, l);
  if (!at) return;
  const float pad = c.style.px(kPad);
  ImGui::SetCursorScreenPos({at->min.x - pad, at->min.y - pad});
  hit_area("minimap", {at->width() + 2 * pad, at->height() + 2 * pad});
  c.map.add_item("minimap");
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) c.frame.hint = "The whole drawdown: click or drag to go there";
  if (!ImGui::IsItemActive()) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const float end = scroll_at(l.drawdown.x, (mouse.x - at->min.x) / at->width());
  const float pick = scroll_at(l.drawdown.y, (mouse.y - at->min.y) / at->height());
  if (end == c.view.scroll_end && pick == c.view.scroll_pick) return;
  c.wanted.change_view([=](DocumentView& v) {
    v.scroll_end = end;
    v.scroll_pick = pick;
  });
}

void Minimap::follow(const PanelContext& c, int width, int height) {
  const bool structure = c.settings.drawdown_style == DrawdownStyle::kStructure;
  const Key key{c.revision, c.view.face, structure, c.style.dark, width, height};
  if (key == key_) return;
  key_ = key;
  const Draft& d = c.design.draft;
  const auto warp = structure ? std::vector<ImU32>(static_cast<size_t>(d.ends()), c.style.color.ink)
                              : thread_colors(d, System::kWarp);
  const auto weft = structure ? std::vector<ImU32>(static_cast<size_t>(d.picks()), c.style.color.paper)
                              : thread_colors(d, System::kWeft);
  if (!overview_.follow(c.cells, c.view.face == Face::kFront, warp, weft, width, height)) return;
  const CellImage& image = overview_.image();
  texture_.set(image.width, image.height, image.pixels);
}

void Minimap::draw(ImDrawList* dl, const PanelContext& c, const DraftLayout& l) {
  const std::optional<Place> at = place_of(c, l);
  if (!at) return;
  follow(c, static_cast<int>(at->width()), static_cast<int>(at->height()));
  if (texture_.empty()) return;
  const Colors& k = c.style.color;
  const float pad = c.style.px(kPad), r = c.style.px(5);
  const ImVec2 a{at->min.x - pad, at->min.y - pad}, b{at->max.x + pad, at->max.y + pad};
  dl->AddRectFilled({a.x - 1, a.y + 1}, {b.x + 1, b.y + 3}, IM_COL32(0, 0, 0, 40), r);
  dl->AddRectFilled(a, b, k.raised, r);
  dl->AddRect(a, b, k.line_strong, r);
  const float u = l.drawdown.x.reversed ? 1.0f : 0.0f, v = l.drawdown.y.reversed ? 1.0f : 0.0f;
  dl->AddImage(texture_.id(), at->min, at->max, {u, v}, {1 - u, 1 - v});
  const auto [x0, x1] = stretch(l.drawdown.x, at->min.x, at->width());
  const auto [y0, y1] = stretch(l.drawdown.y, at->min.y, at->height());
  // What is out of sight steps back.
  const ImU32 veil = with_alpha(k.raised, 0.3f);
  dl->AddRectFilled(at->min, {at->max.x, y0}, veil);
  dl->AddRectFilled({at->min.x, y1}, at->max, veil);
  dl->AddRectFilled({at->min.x, y0}, {x0, y1}, veil);
  dl->AddRectFilled({x1, y0}, {at->max.x, y1}, veil);
  dl->AddRect({x0 - 1, y0 - 1}, {x1 + 1, y1 + 1}, k.paper, 0, 0, 1.0f);
  dl->AddRect({x0, y0}, {x1, y1}, k.accent, 0, 0, c.style.px(1.5f));
}

}  // namespace weftlight::views
