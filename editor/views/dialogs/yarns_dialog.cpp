#include "views/dialogs/yarns_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/units.h"
#include "base/text.h"
#include "design/fibre.h"
#include "design/written_count.h"
#include "design/yarn_presets.h"
#include "ui/icons.h"
#include "ui/imgui_compat.h"
#include "ui/keyboard.h"
#include "ui/widgets.h"

namespace weftlight::views {

using analysis::kOunce_g, analysis::kPound_g, analysis::kYard_m;
using base::arg, base::fill, base::mark, base::tr;
using design::UsedYarn, design::Yarn, design::YarnColor, design::as_written, design::fibre_name,
    design::library_yarn_of, design::matches, design::with_count, design::with_fibre, design::with_yarn_from,
    design::written_count, design::yarn_presets;
using session::DocumentView, session::Edit, session::MaybeEdit, session::keep_yarn, session::remove_yarn,
    session::replace_yarn;
using ui::begin_combo, ui::begin_list, ui::draw_swatch, ui::end_combo, ui::fitted, ui::hit_area, ui::icon_button,
    ui::key_pressed, ui::keyboard_frame_shown, ui::list_row, ui::muted_text, ui::push_font, ui::row_label,
    ui::segmented, ui::slider, ui::text_button;

namespace {

// Pixels at 96 dpi.
constexpr float kListWidth = 670, kFieldsWidth = 320, kRow = 44, kStripWidth = 84, kStripHeight = 26, kGap = 16;
constexpr float kName = 104, kCountWidth = 84, kFibreWidth = 92, kPriceWidth = 112, kDotsWidth = 88, kDot = 13;
constexpr float kAround = 92;      // the dialog beside its two columns
constexpr float kWithFibre = 600;  // a list of that width has room for the fibre
constexpr size_t kMaxDots = 5;

std::string count_text(const LibraryYarn& y) { return y.count.empty() ? written_count(y.yarn) : y.count; }

std::string price_text(const LibraryYarn& y, bool imperial) {
  if (!(y.price > 0)) return {};
  if (y.cone_m > 0)
    return fill(imperial ? tr("{price:.2f} / {size:.0f} yd") : tr("{price:.2f} / {size:.0f} m"), arg("price", y.price),
                arg("size", static_cast<double>(y.cone_m) / (imperial ? kYard_m : 1)));
  if (y.cone_g > 0)
    return fill(imperial ? tr("{price:.2f} / {size:.1f} oz") : tr("{price:.2f} / {size:.0f} g"), arg("price", y.price),
                arg("size", static_cast<double>(y.cone_g) / (imperial ? kOunce_g : 1)));
  return fill(imperial ? tr("{price:.2f} /lb") : tr("{price:.2f} /kg"),
              arg("price", static_cast<double>(y.price) * (imperial ? kPound_g / 1000 : 1)));
}

Rgb shown_color(const LibraryYarn& y, size_t color) {
  return y.colors.empty() ? Rgb{0.85f, 0.83f, 0.78f} : y.colors[std::min(color, y.colors.size() - 1)].rgb;
}

/// Pixels: fields and list fit the window.
float list_width(const PanelContext& c) {
  const float room = ImGui::GetMainViewport()->WorkSize.x - c.style.px(kFieldsWidth + kGap + kAround);
  return std::floor(std::clamp(room, c.style.px(kWithFibre / 2), c.style.px(kListWidth)));
}

std::vector<int> found_yarns(const YarnsPrompt& p) {
  std::vector<int> found;
  for (size_t i = 0; i < p.shelf->yarns().size(); ++i)
    if (matches(p.shelf->yarns()[i], p.typed)) found.push_back(static_cast<int>(i));
  return found;
}

void choose(YarnsPrompt& p, int yarn) {
  if (p.chosen != yarn) p.color = 0;
  p.chosen = yarn;
  p.revision = ~uint64_t{0};
}

/// The chosen yarn is another one after a change of the library: it is found again.
void choose(YarnsPrompt& p, const LibraryYarn& yarn) {
  const auto& all = p.shelf->yarns();
  const auto at = std::ranges::find(all, yarn);
  choose(p,
         at == all.end() ? std::min(p.chosen, static_cast<int>(all.size()) - 1) : static_cast<int>(at - all.begin()));
  p.follow = true;
}

void change(YarnsPrompt& p, YarnShelf::Change change) {
  p.shelf->change(std::move(change),
                  [problem = p.problem](const base::Result<void>& written) { *problem = problem_of(written); });
}

void draw_dots(PanelContext& c, const LibraryYarn& y, ImVec2 at) {
  const float dot = c.style.px(kDot), step = dot + c.style.px(2);
  const size_t shown = std::min(y.colors.size(), kMaxDots);
  for (size_t i = 0; i < shown; ++i) {
    const ImVec2 a{at.x + static_cast<float>(i) * step, at.y};
    draw_swatch(c, a, {a.x + dot, a.y + dot}, to_u32(y.colors[i].rgb));
  }
}

/// True if it was clicked twice.
bool draw_row(PanelContext& c, YarnsPrompt& p, int row, int yarn) {
  const LibraryYarn& y = p.shelf->yarns()[static_cast<size_t>(yarn)];
  const float height = c.style.px(kRow), strip_h = c.style.px(kStripHeight), strip_w = c.style.px(kStripWidth);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string id = "yarns:" + std::to_string(row + 1);
  if (list_row(c, id.c_str(), "##row", yarn == p.chosen, height)) choose(p, yarn);
  const bool twice = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (!ImGui::IsItemVisible()) return twice;
  const float middle = at.y + height / 2, line = ImGui::GetTextLineHeight();
  const size_t color = yarn == p.chosen ? static_cast<size_t>(p.color) : 0;
  YarnStrip& strip = p.strips->of[static_cast<size_t>(row) % p.strips->of.size()];
  const ImVec2 a{at.x + c.style.px(8), middle - strip_h / 2};
  ImDrawList* dl = ImGui::GetWindowDrawList();
  dl->AddImage(strip.of(y.yarn, shown_color(y, color), c.settings.lobe_light_deg, static_cast<int>(strip_w),
                        static_cast<int>(strip_h)),
               a, {a.x + strip_w, a.y + strip_h});
  const auto text = [&](float x, float top, ImU32 col, const std::string& words, float width) {
    dl->AddText({at.x + x, top}, col, fitted(words, width).c_str());
  };
  const float dots = list_width(c) - c.style.px(kDotsWidth), price = dots - c.style.px(kPriceWidth);
  const bool fibre_fits = list_width(c) >= c.style.px(kWithFibre);
  const float fibre = fibre_fits ? price - c.style.px(kFibreWidth) : price, count = fibre - c.style.px(kCountWidth);
  const float name = c.style.px(kName), gap = c.style.px(8);
  text(name, y.note.empty() ? middle - line / 2 : middle - line - c.style.px(1), c.style.color.text, y.yarn.name,
       count - name - gap);
  if (!y.note.empty()) {
    push_font(c.style.font.small);
    text(name, middle + c.style.px(2), c.style.color.muted, y.note, count - name - gap);
    ImGui::PopFont();
  }
  text(count, middle - line / 2, c.style.color.text, count_text(y), fibre - count - gap);
  if (fibre_fits)
    text(fibre, middle - line / 2, c.style.color.muted, tr(fibre_name(y.yarn.fibre)), price - fibre - gap);
  text(price, middle - line / 2, c.style.color.muted, price_text(y, c.settings.imperial), dots - price - gap);
  draw_dots(c, y, {at.x + dots, middle - c.style.px(kDot) / 2});
  return twice;
}

void move_choice(YarnsPrompt& p, const std::vector<int>& found) {
  if (keyboard_frame_shown() || found.empty()) return;
  const auto now = std::ranges::find(found, p.chosen);
  const auto step = [&](ImGuiKey key, int by) {
    if (!key_pressed(key)) return;
    const auto last = static_cast<int>(found.size()) - 1;
    const int at = now == found.end() ? (by > 0 ? 0 : last) : static_cast<int>(now - found.begin()) + by;
    choose(p, found[static_cast<size_t>(std::clamp(at, 0, last))]);
    p.follow = true;
  };
  step(ImGuiKey_UpArrow, -1);
  step(ImGuiKey_DownArrow, 1);
}

/// True if a row was clicked twice.
bool draw_list(PanelContext& c, YarnsPrompt& p, const std::vector<int>& found, float height) {
  begin_list("##yarns", {list_width(c), height});
  bool twice = false;
  const float step = c.style.px(kRow) + ImGui::GetStyle().ItemSpacing.y;
  for (size_t i = 0; i < found.size(); ++i) {
    ImGui::PushID(found[i]);
    if (found[i] == p.chosen && std::exchange(p.follow, false))
      ImGui::SetScrollFromPosY(ImGui::GetCursorScreenPos().y + step / 2 - ImGui::GetWindowPos().y, 0.5f);
    if (draw_row(c, p, static_cast<int>(i), found[i])) twice = true;
    ImGui::PopID();
  }
  if (found.empty()) {
    ImGui::PushTextWrapPos(list_width(c) - c.style.px(24));
    muted_text(c, p.shelf->yarns().empty()
                      ? tr("No yarns yet. Add the active yarn of the draft, describe a new one, or import a list.")
                      : tr("No yarn matches."));
    ImGui::PopTextWrapPos();
  }
  ImGui::EndChild();
  return twice;
}

/// True while the search field has the keyboard.
bool draw_head(PanelContext& c, YarnsPrompt& p) {
  const ImVec2 top = ImGui::GetCursorPos();
  heading(c, tr("Yarn library"));
  ImGui::SetCursorPos({top.x + list_width(c) - c.style.px(260), top.y - c.style.px(4)});
  ImGui::SetNextItemWidth(c.style.px(260));
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  // Up and down are for the rows, as in the gallery.
  const auto no_history = [](ImGuiInputTextCallbackData*) { return 0; };
  if (ImGui::InputTextWithHint("##typed", tr("Search by name, count, fibre, colour"), &p.typed,
                               ImGuiInputTextFlags_CallbackHistory, no_history)) {
    const std::vector<int> found = found_yarns(p);
    choose(p, found.empty() ? -1 : found.front());
  }
  c.map.add_item("yarns.typed");
  return ImGui::IsItemActive();
}

void text_field(PanelContext& c, const char* id, const char* label, std::string& text) {
  row_label(c, label, nullptr);
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::PushID(id);
  ImGui::InputText("##text", &text);
  ImGui::PopID();
  c.map.add_item(id);
}

void draw_count_field(PanelContext& c, YarnsPrompt& p) {
  text_field(c, "yarns.count", tr("Count"), p.count);
  if (ImGui::IsItemActivated()) p.count_unread = false;
  if (ImGui::IsItemDeactivatedAfterEdit()) {
    const std::optional<Yarn> spun = with_count(p.fields.yarn, p.count);
    p.count_unread = !spun;
    if (spun) p.fields.yarn = *spun, p.fields.count = p.count;
  }
  if (!p.count_unread) return;
  ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.error);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(tr("Not understood. Examples: Ne 8/2, Nm 30/2, 16 lea, 150 den, 30 tex"));
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void draw_fibre_field(PanelContext& c, LibraryYarn& y) {
  Yarn& yarn = y.yarn;
  row_label(c, tr("Fibre"), nullptr);
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (!begin_combo(c, "yarns.fibre", tr(fibre_name(yarn.fibre)))) return;
  for (const Yarn& ready : yarn_presets()) {
    if (ImGui::Selectable(tr(fibre_name(ready.fibre)), ready.fibre == yarn.fibre)) {
      yarn = with_fibre(yarn, ready.fibre);
      if (const auto spun = with_count(yarn, y.count); spun && !y.count.empty()) yarn = *spun;
    }
    c.map.add_item("yarns.fibre:" + ready.name);
  }
  end_combo();
}

void draw_price_fields(PanelContext& c, LibraryYarn& y) {
  constexpr const char* kMetric[] = {mark("by kg"), mark("cone, g"), mark("cone, m")};
  constexpr const char* kImperial[] = {mark("by lb"), mark("cone, oz"), mark("cone, yd")};
  const bool imperial = c.settings.imperial;
  row_label(c, tr("Sold by"), nullptr);
  int by = y.cone_m > 0 ? 2 : y.cone_g > 0 ? 1 : 0;
  if (segmented(c, "yarns.sold", imperial ? kImperial : kMetric, by))
    y.cone_g = by == 1 ? 250.0f : 0, y.cone_m = by == 2 ? 1000.0f : 0;
  if (by > 0) {
    float& size = by == 1 ? y.cone_g : y.cone_m;
    const double unit = !imperial ? 1 : by == 1 ? kOunce_g : kYard_m;
    auto shown = static_cast<float>(static_cast<double>(size) / unit);
    const char* format =
        by == 1 ? (imperial ? tr("%.1f oz") : tr("%.0f g")) : (imperial ? tr("%.0f yd") : tr("%.0f m"));
    if (slider(c,
               {"yarns.cone", tr("Cone"), 1, by == 1 && !imperial ? 1000.0f : 5000.0f, format,
                tr("Of one cone or skein"), true, 1, design::kMaxCone},
               shown))
      size = static_cast<float>(static_cast<double>(shown) * unit);
  }
  const double unit = by == 0 && imperial ? kPound_g / 1000 : 1;
  auto price = static_cast<float>(static_cast<double>(y.price) * unit);
  const char* format = price <= 0 ? tr("not known")
                       : by > 0   ? tr("%.2f each")
                       : imperial ? tr("%.2f /lb")
                                  : tr("%.2f /kg");
  if (slider(c,
             {"yarns.price", tr("Price"), 0, 100, format, tr("In your currency; 0 if not known"), false, 0,
              design::kMaxPrice},
             price))
    y.price = static_cast<float>(static_cast<double>(price) / unit);
}

void draw_color_swatches(PanelContext& c, YarnsPrompt& p) {
  std::vector<YarnColor>& colors = p.fields.colors;
  const float side = c.style.px(24), gap = c.style.px(6);
  const auto columns = std::max(1, static_cast<int>((ImGui::GetContentRegionAvail().x + gap - 4) / (side + gap)));
  const int count = static_cast<int>(colors.size()), rows = std::max(1, (count + columns - 1) / columns);
  ImGui::BeginChild("colours", {0, std::min(3.0f, static_cast<float>(rows)) * (side + gap) + gap});
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  for (int i = 0; i < count; ++i) {
    const ImVec2 a{origin.x + 3 + static_cast<float>(i % columns) * (side + gap),
                   origin.y + 3 + static_cast<float>(i / columns) * (side + gap)};
    ImGui::SetCursorScreenPos(a);
    ImGui::PushID(i);
    if (hit_area("colour", {side, side})) p.color = i;
    ImGui::PopID();
    c.map.add_item("yarns.color:" + std::to_string(i + 1));
    const YarnColor& color = colors[static_cast<size_t>(i)];
    if (!color.name.empty()) ui::tooltip(c, color.name.c_str());
    draw_swatch(c, a, {a.x + side, a.y + side}, to_u32(color.rgb), i == p.color);
  }
  ImGui::EndChild();
}

void draw_color_fields(PanelContext& c, YarnsPrompt& p) {
  std::vector<YarnColor>& colors = p.fields.colors;
  row_label(c, tr("Colours"), nullptr);
  const auto at = static_cast<size_t>(p.color);
  if (icon_button(c, "yarns.color.remove", icon::kMinus, "-", tr("Delete this colour"), at < colors.size())) {
    colors.erase(colors.begin() + p.color);
    p.color = std::max(0, std::min(p.color, static_cast<int>(colors.size()) - 1));
  }
  ImGui::SameLine();
  if (icon_button(c, "yarns.color.add", icon::kPlus, "+", tr("Add the draft's active colour"),
                  colors.size() < design::kMaxYarnColors)) {
    const auto& palette = c.design.draft.palette;
    colors.push_back({palette[std::min(static_cast<size_t>(p.active_color), palette.size() - 1)], {}});
    p.color = static_cast<int>(colors.size()) - 1;
  }
  draw_color_swatches(c, p);
  if (static_cast<size_t>(p.color) >= colors.size()) return;
  YarnColor& color = colors[static_cast<size_t>(p.color)];
  float rgb[3] = {color.rgb.r, color.rgb.g, color.rgb.b};
  ImGui::SetNextItemWidth(c.style.px(120));
  push_font(c.style.font.mono);
  if (ImGui::ColorEdit3("##rgb", rgb, ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueWheel))
    color.rgb = {rgb[0], rgb[1], rgb[2]};
  ImGui::PopFont();
  c.map.add_item("yarns.rgb");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::InputTextWithHint("##colour name", tr("Name or number"), &color.name);
  c.map.add_item("yarns.color_name");
}

/// Changes the library as the fields say.
void take_fields(YarnsPrompt& p, const LibraryYarn& stored) {
  const LibraryYarn now = as_written(p.fields);
  const int color = p.color;
  if (!(now == stored)) change(p, replace_yarn(stored, now));
  choose(p, now);
  p.color = color;
}

/// What is known of the chosen yarn. A changed field goes to the library when it is left.
void draw_fields(PanelContext& c, YarnsPrompt& p, float height) {
  ImGui::BeginChild("fields", {c.style.px(kFieldsWidth), height});
  const auto& all = p.shelf->yarns();
  if (p.chosen >= 0 && static_cast<size_t>(p.chosen) < all.size()) {
    const LibraryYarn stored = all[static_cast<size_t>(p.chosen)];
    if (p.revision != p.shelf->revision() && !ImGui::IsAnyItemActive()) {
      p.fields = stored, p.count = count_text(stored);
      p.revision = p.shelf->revision();
    }
    text_field(c, "yarns.name", tr("Name"), p.fields.yarn.name);
    draw_count_field(c, p);
    draw_fibre_field(c, p.fields);
    text_field(c, "yarns.note", tr("Note"), p.fields.note);
    draw_price_fields(c, p.fields);
    ImGui::Dummy({0, c.style.px(4)});
    draw_color_fields(c, p);
    if (p.revision == p.shelf->revision() && !(p.fields == stored) && !ImGui::IsAnyItemActive()) take_fields(p, stored);
  } else {
    ImGui::PushTextWrapPos(0);
    muted_text(c, tr("Select a yarn to see and change its count, price and colours."));
    ImGui::PopTextWrapPos();
  }
  ImGui::EndChild();
}

LibraryYarn new_yarn() {
  LibraryYarn out;
  out.yarn = yarn_presets()[0];
  out.yarn.name = tr("New yarn");
  out.count = written_count(out.yarn);
  out.colors.push_back({{0.92f, 0.89f, 0.82f}, {}});
  return as_written(out);
}

/// Buttons below the list, for its yarns.
void draw_list_buttons(PanelContext& c, YarnsPrompt& p) {
  if (text_button(c, "yarns.keep", tr("Add the draft's yarn"),
                  tr("Adds the draft's active yarn, in the colours of its threads"))) {
    const LibraryYarn kept = library_yarn_of(c.design, p.active_yarn, p.active_color);
    change(p, keep_yarn(kept));
    const auto& all = p.shelf->yarns();
    const auto at = std::ranges::find_if(all, [&](const LibraryYarn& y) { return y.yarn == kept.yarn; });
    if (at != all.end()) choose(p, LibraryYarn(*at));
  }
  ImGui::SameLine();
  if (text_button(c, "yarns.new", tr("New yarn"), tr("Adds an empty entry to fill in"))) {
    change(p, keep_yarn(new_yarn()));
    choose(p, new_yarn());
  }
  ImGui::SameLine();
  if (p.chosen >= 0 && static_cast<size_t>(p.chosen) < p.shelf->yarns().size() &&
      text_button(c, "yarns.delete", tr("Delete"), tr("Removes the yarn from the library; drafts keep it"))) {
    p.removed = p.shelf->yarns()[static_cast<size_t>(p.chosen)];
    change(p, remove_yarn(*p.removed));
    choose(p, std::min(p.chosen, static_cast<int>(p.shelf->yarns().size()) - 1));
  }
  if (!p.removed) return;
  ImGui::SameLine();
  if (text_button(c, "yarns.put_back",
                  fill(tr("Restore {yarn}"), arg("yarn", fitted(p.removed->yarn.name, c.style.px(120)))).c_str(),
                  nullptr)) {
    const LibraryYarn back = *std::exchange(p.removed, std::nullopt);
    change(p, keep_yarn(back));
    choose(p, back);
  }
}

/// The yarn and its colour are in the draft, and active. The edit first: its undo brings back what was active before
/// it.
void use(PanelContext& c, const LibraryYarn& yarn, int color) {
  const auto index = static_cast<size_t>(std::max(color, 0));
  c.wanted.add(Edit{fill(tr("Add \"{name}\" from the library"), arg("name", yarn.yarn.name)),
                    [yarn, index](Design now) { return with_yarn_from(std::move(now), yarn, index).design; }});
  const UsedYarn used = with_yarn_from(c.design, yarn, index);
  c.wanted.change_view([made = used.yarn, painted = used.color](DocumentView& v) {
    v.drawing.yarn = made;
    if (painted >= 0) v.drawing.color = painted;
  });
}

}  // namespace

DialogResult draw_prompt(PanelContext& c, YarnsPrompt& p) {
  const float room = ImGui::GetMainViewport()->WorkSize.y - c.style.px(220);
  const float height = std::clamp(room, c.style.px(160), c.style.px(430));
  const bool active = draw_head(c, p), searching = std::exchange(p.searching, active) || active;
  p.chosen = std::min(p.chosen, static_cast<int>(p.shelf->yarns().size()) - 1);
  const std::vector<int> found = found_yarns(p);
  move_choice(p, found);
  const bool twice = draw_list(c, p, found, height);
  ImGui::SameLine(0, c.style.px(kGap));
  draw_fields(c, p, height);
  draw_list_buttons(c, p);
  if (!p.problem->empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.error);
    ImGui::TextUnformatted(fitted(*p.problem, list_width(c) + c.style.px(kGap + kFieldsWidth)).c_str());
    ImGui::PopStyleColor();
  }
  const bool typing = ImGui::GetIO().WantTextInput && !searching;
  const int pressed =
      draw_buttons(c, {mark("Use in the draft"), mark("Close"), mark("Import\xE2\x80\xA6"), mark("Export\xE2\x80\xA6")},
                   p.chosen >= 0 && !typing, p.chosen >= 0);
  const bool uses = (pressed == YarnsPrompt::kUse || twice) && p.chosen >= 0;
  if (uses) use(c, p.shelf->yarns()[static_cast<size_t>(p.chosen)], p.color);
  if (uses) return {DialogOutcome::kDone, YarnsPrompt::kUse, {}};
  if (pressed == YarnsPrompt::kUse) return {};
  return dialog_result(pressed, YarnsPrompt::kClose);
}

}  // namespace weftlight::views
