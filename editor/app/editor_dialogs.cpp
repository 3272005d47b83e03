// The editor's longer questions: a new draft's weave, and the export of textures.

#include <filesystem>
#include <optional>

#include "app/editor.h"
#include "files/files.h"
#include "texture_set/material_files.h"
#include "texture_set/texture_set.h"

namespace weftlight::app {
namespace {

constexpr int kAnalysisTab = 3;

struct TargetName {
  Target target;
  const char* name;
};
constexpr TargetName kTargets[] = {
    {Target::kGltf, "glTF"},
    {Target::kBlender, "Blender"},
    {Target::kUnreal, "Unreal Engine"},
    {Target::kUnityHdrp, "Unity HDRP"},
    {Target::kUnityUrp, "Unity URP"},
    {Target::kGodot, "Godot"},
    {Target::kU3m, "U3M"},
    {Target::kMaterialX, "MaterialX and USD"},
    {Target::kRaw, "Raw maps"},
};

/// Empty: done; else what went wrong. Any thread.
std::string export_textures_to(const std::string& folder, const Design& design, const TextureSetOptions& options) {
  Mesh mesh;
  if (needs_mesh(options.target)) {
    ReadMesh read = load_drape(design.scene.mesh);
    if (!read.mesh) return read.error;
    mesh = std::move(*read.mesh);
  }
  return write_texture_set(folder, design, mesh, options);
}

}  // namespace

void Editor::new_draft() { new_draft_of(0); }

void Editor::new_draft_of(int weave) {
  const Draft& d = document().now().draft;
  ask(prompt_for(weave, {d.ends(), d.picks()}), [this](int) {
    const WeavePrompt p = std::get<WeavePrompt>(dialog_);
    const WeaveKind& kind = weave_kinds()[static_cast<size_t>(p.kind)];
    open_beside(Document(draft::new_draft(kind, p.values, {p.ends, p.picks}).design), Origin::kOwn);
  });
}

void Editor::ask_weave() {
  constexpr uint64_t kWeaveStrokes = uint64_t{1} << 62;  // apart from those of the mouse
  const Draft& d = document().now().draft;
  const Selection& s = view().select.selected;
  const bool ends = !s.empty() && (s.grid == BitGrid::kThreading || s.grid == BitGrid::kDrawdown);
  const bool picks =
      !s.empty() && (s.grid == BitGrid::kTreadling || s.grid == BitGrid::kLiftplan || s.grid == BitGrid::kDrawdown);
  WeaveOverPrompt p;
  p.whole = !ends && !picks;
  p.use.ends = ends ? s.a1 - s.a0 : d.ends();
  p.use.first_end = ends ? s.a0 : 0;
  p.use.picks = picks ? s.b1 - s.b0 : d.picks();
  p.use.first_pick = picks ? s.b0 : 0;
  std::string weave = "twill";
  // Made by a weave before: its numbers are there to be changed.
  for (const WeaveUse& before : document().now().weaves)
    if (before.first_end == p.use.first_end && before.ends == p.use.ends && before.first_pick == p.use.first_pick &&
        before.picks == p.use.picks)
      weave = before.weave, p.use.values = before.values;
  for (size_t i = 0; i < weave_kinds().size(); ++i)
    if (weave_kinds()[i].id == weave) p.kind = static_cast<int>(i);
  p.base = document().snapshot();
  p.stroke = kWeaveStrokes | ++weaves_asked_;
  ask(std::move(p), [](int) {});
}

void Editor::export_textures() {
  ExportPrompt prompt;
  for (const TargetName& t : kTargets) prompt.targets.push_back(t.name);
  ask(std::move(prompt), [this](int) {
    const ExportPrompt p = std::get<ExportPrompt>(dialog_);
    dialog_ = {};
    ask_path(FileAsk::kFolder, "Folder for the textures",
             std::filesystem::path(document().path()).parent_path().string(),
             [this, p](const std::string& folder) { start_export(folder, p); });
  });
}

void Editor::ask_other() {
  ask_path(FileAsk::kOpen, "Compare with a draft", document().path(), [this](const std::string& path) {
    OpenResult result = open_document(path);
    if (!result.document) return report(std::move(result.remarks), path);
    view().other = std::make_shared<const OtherDraft>(
        OtherDraft{std::filesystem::path(path).filename().string(), result.document->now(), result.document->cells()});
    view().place = -1;
    settings_.inspector = true;
    settings_.inspector_tab = kAnalysisTab;
  });
}

void Editor::ask_print() {
  PrintPrompt prompt;
  prompt.options.end1_right = settings_.end1_right;
  prompt.preview = std::make_shared<SheetPreview>(document().snapshot(), Window::wake);
  ask(std::move(prompt), [this](int) {
    const PrintPrompt p = std::get<PrintPrompt>(dialog_);
    dialog_ = {};
    const std::filesystem::path draft(document().path().empty() ? "untitled.wif" : document().path());
    const std::string ending = ending_of(p.format);
    ask_path(
        FileAsk::kSave, "Print into", (draft.parent_path() / (draft.stem().string() + ending)).string(),
        [this, p](const std::string& path) { start_print(path, p); }, ending);
  });
}

void Editor::start_print(const std::string& path, const PrintPrompt& p) {
  const auto write = [this, path, p] {
    exporter_.run(path, "Printed into " + path, [path, p, design = document().snapshot()] {
      const print::Printed printed = print::printed(*design, p.format, chosen_options(p));
      std::string problem = printed.why;
      for (size_t i = 0; i < printed.files.size() && problem.empty(); ++i)
        problem = write_file_atomically(print::sheet_file(path, i, printed.files.size()), printed.files[i]);
      return problem.empty() ? problem : "Not printed: " + problem;
    });
    say("Printing\xE2\x80\xA6");
  };
  // The name itself was asked about; those of further sheets were not.
  const auto sheets = static_cast<size_t>(p.format == print::PrintFormat::kPdf ? 1 : p.preview->last().sheets);
  std::error_code ignored;
  for (size_t i = 0; sheets > 1 && i < sheets; ++i)
    if (const std::string file = print::sheet_file(path, i, sheets); std::filesystem::exists(file, ignored))
      return ask(Question{"Replace " + std::filesystem::path(file).filename().string() + "?",
                          "Sheets of that name are there already; printing would replace them.",
                          {"Replace", "Cancel"}},
                 [write](int button) {
                   if (button == 0) write();
                 });
  write();
}

void Editor::start_export(const std::string& folder, const ExportPrompt& p) {
  const std::filesystem::path file(document().path().empty() ? "untitled.wif" : document().path());
  TextureSetOptions options;
  options.target = kTargets[p.target].target;
  options.name = file_name_of(file.stem().string());
  options.source = file.filename().string();
  options.draft_path = document().path();
  options.program_version = WEFTLIGHT_VERSION;
  options.size = p.size;
  const std::string into = (std::filesystem::path(folder) / options.name).string();
  const auto run = [this, into](const TextureSetOptions& chosen) {
    exporter_.run(into, "Exported the textures to " + into, [into, chosen, design = document().snapshot()] {
      const std::string problem = export_textures_to(into, *design, chosen);
      return problem.empty() ? problem : "Not exported: " + problem;
    });
    say("Exporting the textures\xE2\x80\xA6");
  };
  const std::string there = who_is_there(into, options);
  if (there.empty()) return run(options);
  const std::string text =
      there.substr(0, there.find("; choose")) + ". Files of the same names would be replaced; all others stay.";
  ask(Question{"Write the textures there?", text, {"Leave it", "Write there"}}, [run, options](int button) {
    if (button != 1) return;
    TextureSetOptions forced = options;
    forced.force = true;
    run(forced);
  });
}

}  // namespace weftlight::app
