#include "views/dialogs/export_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/decimals.h"
#include "base/text.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using analysis::kInch_mm, analysis::width_text;
using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using files::kMipFormats;
using session::PictureRect, session::PreviewSizes, session::ShownChannel, session::ShownImage, session::bytes_on_disk,
    session::figures_of, session::jobs_of, session::shown_bytes, session::toggle;
using texture_set::Alpha, texture_set::ExportTarget, texture_set::alpha_name, texture_set::kTargets,
    texture_set::key_of;
using ui::begin_combo, ui::begin_list, ui::end_combo, ui::fitted, ui::hit_area, ui::muted_text, ui::push_font,
    ui::row_label, ui::segmented, ui::slider, ui::text_button, ui::tooltip;

bool ExportStage::poll() {
  std::optional<base::Result<ExportPreview>> finished = preview.take();
  if (!finished) return false;
  problem = *finished ? "" : fill(tr("No preview: {problem}"), arg("problem", message(finished->error())));
  shown = std::move(*finished).value_or(ExportPreview{});
  if (!shown.pixels.empty()) texture.set(shown.width, shown.height, std::exchange(shown.pixels, {}));
  return true;
}

namespace {

// Pixels at 96 dpi.
constexpr float kColumn = 360, kLabels = 104, kStageWidth = 520, kHeight = 564, kFoot = 44, kAround = 150;
constexpr int kThumbnail = 84, kSwatchHeight = 150;

/// Sizes of the parts of the dialog, limited by the window.
struct DialogSizes {
  float column = 0, stage = 0, height = 0;
};
DialogSizes sizes_in(PanelContext& c) {
  const ImVec2 view = ImGui::GetMainViewport()->WorkSize;
  DialogSizes r;
  r.column = c.style.px(kColumn);
  r.stage = std::min(c.style.px(kStageWidth), view.x - r.column - c.style.px(80));
  r.height = std::min(c.style.px(kHeight), view.y - c.style.px(kAround));
  return r;
}

bool has(const ExportPlan& plan, const ExportTarget* target) {
  return std::find(plan.targets.begin(), plan.targets.end(), target) != plan.targets.end();
}

std::string figure(float v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", static_cast<double>(v));
  return base::with_decimal_point(text);
}

void draw_targets(PanelContext& c, ExportPrompt& p) {
  row_label(c, tr("Targets"),
            tr("Programs to export for. File names, channel packing and normals follow each one's rules"));
  // Column by column: the longer titles come first.
  ImGui::BeginGroup();
  ImGui::BeginGroup();
  for (size_t at = 0; at < kTargets.size(); ++at) {
    const ExportTarget* target = kTargets[at];
    if (at == (kTargets.size() + 1) / 2) {
      ImGui::EndGroup();
      ImGui::SameLine(0, c.style.px(6));
      ImGui::BeginGroup();
    }
    bool on = has(*p.plan, target);
    if (ImGui::Checkbox(tr(target->title), &on)) toggle(*p.plan, target);
    c.map.add_item(std::string("export.for:") + target->id);
  }
  ImGui::EndGroup();
  ImGui::EndGroup();
  p.target = std::min(p.target, p.plan->targets.size() - 1);
}

/// In whole centimetres or inches; below 0 automatic.
void draw_tile(PanelContext& c, ExportPlan& plan) {
  const bool inches = c.settings.imperial;
  const float unit_cm = inches ? static_cast<float>(kInch_mm / 10) : 1;
  const std::string tip = fill(
      tr("Minimum width of the tile; 0 is one repeat. More repeats show more variation of the yarns. Automatic: up "
         "to {width} for yarns with slubs, melange or unevenness, else one repeat"),
      arg("width", width_text(50, units_of(c.settings))));
  float shown = plan.tile_cm > 0 ? plan.tile_cm / unit_cm : plan.tile_cm;
  const char* format = shown > 0   ? (inches ? tr("%.0f in") : tr("%.0f cm"))
                       : shown < 0 ? tr("Automatic")
                                   : tr("1 repeat");
  if (!slider(c, {"export.tile", tr("Tile"), -1, inches ? 20.0f : 50.0f, format, tip.c_str()}, shown)) return;
  shown = std::round(shown);
  plan.tile_cm = shown > 0 ? shown * unit_cm : shown;
}

void draw_size(PanelContext& c, ExportPlan& plan, float width) {
  constexpr const char* kWays[] = {mark("Pixels"), mark("Texel density")};
  int way = plan.by_density ? 1 : 0;
  row_label(c, tr("Resolution"), tr("Pixels along the longer side of the tile, or texels per length of cloth"));
  segmented(c, "export.by", kWays, way, width);
  plan.by_density = way == 1;
  if (plan.by_density) {
    const bool inches = c.settings.imperial;
    scaled_slider(c,
                  {"export.density", "", 2, 200, inches ? tr("%.0f /in") : tr("%.0f /mm"),
                   inches ? tr("At least this many texels per inch; the size is the next power of two")
                          : tr("At least this many texels per millimetre; the size is the next power of two"),
                   true},
                  inches ? static_cast<float>(kInch_mm) : 1, plan.texels_per_mm);
  } else {
    constexpr const char* kSizes[] = {"512", "1024", "2048", "4096", "8192"};
    int step = 0;
    while (step < 4 && (512 << step) < plan.size) ++step;
    row_label(c, "", nullptr);
    segmented(c, "export.size", kSizes, step, width);
    plan.size = 512 << step;
  }
  draw_tile(c, plan);
}

void draw_alpha(PanelContext& c, ExportPrompt& p, float width) {
  constexpr const char* kNames[] = {mark("Automatic"), mark("Opaque"), mark("Mask"), mark("Hashed"), mark("Blend")};
  ExportPlan& plan = *p.plan;
  row_label(c, tr("Alpha mode"),
            tr("How gaps between threads are shown. Automatic: opaque if the cloth has only pinholes"));
  ImGui::SetNextItemWidth(width);
  if (begin_combo(c, "export.alpha", tr(kNames[static_cast<size_t>(plan.alpha)]))) {
    for (size_t i = 0; i < std::size(kNames); ++i) {
      if (ImGui::Selectable(tr(kNames[i]), i == static_cast<size_t>(plan.alpha))) plan.alpha = static_cast<Alpha>(i);
      c.map.add_item(std::string("export.alpha:") + alpha_name(static_cast<Alpha>(i)));
    }
    end_combo();
  }
}

void draw_mips(PanelContext& c, ExportPlan& plan, float width) {
  constexpr const char* kNames[] = {mark("None"), ".dds", ".ktx2", ".dds BC", ".ktx2 BC"};
  row_label(c, tr("Mipmaps"),
            tr("None: the target program makes its own. Otherwise each image is also written with mipmaps that move "
               "lost detail of the normals into roughness and keep the coverage of gaps. BC: colours and masks are "
               "compressed as graphics cards read them"));
  int way = plan.mips ? 1 + static_cast<int>(*plan.mips) : 0;
  segmented(c, "export.mips", kNames, way, width);
  plan.mips = way > 0 ? std::optional(kMipFormats[static_cast<size_t>(way - 1)].format) : std::nullopt;
}

/// True if the button that chooses the folder was pressed.
bool draw_folder(PanelContext& c, ExportPlan& plan, float width) {
  row_label(c, tr("Folder"),
            tr("Each draft gets its own subfolder, with one subfolder per target if there are several"));
  const char* browse = tr("Browse\xE2\x80\xA6");
  const float button = ImGui::CalcTextSize(browse).x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(width - button - ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::InputText("##folder", &plan.folder);
  c.map.add_item("export.folder");
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  return text_button(c, "export.choose", browse, nullptr);
}

void update_figures(ExportPrompt& p) {
  std::vector<ExportJob> jobs = jobs_of(*p.plan, *p.design, p.draft_path, p.version);
  std::string key;
  for (const ExportJob& job : jobs) key.append(job.folder).append(" ").append(key_of(job.options)).append("\n");
  if (key == p.key) return;
  p.key = std::move(key), p.jobs = std::move(jobs);
  p.figures = figures_of(*p.design, p.jobs);
  p.conflicts.clear();
  p.wants_export = false;
  p.places->look(p.jobs);
}

void draw_facts(PanelContext& c, const ExportPrompt& p) {
  const ExportFigures& f = p.figures;
  const auto line = [&c](const char* label, const std::string& text) {
    row_label(c, label, nullptr);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
  };
  if (f.set.ends > 0) {
    const bool inches = c.settings.imperial;
    const auto length = [inches](float mm) { return figure(inches ? mm / static_cast<float>(kInch_mm) : mm); };
    line(tr("Tile size"), fill(inches ? tr("{width} \xC3\x97 {height} in, {ends} ends \xC3\x97 {picks} picks")
                                      : tr("{width} \xC3\x97 {height} mm, {ends} ends \xC3\x97 {picks} picks"),
                               arg("width", length(f.set.width_mm)), arg("height", length(f.set.depth_mm)),
                               arg("ends", f.set.ends), arg("picks", f.set.picks)));
    line(tr("Images"), fill(tr("{count} of {width} \xC3\x97 {height}"), arg("count", f.images),
                            arg("width", f.set.size.width), arg("height", f.set.size.height)));
    const std::string texels = figure(f.texels_a_thread);
    line(tr("Per thread"), fill(tr_n("{count} texel", "{count} texels", texels), arg("count", texels)));
    c.map.add_item("export.images:" + std::to_string(f.images));
    const int64_t disk = bytes_on_disk(p.stage->shown, f.set.size);
    const char* text = disk <= 0           ? tr("{gpu} on the GPU")
                       : p.jobs.size() > 1 ? tr("{disk} per set on disk, {gpu} on the GPU")
                                           : tr("{disk} on disk, {gpu} on the GPU");
    line(tr("Storage"), fill(text, arg("disk", shown_bytes(disk)), arg("gpu", shown_bytes(f.texel_bytes))));
  }
  for (const std::string& why : f.why) {
    ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.warn);
    ImGui::TextWrapped("%s", why.c_str());
    ImGui::PopStyleColor();
  }
}

std::string written_text(const std::vector<std::string>& folders) {
  const auto sets = static_cast<int>(folders.size());
  if (sets == 1) return fill(tr("Exported to {folder}"), arg("folder", folders.front()));
  return fill(tr_n("Exported {count} set to {folder}", "Exported {count} sets to {folder}", sets), arg("count", sets),
              arg("folder", std::filesystem::path(folders.front()).parent_path().string()));
}

void draw_progress(PanelContext& c, const ExportPrompt& p, const Exporter::State& state) {
  const float width = ImGui::GetContentRegionAvail().x;
  const auto words = [&](const std::string& text, ImU32 color) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
  };
  if (state.busy) {
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, c.style.color.accent);
    ImGui::ProgressBar(state.share, {std::min(width, c.style.px(kColumn)), c.style.px(8)}, "");
    ImGui::PopStyleColor();
    c.map.add_item("export.progress");
    words(state.sets > 1
              ? fill(tr("Writing set {set} of {sets}\xE2\x80\xA6"), arg("set", state.set + 1), arg("sets", state.sets))
              : std::string(tr("Writing the images\xE2\x80\xA6")),
          c.style.color.muted);
  } else if (!p.conflicts.empty()) {
    for (const std::string& conflict : p.conflicts) words(conflict + ".", c.style.color.warn);
    words(tr("Files with the same names will be replaced; other files are kept."), c.style.color.text);
    c.map.add_item("export.asked");
  } else if (!state.problems.empty()) {
    for (const std::string& problem : state.problems) words(problem, c.style.color.error);
  } else if (state.stopped) {
    words(tr("Stopped. The earlier files are unchanged."), c.style.color.muted);
  } else if (!state.written.empty()) {
    words(written_text(state.written), c.style.color.text);
    c.map.add_item("export.written");
  } else if (const ExportPlaces::Found* there = p.places->found(); there == nullptr) {
    if (p.wants_export) words(tr("Checking the folder\xE2\x80\xA6"), c.style.color.muted);
  } else if (there->replaced > 0) {
    words(fill(tr_n("Replaces {count} file of the last export; other files are kept.",
                    "Replaces {count} files of the last export; other files are kept.", there->replaced),
               arg("count", there->replaced)),
          c.style.color.muted);
  }
}

