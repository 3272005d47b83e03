#include "views/inspector/threads_panel.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "base/decimals.h"
#include "base/text.h"
#include "design/edits.h"
#include "design/yarn_presets.h"
#include "ui/icons.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "weaves/notation.h"

namespace weftlight::views {

using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using design::Design, design::Twist, design::Yarn, design::ready_yarns, design::with_new_palette_color,
    design::with_new_yarn, design::with_thread_color, design::with_thread_spacing, design::with_thread_thickness,
    design::with_thread_yarn;
using draft::Draft, draft::Rgb, draft::System, draft::kFromYarn;
using session::DocumentView, session::Edit, session::Settings, session::SharedIndex, session::SharedLength,
    session::SharedThreads, session::ThreadProperty, session::concerned, session::shared_by, session::thread_label,
    session::threads_of_words, session::words_of_threads;
using ui::SliderSpec, ui::begin_combo, ui::draw_swatch, ui::end_combo, ui::hit_area, ui::icon_button, ui::key_pressed,
    ui::muted_text, ui::number_field, ui::open_section, ui::push_font, ui::row_label, ui::section, ui::segmented,
    ui::span_slider, ui::take_focus, ui::tooltip;
using weaves::read_sequence, weaves::sequence_text;
using wif::WifUnit;

namespace {

using Panel = ViewContext<ThreadChoice>;

constexpr float kLinkRoom = 33;      // pixels at 96 dpi, for the link button
constexpr float kOrderWidth = 200;   // of the field of an order, about 25 letters
constexpr double kTypedRestS = 0.4;  // less than the delay of a tooltip, for which a frame is drawn
constexpr float kMmPerCm = 10.0f, kMmPerInch = 25.4f;

/// The threads that the panel shows and edits.
struct Subject {
  System system;
  std::vector<int> threads;
  SharedThreads shared;
};

struct LengthSpec {
  SliderSpec slider;
  ThreadProperty property;  // for the undo label
  const char* link;         // control that resets it to the yarn's
  SharedLength SharedThreads::*shared;
  Design (*set)(Design, System, std::span<const int>, float);
};
const LengthSpec kThickness = {
    {"threads.thickness", mark("Thickness"), 0.02f, 10, "%.2f mm", mark("Diameter of the threads"), true},
    ThreadProperty::kThickness,
    "threads.thickness:yarn",
    &SharedThreads::thickness,
    with_thread_thickness};
const LengthSpec kSpacing = {{"threads.spacing", mark("Spacing"), 0.05f, 20, "%.2f mm",
                              mark("Distance between the centres of neighbouring threads in the finished cloth"), true},
                             ThreadProperty::kSpacing,
                             "threads.spacing:yarn",
                             &SharedThreads::spacing,
                             with_thread_spacing};

template <class Apply>
Edit edit_of(const Subject& s, ThreadProperty property, Apply apply) {
  return {thread_label(property, s.system, s.threads.size()),
          [apply, system = s.system, threads = s.threads](Design d) { return apply(std::move(d), system, threads); }};
}

std::string counted(System system, size_t count) {
  const auto n = static_cast<long long>(count);
  return fill(
      system == System::kWarp ? tr_n("{count} end", "{count} ends", n) : tr_n("{count} pick", "{count} picks", n),
      arg("count", n));
}

/// The number of selected threads, at the end of the field drawn last, if its text leaves room.
void draw_count(const PanelContext& c, const ThreadChoice& choice, const std::string& words) {
  const std::string count = counted(choice.system, choice.threads.size());
  const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax(), padding = ImGui::GetStyle().FramePadding;
  const float x = b.x - padding.x - ImGui::CalcTextSize(count.c_str()).x;
  if (x < a.x + 2 * padding.x + ImGui::CalcTextSize(words.c_str()).x) return;
  ImGui::GetWindowDrawList()->AddText({x, a.y + padding.y}, c.style.color.muted, count.c_str());
}

void choose(PanelContext& c, std::vector<int> threads) {
  c.wanted.change_view([threads = std::move(threads)](DocumentView& v) { v.chosen.threads = threads; });
}

/// The field that names the threads, with their number at its end.
void draw_which(Panel& c, const Draft& d, std::string& words) {
  const ThreadChoice& choice = c.view;
  const float clear = choice.threads.empty() ? 0 : ImGui::GetFrameHeight() + c.style.px(12);
  const std::string all = fill(choice.system == System::kWarp ? tr("all {count} ends") : tr("all {count} picks"),
                               arg("count", d.threads(choice.system).size()));
  const bool typing = ImGui::GetActiveID() == ImGui::GetID("##which");
  if (!typing) words = words_of_threads(choice.threads);
  take_focus(c, "threads.which");
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - clear);
  std::optional<std::vector<int>> named = threads_of_words(words, d.threads(choice.system).size());
  if (!named) ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.error);
  const bool typed = ImGui::InputTextWithHint("##which", all.c_str(), &words);
  if (!named) ImGui::PopStyleColor();
  c.map.add_item("threads.which");
  if (!typing && !choice.threads.empty()) draw_count(c, choice, words);
  tooltip(c, tr("Which threads: 3-7, 12, 20-40/2 for every other one, odd or even; empty for all. Or drag along the "
                "thread numbers beside the colour bars"));
  if (typed) named = threads_of_words(words, d.threads(choice.system).size());
  if (typed && named) choose(c, std::move(*named));
  if (clear <= 0) return;
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.muted);
  if (icon_button(c, "threads.none", icon::kClear, "x", tr("Select none: the panel then sets all threads   Esc")))
    choose(c, {});
  ImGui::PopStyleColor();
}

