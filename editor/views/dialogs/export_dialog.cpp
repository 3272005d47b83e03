#include "views/dialogs/export_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "ui/imgui_compat.h"
#include "ui/widgets.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {

bool ExportStage::poll() {
  std::optional<ExportPreview> news = preview.take();
  if (!news) return false;
  shown = std::move(*news);
  if (!shown.pixels.empty()) texture.set(shown.width, shown.height, std::exchange(shown.pixels, {}));
  return true;
}

namespace {

// Pixels at 96 dpi.
constexpr float kColumn = 360, kLabels = 104, kStageWidth = 520, kHeight = 532, kFoot = 44, kAround = 150;
constexpr int kThumbnail = 84, kSwatchHeight = 150;
constexpr Target kOrder[] = {Target::kGltf,  Target::kBlender,   Target::kUnreal, Target::kUnityHdrp, Target::kUnityUrp,
                             Target::kGodot, Target::kMaterialX, Target::kU3m,    Target::kRaw};

/// As large as the window has room for.
struct Room {
  float column = 0, stage = 0, height = 0;
};
Room room_in(PanelContext& c) {
  const ImVec2 view = ImGui::GetMainViewport()->WorkSize;
  Room r;
  r.column = c.style.px(kColumn);
  r.stage = std::min(c.style.px(kStageWidth), view.x - r.column - c.style.px(80));
  r.height = std::min(c.style.px(kHeight), view.y - c.style.px(kAround));
  return r;
}

bool has(const ExportPlan& plan, Target target) {
  return std::find(plan.targets.begin(), plan.targets.end(), target) != plan.targets.end();
}

std::string figure(float v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", static_cast<double>(v));
  return text;
}

void draw_targets(PanelContext& c, ExportPrompt& p, float width) {
  row_label(c, "For", "Which programs read them: names, packing and normals are made for each");
  ImGui::BeginGroup();
  int at = 0;
  for (const Target target : kOrder) {
    if (at++ % 2) ImGui::SameLine(width * 0.56f);
    bool on = has(*p.plan, target);
    if (ImGui::Checkbox(target_title(target), &on)) toggle(*p.plan, target);
    c.map.add_item(std::string("export.for:") + target_name(target));
  }
  ImGui::EndGroup();
  p.target = std::min(p.target, p.plan->targets.size() - 1);
}

void draw_size(PanelContext& c, ExportPlan& plan, float width) {
  constexpr const char* kWays[] = {"By texels", "By millimetre"};
  int way = plan.by_density ? 1 : 0;
  row_label(c, "Size", "Texels of the longer side of the tile, or how many a millimetre of cloth gets");
  segmented(c, "export.by", kWays, way, width);
  plan.by_density = way == 1;
  if (plan.by_density) {
    slider(
        c,
        {"export.density", "", 2, 200, "%.0f /mm", "At least so many texels a millimetre: the next power of two", true},
        plan.texels_per_mm);
  } else {
    constexpr const char* kSizes[] = {"512", "1024", "2048", "4096", "8192"};
    int step = 0;
    while (step < 4 && (512 << step) < plan.size) ++step;
    row_label(c, "", nullptr);
    segmented(c, "export.size", kSizes, step, width);
    plan.size = 512 << step;
  }
  slider(c,
         {"export.tile", "Tile", 0, 50, plan.tile_cm > 0 ? "%.0f cm" : "a repeat",
          "Least width of the tile: more repeats, in which yarns differ; at 0 one repeat"},
         plan.tile_cm);
  plan.tile_cm = std::round(plan.tile_cm);
}

void draw_alpha(PanelContext& c, ExportPrompt& p, float width) {
  constexpr const char* kNames[] = {"As open as it is", "Opaque", "Mask", "Hashed", "Blend"};
  ExportPlan& plan = *p.plan;
  row_label(c, "Gaps", "How light comes through; as open as it is: opaque where there are but pinholes");
  ImGui::SetNextItemWidth(width);
  if (begin_combo(c, "export.alpha", kNames[static_cast<size_t>(plan.alpha)])) {
    for (size_t i = 0; i < std::size(kNames); ++i) {
      if (ImGui::Selectable(kNames[i], i == static_cast<size_t>(plan.alpha))) plan.alpha = static_cast<Alpha>(i);
      c.map.add_item(std::string("export.alpha:") + alpha_name(static_cast<Alpha>(i)));
    }
    end_combo();
  }
}

void draw_mips(PanelContext& c, ExportPlan& plan, float width) {
  constexpr const char* kNames[] = {"None", ".dds", ".ktx2"};
  row_label(c, "Mips",
            "None: the program averages each image alone. Else beside each image the same with mips of our own, "
            "in which "
            "roughness holds what normals lose and gaps stay as open");
  int way = !plan.mips ? 0 : *plan.mips == MipContainer::kDds ? 1 : 2;
  segmented(c, "export.mips", kNames, way, width);
  plan.mips.reset();
  if (way > 0) plan.mips = way == 1 ? MipContainer::kDds : MipContainer::kKtx2;
}

/// True: the folder is to be chosen.
bool draw_folder(PanelContext& c, ExportPlan& plan, float width) {
  row_label(c, "Into", "Each draft gets a folder of its own within; of several programs each one more");
  const float button = ImGui::CalcTextSize("Choose\xE2\x80\xA6").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(width - button - ImGui::GetStyle().ItemInnerSpacing.x);
  ImGui::InputText("##folder", &plan.folder);
  c.map.add_item("export.folder");
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  return text_button(c, "export.choose", "Choose\xE2\x80\xA6", nullptr);
}

void work_out(ExportPrompt& p) {
  std::vector<ExportJob> jobs = jobs_of(*p.plan, *p.design, p.draft_path, p.version);
  std::string key;
  for (const ExportJob& job : jobs) key.append(job.folder).append(" ").append(key_of(job.options)).append("\n");
  if (key == p.key) return;
  p.key = std::move(key), p.jobs = std::move(jobs);
  p.figures = figures_of(*p.design, p.jobs);
  p.replaced = replaced_files(p.jobs);
  p.asked.clear();
}

void draw_facts(PanelContext& c, const ExportPrompt& p) {
  const ExportFigures& f = p.figures;
  const auto line = [&c](const char* label, const std::string& text) {
    row_label(c, label, nullptr);
    ImGui::TextUnformatted(text.c_str());
  };
  if (f.set.ends > 0) {
    line("Measures", figure(f.set.width_mm) + " \xC3\x97 " + figure(f.set.depth_mm) + " mm, " +
                         std::to_string(f.set.ends) + " ends \xC3\x97 " + std::to_string(f.set.picks) + " picks");
    line("Images", std::to_string(f.images) + " of " + std::to_string(f.set.size.width) + " \xC3\x97 " +
                       std::to_string(f.set.size.height));
    line("A thread", figure(f.texels_a_thread) + " texels");
    c.map.add_item("export.images:" + std::to_string(f.images));
    const int64_t disk = bytes_on_disk(p.stage->shown, f.set.size);
    const std::string each = p.jobs.size() > 1 ? " each" : "";
    line("Room", (disk > 0 ? "about " + shown_bytes(disk) + each + " on disk, " : std::string()) +
                     shown_bytes(f.texel_bytes) + " on the card");
  }
  for (const std::string& why : f.why) {
    ImGui::PushStyleColor(ImGuiCol_Text, c.style.color.warn);
    ImGui::TextWrapped("%s", why.c_str());
    ImGui::PopStyleColor();
  }
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
    const std::string text = state.sets > 1 ? std::to_string(state.set + 1) + " of " + std::to_string(state.sets) : "";
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, c.style.color.accent);
    ImGui::ProgressBar(state.share, {std::min(width, c.style.px(kColumn)), c.style.px(8)}, "");
    ImGui::PopStyleColor();
    c.map.add_item("export.progress");
    words("Writing " + (text.empty() ? std::string("the images") : "set " + text) + "\xE2\x80\xA6",
          c.style.color.muted);
  } else if (!p.asked.empty()) {
    for (const std::string& there : p.asked) words(there + ".", c.style.color.warn);
    words("Files of the same names would be replaced; all others stay.", c.style.color.text);
    c.map.add_item("export.asked");
  } else if (!state.problems.empty()) {
    for (const std::string& problem : state.problems) words(problem, c.style.color.error);
  } else if (state.stopped) {
    words("Stopped; what stood there before stands.", c.style.color.muted);
  } else if (!state.written.empty()) {
    words("Written: " + (state.written.size() == 1
                             ? state.written.front()
                             : std::to_string(state.written.size()) + " sets in " +
                                   std::filesystem::path(state.written.front()).parent_path().string()),
          c.style.color.text);
    c.map.add_item("export.written");
  } else if (p.replaced > 0) {
    words("Replaces " + std::to_string(p.replaced) + " files of the earlier export; all others stay.",
          c.style.color.muted);
  }
}

