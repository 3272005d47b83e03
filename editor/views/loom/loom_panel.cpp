#include "views/loom/loom_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/common/cell_image.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using design::Design;
using draft::BitMatrix, draft::ShedControl, draft::System, draft::lifts;
using session::DocumentView, session::Settings, session::go_to_pick, session::keep_to_section, session::place_of,
    session::to_press;
using ui::blend, ui::draw_swatch, ui::fitted, ui::font_size, ui::muted_text, ui::push_font, ui::reading_color,
    ui::row_label, ui::segmented, ui::text_button, ui::with_alpha;

std::string press_text(const Draft& draft, int pick) {
  const std::vector<int> marks = to_press(draft, pick);
  const bool liftplan = draft.shed_control == ShedControl::kLiftplan;
  if (marks.empty()) return liftplan ? tr("Lift nothing") : tr("No treadle");
  std::string numbers;
  for (const int mark : marks) numbers.append(numbers.empty() ? "" : " + ").append(std::to_string(mark + 1));
  const char* text = !liftplan ? tr("Treadle {numbers}") : draft.rising ? tr("Lift {numbers}") : tr("Lower {numbers}");
  return fill(text, arg("numbers", numbers));
}

namespace {

using Panel = ViewContext<AtLoom>;

// Pixels at 96 dpi.
constexpr float kMargin = 28, kFoot = 150, kLargestShaft = 64, kMinForStrip = 900;
constexpr float kStripPitch = 20, kWovenShare = 0.6f;  // fraction of the strip before the current pick

struct PixelRect {
  ImVec2 min, max;
  float width() const { return max.x - min.x; }
  float height() const { return max.y - min.y; }
};

void draw_text(ImFont* font, float size, ImVec2 at, ImU32 color, const std::string& text) {
  ImGui::GetWindowDrawList()->AddText(font, size, at, color, text.c_str());
}

float width_of(ImFont* font, float size, const std::string& text) {
  return font->CalcTextSizeA(size, FLT_MAX, 0, text.c_str()).x;
}

/// The shafts, numbered from the left; those that are up in the pick are filled.
void draw_shafts(const PanelContext& c, const BitMatrix& up, int pick, PixelRect room) {
  const int shafts = c.design.draft.shafts;
  const float gap = c.style.px(shafts > 16 ? 3 : 6);
  const float side =
      std::floor(std::min(c.style.px(kLargestShaft), (room.width() + gap) / static_cast<float>(shafts) - gap));
  if (side < 4) return;
  ImDrawList* dl = ImGui::GetWindowDrawList();
  for (int s = 0; s < shafts; ++s) {
    const bool on = up.get(pick, s) == c.design.draft.rising;
    const float x = room.min.x + static_cast<float>(s) * (side + gap);
    const ImVec2 a{x, room.min.y}, b{x + side, room.min.y + side};
    dl->AddRectFilled(a, b, on ? c.style.color.accent : c.style.color.raised, c.style.px(4));
    if (!on) dl->AddRect(a, b, c.style.color.line_strong, c.style.px(4));
    const std::string number = std::to_string(s + 1);
    const float size = std::min(side * 0.5f, font_size(c.style.font.title));
    if (size < 8) continue;
    draw_text(c.style.font.title, size,
              {x + (side - width_of(c.style.font.title, size, number)) / 2, a.y + (side - size) / 2},
              on ? reading_color(c.style.color.accent) : c.style.color.muted, number);
  }
}

/// The drawdown around the pick, with woven picks above it and later ones below, or reversed if pick 1 is at the
/// bottom.
void draw_strip(const PanelContext& c, int pick, PixelRect room) {
  const Draft& d = c.design.draft;
  const float pitch = c.style.px(kStripPitch);
  const int rows = std::max(1, static_cast<int>(room.height() / pitch));
  const int woven = static_cast<int>(static_cast<float>(rows) * kWovenShare);
  const bool up = c.settings.pick1_bottom;
  const int pick_row = up ? rows - 1 - woven : woven;  // the row of the pick
  const int columns = std::min(d.ends(), static_cast<int>(room.width() / pitch));
  const auto warp = thread_colors(d, System::kWarp), weft = thread_colors(d, System::kWeft);
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const float width = static_cast<float>(columns) * pitch;
  for (int row = 0; row < rows; ++row) {
    const int p = up ? pick + pick_row - row : pick - pick_row + row;
    if (p < 0 || p >= d.picks()) continue;
    const float y = room.min.y + static_cast<float>(row) * pitch;
    const float alpha = p > pick ? 0.35f : 1.0f;
    for (int i = 0; i < columns; ++i) {
      const int end = c.settings.end1_right ? columns - 1 - i : i;
      const ImU32 color = c.cells.get(p, end) ? warp[static_cast<size_t>(end)] : weft[static_cast<size_t>(p)];
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

/// The colour of this pick, and the next colour or how long this one lasts.
void draw_colors(const PanelContext& c, int pick, int next, ImVec2 at, float room) {
  const Draft& d = c.design.draft;
  const auto color = [&](int p) { return d.weft.color[static_cast<size_t>(p)]; };
  const auto yarn = [&](int p) {
    return c.design.yarns[static_cast<size_t>(d.weft.yarn[static_cast<size_t>(p)])].name;
  };
  const float side = c.style.px(40), size = font_size(c.style.font.text);
  draw_swatch(c, at, {at.x + side, at.y + side}, to_u32(d.palette[static_cast<size_t>(color(pick))]));
  const float x = at.x + side + c.style.px(12);
  draw_text(c.style.font.text, size, {x, at.y + c.style.px(2)}, c.style.color.text,
            fitted(fill(tr("Colour {number}, {yarn}"), arg("number", color(pick) + 1), arg("yarn", yarn(pick))),
                   room - side));
  if (color(next) == color(pick)) {
    int same = 0;
    while (pick + same < d.picks() && color(pick + same) == color(pick)) ++same;
    return draw_text(c.style.font.text, size, {x, at.y + side / 2}, c.style.color.muted,
                     same > 1 ? fill(tr_n("for {count} pick", "for {count} picks", same), arg("count", same)) : "");
  }
  draw_text(c.style.font.text, size, {x, at.y + side / 2}, c.style.color.muted, tr("then"));
  const float then = x + width_of(c.style.font.text, size, tr("then")) + c.style.px(10);
  draw_swatch(c, {then, at.y + side / 2}, {then + c.style.px(18), at.y + side / 2 + c.style.px(18)},
              to_u32(d.palette[static_cast<size_t>(color(next))]));
}

void draw_pick(Panel& c, const BitMatrix& up, const loom::WeavingState& place, PixelRect room) {
  const Draft& d = c.design.draft;
  const int pick = place.next_pick;
  ImFont *big = c.style.font.big, *title = c.style.font.title;
  const float tall = std::min(font_size(big), room.height() * 0.38f), line = font_size(title);
  const std::string number = std::to_string(pick + 1);
  draw_text(title, line * 0.6f, room.min, c.style.color.muted, tr("Pick"));
  float y = room.min.y + line * 0.6f;
  draw_text(big, tall, {room.min.x, y}, c.style.color.text, number);
  const float beside = room.min.x + width_of(big, tall, number) + c.style.px(16);
  draw_text(title, line * 0.6f, {beside, y + tall * 0.64f}, c.style.color.muted,
            fill(tr("of {count}"), arg("count", d.picks())));
  c.map.add("loom.pick:" + number, room.min.x, y, beside - room.min.x, tall);
  y += tall + c.style.px(14);
  const std::string press = press_text(d, pick);
  const float fits = std::min(1.0f, room.width() / std::max(1.0f, width_of(title, line, press)));
  draw_text(title, line * fits, {room.min.x, y}, c.style.color.text, press);
  y += line + c.style.px(14);
  draw_shafts(c, up, pick, {{room.min.x, y}, room.max});
  y += c.style.px(kLargestShaft) + c.style.px(18);
  const loom::WeavingState after = loom::advanced(place, c.view.section, d.picks());
  if (y + c.style.px(40) < room.max.y) draw_colors(c, pick, after.next_pick, {room.min.x, y}, room.width());
}

std::string line_text(const LoomLine& line, loom::Protocol protocol) {
  switch (line.state) {
    case LoomLink::State::kOff:
      return tr("Not connected. Space or a click: next pick; Backspace: previous pick");
    case LoomLink::State::kConnecting:
      return line.why.empty() ? tr("Connecting to the loom\xE2\x80\xA6")
                              : fill(tr("Trying again: {reason}"), arg("reason", line.why));
    case LoomLink::State::kConnected:
      break;
  }
  return protocol == loom::Protocol::kToikaEs
             ? tr("Connected. This loom does not ask for picks; press Space for the next one")
             : tr("Connected. The loom asks for each pick");
}

void draw_line(Panel& c, const LoomLine& line, std::string& address) {
  constexpr const char* kProtocols[] = {mark("Plain"), "S\xC3\xA9guin", "Toika ES"};
  int protocol = static_cast<int>(c.view.protocol);
  row_label(c, tr("Loom address"), tr("tcp:HOST:PORT or serial:/dev/ttyUSB0, followed by :BAUD if it is not 9600"));
  ImGui::SetNextItemWidth(c.style.px(220));
  const bool enter =
      ImGui::InputTextWithHint("##address", "tcp:HOST:PORT", &address, ImGuiInputTextFlags_EnterReturnsTrue);
  c.map.add_item("loom.address");
  if (address != c.settings.loom_address)
    c.wanted.change_settings([address](Settings& s) { s.loom_address = address; });
  ImGui::SameLine();
  if (segmented(c, "loom.protocol", kProtocols, protocol, c.style.px(240)))
    c.wanted.change_view([protocol](DocumentView& v) { v.at_loom.protocol = static_cast<loom::Protocol>(protocol); });
  ImGui::SameLine();
  const bool off = line.state == LoomLink::State::kOff;
  if (text_button(c, off ? "loom.connect" : "loom.disconnect", off ? tr("Connect") : tr("Disconnect"), nullptr) ||
      (enter && off))
    c.wanted.add_action(off ? "loom_connect" : "loom_disconnect");
  const bool bad = !line.why.empty() || !c.view.remark.empty();
  ImGui::PushStyleColor(ImGuiCol_Text, bad ? c.style.color.warn : c.style.color.muted);
  row_label(c, "", nullptr);
  ImGui::TextUnformatted(
      fitted(c.view.remark.empty() ? line_text(line, c.view.protocol) : c.view.remark, ImGui::GetContentRegionAvail().x)
          .c_str());
  ImGui::PopStyleColor();
  c.map.add_item(line.state == LoomLink::State::kConnected ? "loom.connected" : "loom.line");
}

/// First and last pick of the section, counted from 1.
void draw_section(Panel& c) {
  const int picks = c.design.draft.picks();
  const loom::PickRange now = c.view.section;
  int first = now.first < now.end ? now.first + 1 : 1, last = now.first < now.end ? now.end : picks;
  row_label(c, tr("Section"), tr("Picks to weave again and again"));
  push_font(c.style.font.mono);
  ImGui::SetNextItemWidth(c.style.px(110));
  bool changed = ImGui::InputInt("##first", &first);
  c.map.add_item("loom.first");
  ImGui::SameLine();
  ImGui::TextUnformatted("\xE2\x80\x93");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(c.style.px(110));
  changed |= ImGui::InputInt("##last", &last);
  c.map.add_item("loom.last");
  ImGui::PopFont();
  if (changed)
    c.wanted.gesture([first, last, picks](DocumentView& v, const Design& d) {
      const int from = std::clamp(first, 1, picks) - 1, to = std::clamp(last, from + 1, picks);
      return keep_to_section(v.at_loom, d, from == 0 && to == picks ? loom::PickRange{} : loom::PickRange{from, to})
          .edit;
    });
  ImGui::SameLine();
  if (text_button(c, "loom.whole", tr("Whole draft"), nullptr))
    c.wanted.gesture([](DocumentView& v, const Design& d) { return keep_to_section(v.at_loom, d, {}).edit; });
  ImGui::SameLine(0, c.style.px(20));
  ImGui::AlignTextToFramePadding();
  const auto woven = c.view.place.woven;
  muted_text(c, fill(tr_n("Woven: {count} pick", "Woven: {count} picks", woven), arg("count", woven)));
}

void draw_steps(PanelContext& c) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {c.style.px(22), c.style.px(10)});
  if (text_button(c, "loom.back", tr("Back"), tr("Previous pick   Backspace"))) c.wanted.add_action("loom_back");
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Button, c.style.color.accent);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, blend(c.style.color.accent, c.style.color.text, 0.15f));
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.paper);
  if (text_button(c, "loom.next", tr("Next pick"), tr("Next pick   Space"))) c.wanted.add_action("loom_next");
  ImGui::PopStyleColor(3);
  ImGui::SameLine();
  if (text_button(c, "loom.first_pick", tr("First pick"), tr("Start the section again")))
    c.wanted.gesture([](DocumentView& v, const Design& d) { return go_to_pick(v.at_loom, d, 0).edit; });
  ImGui::SameLine();
  if (text_button(c, "loom.done", tr("Leave loom"), tr("Back to the draft, which keeps your place   F9")))
    c.wanted.add_action("loom");
  ImGui::PopStyleVar();
}

}  // namespace

void draw_loom(const PanelContext& panel, const AtLoom& at_loom, const LoomLine& line, std::string& address) {
  Panel c{panel, at_loom};
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  const float margin = c.style.px(kMargin), foot = c.style.px(kFoot);
  PixelRect room{{at.x + margin, at.y + margin}, {at.x + size.x - margin, at.y + size.y - foot - margin}};
  const loom::WeavingState place = place_of(c.view, c.design);
  const bool strip = size.x >= c.style.px(kMinForStrip);
  if (place.next_pick < c.design.draft.picks() && room.height() > 40) {
    const float right = room.max.x;
    if (strip) room.max.x = at.x + size.x * 0.56f;
    draw_pick(c, lifts(c.design.draft), place, room);
    if (strip)
      draw_strip(c, place.next_pick, {{room.max.x + margin, room.min.y}, {right - c.style.px(48), room.max.y}});
  }
  ImGui::SetCursorScreenPos({at.x + margin, at.y + std::max(0.0f, size.y - foot - c.style.px(8))});
  ImGui::BeginGroup();
  draw_steps(c);
  ImGui::Dummy({0, c.style.px(2)});
  draw_section(c);
  draw_line(c, line, address);
  ImGui::EndGroup();
}

}  // namespace weftlight::views