void draw_choice(Panel& c, std::string& typed) {
  constexpr const char* kSystems[] = {mark("Warp"), mark("Weft")};
  int system = c.view.system == System::kWarp ? 0 : 1;
  const ImVec2 at = ImGui::GetCursorPos();
  if (segmented(c, "threads.system", kSystems, system, c.style.px(96)))
    c.wanted.change_view([system](DocumentView& v) {
      v.chosen = {system == 0 ? System::kWarp : System::kWeft, {}, -1, {}, false, false};
    });
  ImGui::SetCursorPos(at);
  row_label(c, "", "");
  draw_which(c, c.design.draft, typed);
}

std::string yarn_title(const Design& d, int index) {
  return std::to_string(index + 1).append("  ").append(d.yarns[static_cast<size_t>(index)].name);
}

/// "S twist, 97 turns per metre".
std::string twist_words(const Yarn& yarn) {
  if (yarn.twist == Twist::kNone) return tr("no twist");
  return fill(
      yarn.twist == Twist::kS ? tr("S twist, {turns:.0f} turns per metre") : tr("Z twist, {turns:.0f} turns per metre"),
      arg("turns", yarn.turns_per_m));
}

/// "S 97/m".
std::string twist_mark(const Yarn& yarn) {
  if (yarn.twist == Twist::kNone) return {};
  return fill(yarn.twist == Twist::kS ? tr("S {turns:.0f}/m") : tr("Z {turns:.0f}/m"), arg("turns", yarn.turns_per_m));
}

/// The edit first, here and below: its undo brings back what was active before it.
void give_yarn(PanelContext& c, const Subject& s, int yarn) {
  c.wanted.add(edit_of(s, ThreadProperty::kYarn, [yarn](Design d, System system, const std::vector<int>& threads) {
    return with_thread_yarn(std::move(d), system, threads, yarn);
  }));
  c.wanted.change_view([yarn](DocumentView& v) { v.drawing.yarn = yarn; });
}

/// Adds a yarn to the draft, for these threads only.
void give_new_yarn(PanelContext& c, const Subject& s, const Yarn& yarn) {
  const auto index = static_cast<int>(c.design.yarns.size());
  c.wanted.add(
      edit_of(s, ThreadProperty::kYarn, [yarn, index](Design d, System system, const std::vector<int>& threads) {
        return with_thread_yarn(with_new_yarn(std::move(d), yarn), system, threads, index);
      }));
  c.wanted.change_view([index](DocumentView& v) { v.drawing.yarn = index; });
}

void give_color(PanelContext& c, const Subject& s, int color) {
  c.wanted.add(edit_of(s, ThreadProperty::kColor, [color](Design d, System system, const std::vector<int>& threads) {
    return with_thread_color(std::move(d), system, threads, color);
  }));
  c.wanted.change_view([color](DocumentView& v) { v.drawing.color = color; });
}

/// Adds a copy of the threads' colour to the palette, for these threads only.
void give_new_color(PanelContext& c, const Subject& s) {
  const auto& palette = c.design.draft.palette;
  const auto index = static_cast<int>(palette.size());
  const Rgb copy = palette[static_cast<size_t>(s.shared.color.value)];
  c.wanted.add(
      edit_of(s, ThreadProperty::kColor, [copy, index](Design d, System system, const std::vector<int>& threads) {
        return with_thread_color(with_new_palette_color(std::move(d), copy), system, threads, index);
      }));
  c.wanted.change_view([index](DocumentView& v) { v.drawing.color = index; });
}