/// A part of the picture, with a hairline around it.
void draw_part(PanelContext& c, const ExportStage& stage, const PictureRect& at, ImVec2 from, ImVec2 size) {
  const auto u = [&](int x) { return static_cast<float>(x) / static_cast<float>(stage.shown.width); };
  const auto v = [&](int y) { return static_cast<float>(y) / static_cast<float>(stage.shown.height); };
  const ImVec2 to{from.x + size.x, from.y + size.y};
  ImDrawList* dl = ImGui::GetWindowDrawList();
  dl->AddImageRounded(stage.texture.id(), from, to, {u(at.x), v(at.y)}, {u(at.x + at.width), v(at.y + at.height)},
                      IM_COL32_WHITE, c.style.px(3));
  dl->AddRect(from, to, c.style.color.line_strong, c.style.px(3));
}

/// An image: whole, then its channels, each with what it holds.
void draw_image(PanelContext& c, const ExportStage& stage, const ShownImage& image, float ratio) {
  push_font(c.style.font.small);
  ImGui::TextUnformatted(image.file.c_str());
  ImGui::SameLine();
  muted_text(c, image.about);
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
  if (image.channels.size() > 1) part(image.at, "together");
  for (const ShownChannel& channel : image.channels) part(channel.at, channel.words);
  ImGui::SetCursorScreenPos(start);
  ImGui::Dummy({at.x - start.x, static_cast<float>(image.at.height) / ratio + line + c.style.px(8)});
  c.map.add_item("export.map:" + image.file);
  ImGui::PopFont();
}

