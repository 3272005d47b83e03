#include "views/dialogs/print_dialog.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "ui/icons.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using analysis::Units, analysis::kInch_mm;
using base::arg, base::fill, base::mark, base::tr;
using print::NamedPart, print::Paper, print::PrintFormat, print::PrintOptions, print::SheetPicture, print::kPapers,
    print::kParts, print::picture_of_sheet;
using ui::begin_combo, ui::begin_list, ui::begin_padded_child, ui::end_combo, ui::fitted, ui::icon_button,
    ui::row_label, ui::segmented, ui::slider;

SheetPreview::SheetPreview(std::shared_ptr<const Design> design, std::function<void()> wake)
    : design_(std::move(design)), runner_(std::move(wake)) {}

void SheetPreview::ask(const PrintOptions& options, int sheet, double pixels_per_mm) {
  Request now{options, sheet, pixels_per_mm};
  if (now == request_) return;
  request_ = now;
  busy_ = true;
  runner_.start(base::task_with_result(
      [design = design_, now](const base::RunningTask&) {
        return picture_of_sheet(*design, now.options, now.sheet, now.pixels_per_mm);
      },
      [this](base::Result<SheetPicture> made) { show(std::move(made)); }));
}

void SheetPreview::show(base::Result<SheetPicture> made) {
  busy_ = false;
  problem_ = made ? "" : fill(tr("No preview: {problem}"), arg("problem", message(made.error())));
  last_ = std::move(made).value_or(SheetPicture{});
  if (!last_.pixels.empty()) texture_.set(last_.width, last_.height, std::exchange(last_.pixels, {}));
}

PrintOptions chosen_options(const PrintPrompt& p) {
  PrintOptions o = p.options;
  o.paper = kPapers[p.paper].paper;
  if (p.wide) std::swap(o.paper.width_mm, o.paper.height_mm);
  o.cell_mm = p.own_scale ? static_cast<double>(p.cell_mm) : 0;
  return o;
}

const char* ending_of(PrintFormat format) {
  constexpr const char* kEndings[] = {".pdf", ".svg", ".png"};
  return kEndings[static_cast<int>(format)];
}

PrintPrompt::Button PrintPrompt::button(int pressed) const {
  return static_cast<Button>(std::clamp(pressed + (has_printer ? 0 : 1), 0, 2));
}

namespace {

constexpr float kPreviewWidth = 380, kPreviewHeight = 470, kColumn = 330;  // pixels at 96 dpi

/// Size of the drawn sheet in window pixels.
ImVec2 sheet_size(const PanelContext& c, const Paper& paper) {
  const float w = static_cast<float>(paper.width_mm), h = static_cast<float>(paper.height_mm);
  const float scale =
      std::min((c.style.px(kPreviewWidth) - c.style.px(40)) / w, (c.style.px(kPreviewHeight) - c.style.px(40)) / h);
  return {std::floor(w * scale), std::floor(h * scale)};
}

void draw_sheet(PanelContext& c, const PrintPrompt& p, const PrintOptions& o) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, c.style.color.window);
  begin_padded_child("preview", {c.style.px(kPreviewWidth), c.style.px(kPreviewHeight)});
  const ImVec2 at = ImGui::GetWindowPos(), room = ImGui::GetWindowSize(), size = sheet_size(c, o.paper);
  const ImVec2 a{std::floor(at.x + (room.x - size.x) / 2), std::floor(at.y + (room.y - size.y) / 2)};
  const ImVec2 b{a.x + size.x, a.y + size.y};
  ImDrawList* dl = ImGui::GetWindowDrawList();
  const float drop = c.style.px(3);
  dl->AddRectFilled({a.x + drop, a.y + drop}, {b.x + drop, b.y + drop}, IM_COL32(0, 0, 0, 50), c.style.px(2));
  dl->AddRectFilled(a, b, IM_COL32_WHITE);
  const SheetPicture& last = p.preview->last();
  const std::string& problem = p.preview->problem();
  if (problem.empty() && !p.preview->texture().empty()) dl->AddImage(p.preview->texture().id(), a, b);
  dl->AddRect(a, b, c.style.color.line_strong);
  ImGui::SetCursorScreenPos(a);
  ImGui::Dummy(size);
  c.map.add_item("print.sheet");
  if (problem.empty() && last.sheets > 0 && last.sheet == std::min(p.sheet, last.sheets - 1) && !p.preview->busy())
    c.map.add_item("print.ready");
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