/// A part of the preview texture, with a thin border.
void draw_part(PanelContext& c, const ExportStage& stage, const PictureRect& at, ImVec2 from, ImVec2 size) {
  const auto u = [&](int x) { return static_cast<float>(x) / static_cast<float>(stage.shown.width); };
  const auto v = [&](int y) { return static_cast<float>(y) / static_cast<float>(stage.shown.height); };
  const ImVec2 to{from.x + size.x, from.y + size.y};
  ImDrawList* dl = ImGui::GetWindowDrawList();
  dl->AddImageRounded(stage.texture.id(), from, to, {u(at.x), v(at.y)}, {u(at.x + at.width), v(at.y + at.height)},
                      IM_COL32_WHITE, c.style.px(3));
  dl->AddRect(from, to, c.style.color.line_strong, c.style.px(3));
}

/// One image of the set: all channels together, then each channel with its meaning.
void draw_image(PanelContext& c, const ExportStage& stage, const ShownImage& image, float ratio) {
  push_font(c.style.font.small);
  ImGui::TextUnformatted(image.file.c_str());
  ImGui::SameLine();
  muted_text(c, tr(image.about.c_str()));
  const float gap = c.style.px(8), line = ImGui::GetTextLineHeight();
  ImVec2 at = ImGui::GetCursorScreenPos();
  const auto part = [&](const PictureRect& r, const std::string& words) {
    const ImVec2 size{static_cast<float>(r.width) / ratio, static_cast<float>(r.height) / ratio};
    draw_part(c, stage, r, at, size);
    ImGui::SetCursorScreenPos(at);
    hit_area((image.file + words).c_str(), size);
    tooltip(c, words.c_str());
    const float room = c.style.px(kThumbnail);
    ImGui::GetWindowDrawList()->AddText({at.x, at.y + size.y + c.style.px(2)}, c.style.color.muted,
                                        fitted(words, room + gap - c.style.px(4)).c_str());
    at.x += room + gap;
  };
  const ImVec2 start = at;
  if (image.channels.size() > 1) part(image.at, tr("combined"));
  for (const ShownChannel& channel : image.channels) part(channel.at, tr(channel.words.c_str()));
  ImGui::SetCursorScreenPos(start);
  ImGui::Dummy({at.x - start.x, static_cast<float>(image.at.height) / ratio + line + c.style.px(8)});
  c.map.add_item("export.map:" + image.file);
  ImGui::PopFont();
}