void draw_stage(PanelContext& c, ExportPrompt& p, const Room& room) {
  const float wide = room.stage - ImGui::GetStyle().ScrollbarSize - c.style.px(8);
  if (p.plan->targets.size() > 1) {
    ImGui::SetNextItemWidth(c.style.px(190));
    if (begin_combo(c, "export.shown", target_title(p.plan->targets[p.target]))) {
      for (size_t i = 0; i < p.plan->targets.size(); ++i) {
        if (ImGui::Selectable(target_title(p.plan->targets[i]), i == p.target)) p.target = i;
        c.map.add_item(std::string("export.shown:") + target_name(p.plan->targets[i]));
      }
      end_combo();
    }
    ImGui::SameLine();
  }
  constexpr const char* kFaces[] = {"Front", "Back"};
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
    muted_text(c, p.stage->preview.busy()       ? "The images are being made\xE2\x80\xA6"
                  : stage.shown.problem.empty() ? "There is no cloth to show."
                                                : stage.shown.problem.c_str());
  }
  ImGui::EndChild();
  PreviewSizes sizes;
  sizes.swatch_width = static_cast<int>(size.x * ratio), sizes.swatch_height = static_cast<int>(size.y * ratio);
  sizes.side = static_cast<int>(c.style.px(kThumbnail) * ratio);
  if (p.target < p.jobs.size()) p.stage->preview.ask(p.face, p.jobs[p.target].options, sizes);
}

/// What the pressed button does; an answer where the dialog is left.
DialogAnswer press(ExportPrompt& p, int button, bool busy) {
  if (button < 0) return {};
  if (button == 1) return {Answer::kLeft, ExportPrompt::kClose, {}};
  if (busy) {
    p.exporter->stop();
    return {};
  }
  const bool sure = !p.asked.empty();
  if (!sure) p.asked = in_the_way(p.jobs);
  if (!p.asked.empty() && !sure) return {};
  p.asked.clear();
  for (ExportJob& job : p.jobs) job.options.force = sure;
  p.exporter->start(p.jobs, p.design);
  p.key.clear();  // what stands there is another now
  return {};
}

}  // namespace

DialogAnswer draw_export_prompt(PanelContext& c, ExportPrompt& p) {
  const Room room = room_in(c);
  const Exporter::State state = p.exporter->state();
  heading(c, "Export texture set");
  ImGui::BeginChild("choices", {room.column, room.height});
  const float width = ImGui::GetContentRegionAvail().x - c.style.px(kLabels + 8);
  draw_targets(c, p, width);
  ImGui::Dummy({0, c.style.px(2)});
  draw_size(c, *p.plan, width);
  draw_alpha(c, p, width);
  draw_mips(c, *p.plan, width);
  const bool choose = draw_folder(c, *p.plan, width);
  row_label(c, "", nullptr);
  ImGui::Checkbox("Again after each edit", &p.plan->watch);
  c.map.add_item("export.watch");
  tooltip(c, "For engines that load images anew: the sets follow the draft while this is on");
  if (!state.busy) work_out(p);
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
  const char* first = state.busy ? "Stop" : p.asked.empty() ? "Export" : "Write there";
  const int button = draw_buttons(c, {first, state.busy ? "Hide" : "Close"}, !ImGui::GetIO().WantTextInput);
  if (choose) return {Answer::kDone, ExportPrompt::kFolder, {}};
  return press(p, button, state.busy);
}

}  // namespace weftlight::views