/// Buttons for the previous and the next sheet.
void draw_sheet_buttons(PanelContext& c, PrintPrompt& p) {
  const SheetPicture& last = p.preview->last();
  const std::string& problem = p.preview->problem();
  const int sheets = std::max(last.sheets, 1);
  p.sheet = std::clamp(p.sheet, 0, sheets - 1);
  if (icon_button(c, "print.back", icon::kLeft, "<", tr("Previous sheet"), p.sheet > 0)) --p.sheet;
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  if (!problem.empty()) ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.warn);
  const std::string text =
      !problem.empty()   ? fitted(problem, c.style.px(280))
      : last.sheets == 0 ? std::string("\xE2\x80\xA6")
                         : fill(tr("Sheet {sheet} of {sheets}"), arg("sheet", p.sheet + 1), arg("sheets", sheets));
  ImGui::TextUnformatted(text.c_str());
  c.map.add_item("print.sheets:" + std::to_string(last.sheets));
  if (!problem.empty()) ImGui::PopStyleColor();
  ImGui::SameLine();
  if (icon_button(c, "print.next", icon::kRight, ">", tr("Next sheet"), p.sheet + 1 < sheets)) ++p.sheet;
}

void draw_paper(PanelContext& c, PrintPrompt& p, float width) {
  row_label(c, tr("Paper"), nullptr);
  ImGui::SetNextItemWidth(width);
  if (begin_combo(c, "print.paper", tr(kPapers[p.paper].name))) {
    for (int i = 0; i < static_cast<int>(std::size(kPapers)); ++i) {
      if (ImGui::Selectable(tr(kPapers[i].name), i == p.paper)) p.paper = i;
      c.map.add_item(std::string("print.paper:") + kPapers[i].name);
    }
    end_combo();
  }
  constexpr const char* kWays[] = {mark("Portrait"), mark("Landscape")};
  row_label(c, "", nullptr);
  int way = p.wide ? 1 : 0;
  segmented(c, "print.way", kWays, way, width);
  p.wide = way == 1;
}

void draw_scale(PanelContext& c, PrintPrompt& p, float width) {
  constexpr const char* kScales[] = {mark("Automatic"), mark("Custom")};
  row_label(c, tr("Scale"), tr("Automatic: the draft on one sheet, unless its cells would be too small to read"));
  int scale = p.own_scale ? 1 : 0;
  segmented(c, "print.scale", kScales, scale, width);
  p.own_scale = scale == 1;
  const bool inches = p.options.units == Units::kImperial;
  if (p.own_scale)
    scaled_slider(c,
                  {"print.cell", tr("Cell size"), 0.5f, 20, inches ? tr("%.2f in") : "%.1f mm",
                   tr("Size of a cell on paper; larger cells take more sheets"), true},
                  inches ? static_cast<float>(1 / kInch_mm) : 1, p.cell_mm);
  row_label(c, tr("Heavy lines"), tr("A heavy grid line every so many threads, counted from the first"));
  constexpr int kEvery[] = {0, 4, 5, 6, 8, 10};
  constexpr const char* kWords[] = {mark("Off"), "4", "5", "6", "8", "10"};
  int every = static_cast<int>(std::find(std::begin(kEvery), std::end(kEvery), p.options.heavy_lines) - kEvery) % 6;
  if (segmented(c, "print.heavy", kWords, every, width)) p.options.heavy_lines = kEvery[every];
}

void draw_parts(PanelContext& c, PrintPrompt& p) {
  for (const NamedPart& part : kParts) {
    row_label(c, &part == &kParts[0] ? tr("Include") : "", nullptr);
    ImGui::Checkbox(tr(part.label), &(p.options.parts.*part.on));
    c.map.add_item(std::string("print.") + part.name);
  }
}