void draw_yarn(PanelContext& c, const Subject& s) {
  row_label(c, tr("Yarn"), tr("The yarn of the threads: its fibre, count and twist, which are set under Yarns"));
  ImGui::SetNextItemWidth(-FLT_MIN);
  const SharedIndex& yarn = s.shared.yarn;
  const std::string shown = yarn.mixed() ? tr("mixed") : yarn_title(c.design, yarn.value);
  if (!begin_combo(c, "threads.yarn", shown.c_str())) {
    if (!yarn.mixed()) tooltip(c, twist_words(c.design.yarns[static_cast<size_t>(yarn.value)]).c_str());
    return;
  }
  for (int i = 0; i < static_cast<int>(c.design.yarns.size()); ++i) {
    ImGui::PushID(i);
    const std::string twisted = yarn_title(c.design, i) + "   " + twist_mark(c.design.yarns[static_cast<size_t>(i)]);
    if (ImGui::Selectable(twisted.c_str(), !yarn.mixed() && i == yarn.value)) give_yarn(c, s, i);
    ImGui::PopID();
    c.map.add_item("threads.yarn:" + std::to_string(i + 1));
    tooltip(c, twist_words(c.design.yarns[static_cast<size_t>(i)]).c_str());
  }
  ImGui::Separator();
  const Yarn& source = c.design.yarns[static_cast<size_t>(yarn.value)];
  if (ImGui::Selectable(tr("New: copy of this yarn"))) give_new_yarn(c, s, source);
  c.map.add_item("threads.yarn:own");
  tooltip(c, tr("A copy for these threads only, so that their twist can be changed"));
  for (const Yarn& ready : ready_yarns()) {
    if (ImGui::Selectable(fill(tr("New: {yarn}"), arg("yarn", tr(ready.name.c_str()))).c_str()))
      give_new_yarn(c, s, ready);
    c.map.add_item("threads.yarn:" + ready.name);
  }
  end_combo();
}

/// The colours of the threads, over the frame of a drop-down list from `a` to `b`.
void draw_shared_colors(const PanelContext& c, const SharedIndex& color, ImVec2 a, ImVec2 b) {
  const float side = c.style.px(18), step = c.style.px(21),
              top = static_cast<float>(static_cast<int>((a.y + b.y - side) / 2));
  float x = a.x + c.style.px(6);
  const auto swatch = [&](int index) {
    draw_swatch(c, {x, top}, {x + side, top + side}, to_u32(c.design.draft.palette[static_cast<size_t>(index)]));
    x += step;
  };
  swatch(color.value);
  for (size_t i = 0; i < color.others.size() && x + step < b.x - c.style.px(24); ++i) swatch(color.others[i]);
  if (color.mixed()) return;
  const std::string name = fill(tr("Colour {number}"), arg("number", color.value + 1));
  ImGui::GetWindowDrawList()->AddText({x + c.style.px(5), a.y + ImGui::GetStyle().FramePadding.y}, c.style.color.text,
                                      name.c_str());
}

/// The colours in order, repeated over the threads; none if the text cannot be read.
MaybeEdit color_order_edit(const PanelContext& c, const Subject& s, const std::string& typed) {
  const auto read = read_sequence(typed, static_cast<int>(c.design.draft.palette.size()));
  if (!read.note.empty() || read.value.empty()) return {};
  return edit_of(s, ThreadProperty::kColor,
                 [order = read.value](Design d, System system, const std::vector<int>& threads) {
                   for (size_t i = 0; i < threads.size(); ++i)
                     d = with_thread_color(std::move(d), system, threads[i], order[i % order.size()]);
                   return d;
                 });
}

std::string color_order(const Design& d, const Subject& s) {
  const std::vector<int>& colors = d.draft.threads(s.system).color;
  std::vector<int> order;
  for (const int thread : s.threads) order.push_back(colors[static_cast<size_t>(thread)]);
  return sequence_text(order);
}