void draw_stage(PanelContext& c, ExportPrompt& p, const DialogSizes& room) {
  const float wide = room.stage - ImGui::GetStyle().ScrollbarSize - c.style.px(8);
  if (p.plan->targets.size() > 1) {
    ImGui::SetNextItemWidth(c.style.px(190));
    if (begin_combo(c, "export.shown", tr(p.plan->targets[p.target]->title))) {
      for (size_t i = 0; i < p.plan->targets.size(); ++i) {
        if (ImGui::Selectable(tr(p.plan->targets[i]->title), i == p.target)) p.target = i;
        c.map.add_item(std::string("export.shown:") + p.plan->targets[i]->id);
      }
      end_combo();
    }
    ImGui::SameLine();
  }
  constexpr const char* kFaces[] = {mark("Front"), mark("Back")};
  int face = p.face == Face::kFront ? 0 : 1;
  segmented(c, "export.face", kFaces, face, c.style.px(150));
  p.face = face == 0 ? Face::kFront : Face::kBack;
  const ExportStage& stage = *p.stage;
  const float ratio = std::max(1.0f, ImGui::GetIO().DisplayFramebufferScale.x);
  ImGui::BeginChild("images", {room.stage, 0});
  const ImVec2 from = ImGui::GetCursorScreenPos(), size{wide, c.style.px(kSwatchHeight)};
  if (!stage.texture.empty() && !stage.shown.images.empty()) {
    draw_part(c, stage, stage.shown.swatch, from, size);
    ImGui::Dummy({size.x, size.y + c.style.px(6)});
    for (const ShownImage& image : stage.shown.images) draw_image(c, stage, image, ratio);
    if (!p.stage->preview.busy()) c.map.add_item("export.ready");
  } else {
    ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + size.x, from.y + size.y}, c.style.color.window,
                                              c.style.px(3));
    ImGui::Dummy(size);
    muted_text(c, p.stage->preview.busy() ? tr("Rendering the images\xE2\x80\xA6")
                  : stage.problem.empty() ? tr("There is no cloth to show.")
                                          : stage.problem.c_str());
  }
  ImGui::EndChild();
  PreviewSizes sizes;
  sizes.swatch_width = static_cast<int>(size.x * ratio), sizes.swatch_height = static_cast<int>(size.y * ratio);
  sizes.side = static_cast<int>(c.style.px(kThumbnail) * ratio);
  if (p.target < p.jobs.size()) p.stage->preview.ask(p.face, p.jobs[p.target].options, sizes);
}