/// What of the draft, and which of its sheets.
void draw_extent(PanelContext& c, PrintPrompt& p, float width) {
  constexpr const char* kExtents[] = {mark("Whole draft"), mark("One repeat")};
  row_label(c, tr("Extent"),
            tr("Grids and lists of one repeat; heddles, yarn and swatch always cover the whole draft"));
  int extent = p.options.one_repeat ? 1 : 0;
  segmented(c, "print.extent", kExtents, extent, width);
  p.options.one_repeat = extent == 1;
  const int sheets = std::max(1, p.preview->last().sheets);
  row_label(c, tr("Sheets"), tr("The first and the last sheet to print"));
  const auto field = [&](const char* id, int& value, int shown) {
    ImGui::SetNextItemWidth(c.style.px(64));
    ImGui::PushID(id);
    if (ImGui::InputInt("##n", &shown, 0)) value = std::clamp(shown, 1, print::kMaxSheets);
    ImGui::PopID();
    c.map.add_item(id);
  };
  field("print.first", p.options.first_sheet, std::min(p.options.first_sheet, sheets));
  ImGui::SameLine();
  ImGui::TextUnformatted("\xE2\x80\x93");
  ImGui::SameLine();
  const int last = p.options.last_sheet;
  field("print.last", p.options.last_sheet, last > 0 ? std::min(last, sheets) : sheets);
  if (p.options.last_sheet == sheets) p.options.last_sheet = 0;  // follows the number of sheets
}

void draw_format(PanelContext& c, PrintPrompt& p, float width) {
  constexpr const char* kFormats[] = {"PDF", "SVG", "PNG"};
  row_label(c, tr("Format"), tr("A PDF holds all sheets; SVG and PNG are one file per sheet"));
  int format = static_cast<int>(p.format);
  segmented(c, "print.format", kFormats, format, width);
  p.format = static_cast<PrintFormat>(format);
  if (p.format != PrintFormat::kPng) return;
  auto dpi = static_cast<float>(p.options.png_dpi);
  if (slider(c, {"print.dpi", tr("Resolution"), 50, 600, tr("%.0f dpi"), tr("Dots per inch of paper")}, dpi))
    p.options.png_dpi = static_cast<double>(dpi);
}

}  // namespace

DialogResult draw_prompt(PanelContext& c, PrintPrompt& p) {
  heading(c, tr("Print draft"));
  const PrintOptions options = chosen_options(p);
  ImGui::BeginGroup();
  draw_sheet(c, p, options);
  draw_sheet_buttons(c, p);
  ImGui::EndGroup();
  ImGui::SameLine(0, c.style.px(20));
  ImGui::BeginGroup();
  begin_list("choices", {c.style.px(kColumn), c.style.px(kPreviewHeight)});
  const float width = ImGui::GetContentRegionAvail().x - c.style.px(112);
  draw_paper(c, p, width);
  draw_scale(c, p, width);
  ImGui::Dummy({0, c.style.px(4)});
  draw_parts(c, p);
  ImGui::Dummy({0, c.style.px(4)});
  draw_extent(c, p, width);
  ImGui::Dummy({0, c.style.px(4)});
  draw_format(c, p, width);
  ImGui::EndChild();
  std::vector<std::string> buttons{mark("Save\xE2\x80\xA6"), mark("Cancel")};
  if (p.has_printer) buttons.insert(buttons.begin(), mark("Print"));
  const int pressed = draw_buttons(c, buttons, true);
  DialogResult result = dialog_result(pressed, static_cast<int>(buttons.size()) - 1);
  ImGui::EndGroup();
  const float ratio = ImGui::GetIO().DisplayFramebufferScale.x;
  p.preview->ask(chosen_options(p), p.sheet,
                 static_cast<double>(sheet_size(c, chosen_options(p).paper).x * std::max(ratio, 1.0f)) /
                     chosen_options(p).paper.width_mm);
  return result;
}

}  // namespace weftlight::views