/// The order of the colours by their numbers. The threads follow when the typing rests; Enter closes the list.
void draw_color_order(PanelContext& c, const Subject& s, TypedThreads& typed) {
  const float width = c.style.px(kOrderWidth);
  if (ImGui::IsWindowAppearing()) typed.order = color_order(c.design, s), typed.order_waits = {};
  const std::string note = read_sequence(typed.order, static_cast<int>(c.design.draft.palette.size())).note;
  muted_text(c, tr("In order, repeated"));
  ImGui::SetNextItemWidth(width);
  if (!note.empty()) ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.error);
  const bool changed = ImGui::InputTextWithHint("##order", "4x1 2x2", &typed.order);
  if (!note.empty()) ImGui::PopStyleColor();
  c.map.add_item("threads.color:order");
  const bool entered = ImGui::IsItemDeactivated() && key_pressed(ImGuiKey_Enter, false);
  tooltip(c, tr("Numbers of the colours, repeated over the threads: 4x1 2x2 is four threads of colour 1 and two of "
                "colour 2; 3x(1 2) repeats what is in brackets"));
  if (!note.empty()) {
    ImGui::PushTextWrapPos(width);
    ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.error);
    ImGui::TextUnformatted(note.c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    c.map.add_item("threads.color:note");
  }
  // On the way to "24x1" there are the numbers 2 and 24.
  if (changed) typed.order_waits = color_order_edit(c, s, typed.order);
  if (entered || (!changed && c.tip.rest_s >= kTypedRestS)) c.wanted.add(std::exchange(typed.order_waits, {}));
  if (entered && note.empty()) ImGui::CloseCurrentPopup();
}

void draw_color_choices(PanelContext& c, const Subject& s, TypedThreads& typed) {
  const auto& palette = c.design.draft.palette;
  const float side = c.style.pressed_px(24), gap = c.style.px(6);
  for (int i = 0; i < static_cast<int>(palette.size()); ++i) {
    if (i % 6 != 0) ImGui::SameLine(0, gap);
    const ImVec2 a = ImGui::GetCursorScreenPos();
    ImGui::PushID(i);
    if (hit_area("color", {side, side})) {
      give_color(c, s, i);
      typed.order_waits = {};
      ImGui::CloseCurrentPopup();
    }
    ImGui::PopID();
    c.map.add_item("threads.color:" + std::to_string(i + 1));
    if (ImGui::IsItemVisible())
      draw_swatch(c, a, {a.x + side, a.y + side}, to_u32(palette[static_cast<size_t>(i)]),
                  !s.shared.color.mixed() && i == s.shared.color.value);
    tooltip(c, fill(tr("Colour {number}"), arg("number", i + 1)).c_str());
  }
  ImGui::Dummy({0, c.style.px(2)});
  if (ImGui::Selectable(tr("New colour"))) give_new_color(c, s), typed.order_waits = {};
  c.map.add_item("threads.color:new");
  tooltip(c, tr("Added to the palette for these threads, and made active so that it can be edited above"));
  ImGui::Separator();
  draw_color_order(c, s, typed);
}

void draw_color(PanelContext& c, const Subject& s, TypedThreads& typed) {
  row_label(c, tr("Colour"), tr("The colour of the threads, from the palette, or an order of colours"));
  ImGui::SetNextItemWidth(-FLT_MIN);
  const ImVec2 a = ImGui::GetCursorScreenPos(),
               b{a.x + ImGui::GetContentRegionAvail().x, a.y + ImGui::GetFrameHeight()};
  const bool open = begin_combo(c, "threads.color", "");
  if (open) {
    draw_color_choices(c, s, typed);
    end_combo();
  } else if (MaybeEdit left = std::exchange(typed.order_waits, {}); !c.frame.popup_closed) {  // not by Escape
    c.wanted.add(std::move(left));
  }
  draw_shared_colors(c, s.shared.color, a, b);
}

/// To a hundredth of a millimetre, which is finer than yarns are specified.
float rounded(float mm) { return std::round(mm * 100) / 100; }

/// Shows whether the value comes from the yarn, and resets it to the yarn's. True if pressed.
bool draw_link(PanelContext& c, const LengthSpec& spec, const SharedLength& length) {
  ImGui::SameLine(0, c.style.px(4));
  const bool own = length.own > 0;
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.muted);
  const bool pressed = icon_button(
      c, spec.link, own ? icon::kUnlinked : icon::kLinked, own ? tr("custom") : tr("yarn"),
      own ? tr("Set for these threads. Click to use the value of the yarn again") : tr("From the yarn"), own);
  ImGui::PopStyleColor();
  return pressed;
}