void begin_export(ExportPrompt& p, bool over_others) {
  p.conflicts.clear();
  for (ExportJob& job : p.jobs) job.options.force = over_others;
  p.exporter->start(p.jobs, p.design);
  p.key.clear();  // the files on disk change
}

/// Handles the pressed button.
DialogResult press(ExportPrompt& p, int button, bool busy) {
  if (button < 0) return {};
  if (button == 1) return {DialogOutcome::kCancelled, ExportPrompt::kClose, {}};
  if (busy) {
    p.exporter->stop();
  } else if (!p.conflicts.empty()) {
    begin_export(p, true);
  } else {
    p.places->look(p.jobs);
    p.wants_export = true;
  }
  return {};
}

/// Exports what was asked for, once it is known what is in the folders; what is in the way is asked about first.
void export_once_looked(ExportPrompt& p) {
  const ExportPlaces::Found* there = p.places->found();
  if (!p.wants_export || there == nullptr) return;
  p.wants_export = false;
  p.conflicts = there->in_the_way;
  if (p.conflicts.empty()) begin_export(p, false);
}

}  // namespace

DialogResult draw_prompt(PanelContext& c, ExportPrompt& p) {
  const DialogSizes room = sizes_in(c);
  const Exporter::State state = p.exporter->state();
  heading(c, tr("Export texture set"));
  begin_list("choices", {room.column, room.height});
  const float width = ImGui::GetContentRegionAvail().x - c.style.px(kLabels + 8);
  draw_targets(c, p);
  ImGui::Dummy({0, c.style.px(2)});
  draw_size(c, *p.plan, width);
  draw_alpha(c, p, width);
  draw_mips(c, *p.plan, width);
  row_label(
      c, tr("Levels of detail"),
      tr("Two further sets of a quarter and a sixteenth of the size, with the same tile: without the shade between "
         "threads, and with nothing but their colours"));
  ImGui::Checkbox(tr("Also LOD 1 and 2"), &p.plan->lods);
  c.map.add_item("export.lods");
  const bool choose = draw_folder(c, *p.plan, width);
  row_label(c, "", nullptr);
  ImGui::Checkbox(tr("Export after every edit"), &p.plan->watch);
  c.map.add_item("export.watch");
  tooltip(c, tr("For engines that reload images: the sets follow the draft while this is on"));
  if (!state.busy) update_figures(p);
  export_once_looked(p);
  ImGui::Dummy({0, c.style.px(2)});
  draw_facts(c, p);
  ImGui::EndChild();
  ImGui::SameLine(0, c.style.px(20));
  ImGui::BeginChild("stage", {room.stage, room.height});
  draw_stage(c, p, room);
  ImGui::EndChild();
  const ImVec2 foot = ImGui::GetCursorPos();
  ImGui::Dummy({0, c.style.px(2)});
  ImGui::BeginChild("state", {room.column + room.stage - c.style.px(180), c.style.px(kFoot)});
  draw_progress(c, p, state);
  ImGui::EndChild();
  ImGui::SetCursorPos(foot);
  const bool asks = !state.busy && !p.conflicts.empty();
  const char* first = state.busy ? mark("Stop") : asks ? mark("Replace") : mark("Export");
  const int button = draw_buttons(c, {first, state.busy ? mark("Hide") : mark("Close")},
                                  !asks && !ImGui::GetIO().WantTextInput, true, asks ? -1 : 0);
  if (choose) return {DialogOutcome::kDone, ExportPrompt::kFolder, {}};
  return press(p, button, state.busy);
}

}  // namespace weftlight::views