MaybeEdit draw_length(PanelContext& c, const Subject& s, const LengthSpec& spec) {
  const SharedLength& length = s.shared.*spec.shared;
  // For mixed values, a number that nobody types, so that any typed one is a change.
  float mm = length.mixed() ? (length.low + length.high) / 2 * 1.0001f : length.low;
  MaybeEdit edit;
  if (span_slider(c, ui::translated(spec.slider), {length.low, length.high, length.own == 0, c.style.px(kLinkRoom)},
                  mm))
    edit = edit_of(s, spec.property,
                   [set = spec.set, mm = rounded(mm)](Design d, System system, const std::vector<int>& threads) {
                     return set(std::move(d), system, threads, mm);
                   });
  if (draw_link(c, spec, length))
    edit = edit_of(s, spec.property, [set = spec.set](Design d, System system, const std::vector<int>& threads) {
      return set(std::move(d), system, threads, kFromYarn);
    });
  return edit;
}

/// The spacing as sett: threads per centimetre or inch.
MaybeEdit draw_sett(PanelContext& c, const Subject& s) {
  const bool warp = s.system == System::kWarp;
  const char* tip = sett_tip(s.system);
  row_label(c, warp ? tr("Ends") : tr("Picks"), tip);
  const bool inches = c.settings.imperial;
  const float unit = inches ? kMmPerInch : kMmPerCm;
  const SharedLength& spacing = s.shared.spacing;
  float sett = unit / std::max(spacing.mixed() ? (spacing.low + spacing.high) / 2 * 1.0001f : spacing.low, 1e-3f);
  const SliderSpec field{"threads.sett", "", 0.5f, inches ? 500.0f : 200.0f, "%.2f", tip};
  const float width = c.style.px(66);
  MaybeEdit edit;
  if (number_field(c, field, spacing.mixed(), width, sett) && sett > 0)
    edit = edit_of(s, ThreadProperty::kSpacing,
                   [mm = unit / sett](Design d, System system, const std::vector<int>& threads) {
                     return with_thread_spacing(std::move(d), system, threads, mm);
                   });
  ImGui::SameLine();
  constexpr const char* kUnits[] = {mark("/cm"), mark("/inch")};
  int chosen = inches ? 1 : 0;
  if (segmented(c, "threads.per", kUnits, chosen))
    c.wanted.change_settings([chosen](Settings& settings) { settings.imperial = chosen == 1; });
  return edit;
}

std::string in_unit(const SharedLength& length, double unit_mm) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", static_cast<double>(length.low) / unit_mm);
  return length.mixed() ? tr("mixed") : base::with_decimal_point(text);
}

/// Thickness and spacing in the unit of the file, if that is not the centimetre.
void draw_file_words(const PanelContext& c, const FileUnits& units, const Subject& s) {
  const WifUnit& unit = s.system == System::kWarp ? units.warp : units.weft;
  if (unit.mm == static_cast<double>(kMmPerCm)) return;
  const SharedLength &thickness = s.shared.thickness, &spacing = s.shared.spacing;
  if (thickness.own <= 0 && spacing.own <= 0) return;
  const char* pattern = spacing.own <= 0     ? tr("thickness {thickness}")
                        : thickness.own <= 0 ? tr("spacing {spacing}")
                                             : tr("thickness {thickness}, spacing {spacing}");
  const std::string text =
      fill(pattern, arg("thickness", in_unit(thickness, unit.mm)), arg("spacing", in_unit(spacing, unit.mm)));
  push_font(c.style.font.small);
  row_label(c, unit.name.c_str(), tr("The values in the unit of the file, in which they are saved"));
  muted_text(c, text);
  ImGui::PopFont();
}

}  // namespace

const char* sett_tip(System system) {
  return system == System::kWarp
             ? tr("Sett of the finished cloth, as the draft is drawn: ends per centimetre or inch. The Plan page has "
                  "the "
                  "sett on the loom")
             : tr("Sett of the finished cloth, as the draft is drawn: picks per centimetre or inch. The Plan page has "
                  "the sett on the loom");
}

MaybeEdit draw_threads(const PanelContext& panel, const ThreadChoice& chosen, const FileUnits& units,
                       TypedThreads& typed) {
  Panel c{panel, chosen};
  if (c.focus.starts_with("threads.")) open_section("section.threads");
  if (!section(c, "section.threads", tr("Threads"))) return {};
  draw_choice(c, typed.which);
  Subject s{c.view.system, concerned(c.view, c.design.draft), {}};
  if (s.threads.empty()) return {};
  s.shared = shared_by(c.design, s.system, s.threads);
  draw_yarn(c, s);
  draw_color(c, s, typed);
  MaybeEdit edit;
  const auto take = [&edit](MaybeEdit made) {
    if (made) edit = std::move(made);
  };
  take(draw_length(c, s, kThickness));
  take(draw_length(c, s, kSpacing));
  take(draw_sett(c, s));
  draw_file_words(c, units, s);
  return edit;
}

}  // namespace weftlight::views
