// The dialogs of the editor: new draft, weaves, sections, export, comparison, environment, print.

#include <cstdlib>
#include <filesystem>
#include <optional>

#include "app/editor.h"
#include "base/text.h"
#include "draft/generators/sections.h"
#include "draft/lights.h"
#include "draft/selection_edits.h"
#include "files/environment.h"
#include "views/analysis/yarn_need_panel.h"

namespace weftlight::app {

using base::arg;
using base::fill;
using base::mark;
using base::tr;

namespace {

constexpr int kAnalysisTab = 3;

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
  constexpr uint64_t kWeaveStrokes = uint64_t{1} << 62;  // distinct from mouse strokes
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
  // If a weave made these threads, its values are shown again.
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

void Editor::ask_sections() {
  constexpr uint64_t kSectionStrokes = uint64_t{3} << 61;  // distinct from mouse and weave strokes
  const Design& d = document().now();
  const Selection& s = view().select.selected;
  SectionsPrompt p;
  p.last_end = d.draft.ends(), p.last_pick = d.draft.picks();
  if (const std::optional<ThreadRange> range = s.empty() ? std::nullopt : threads_of(s)) {
    p.system = range->system;
    (range->system == System::kWarp ? p.first_end : p.first_pick) = range->first + 1;
    (range->system == System::kWarp ? p.last_end : p.last_pick) = range->end;
  }
  p.warp = d.warp_assembly, p.weft = d.weft_assembly;
  p.name = free_section_name(p.system == System::kWarp ? p.warp : p.weft);
  p.base = document().snapshot();
  p.stroke = kSectionStrokes | ++weaves_asked_;
  ask(std::move(p), [](int) {});
}

void Editor::find_closest_weave() {
  std::optional<RejectedEdit>& rejected_edit = view().rejected_edit;
  if (!rejected_edit || rejected_edit->nearest || strokes_.going_on()) return;
  rejected_edit->nearest = nearest_to(document().now(), *rejected_edit->requested);
  if (!rejected_edit->nearest) rejected_edit.reset();
}

void Editor::ask_closest_weave() {
  constexpr uint64_t kClosestStrokes = uint64_t{5} << 60;  // distinct from mouse, weave and section strokes
  if (!view().rejected_edit || !view().rejected_edit->nearest) return;
  ClosestWeavePrompt p{view().rejected_edit->nearest, document().snapshot(), kClosestStrokes | ++weaves_asked_};
  Edit edit{tr("Closest weave for this loom"), [nearest = p.nearest](const Design&) { return *nearest->design; }};
  edit.stroke = p.stroke;
  commit(edit);
  view().differences.closest = p.nearest;
  view().differences.place = -1;
  ask(std::move(p), [](int) {});
}

void Editor::export_textures() {
  if (export_plan_->folder.empty()) {
    const std::filesystem::path beside = std::filesystem::path(document().path()).parent_path();
    const char* home = std::getenv("HOME");
    export_plan_->folder = ((beside.empty() ? std::filesystem::path(home ? home : ".") : beside) / "textures").string();
  }
  ExportPrompt prompt;
  prompt.plan = export_plan_;
  prompt.design = document().snapshot();
  prompt.draft_path = document().path(), prompt.version = WEFTLIGHT_VERSION;
  prompt.exporter = &sets_;
  prompt.stage = std::make_shared<ExportStage>(prompt.design, Window::wake);
  exported_ = session_.active().id;
  ask(std::move(prompt), [this](int) {
    dialog_ = {};
    ask_path(FileAsk::kFolder, tr("Folder for the texture set"), export_plan_->folder,
             [this](const std::string& folder) {
               export_plan_->folder = folder;
               export_textures();
             });
  });
}

/// Exports again after an edit of the exported draft, if that is wanted.
void Editor::export_again() {
  if (!export_plan_->watch || session_.active().id != exported_ || !sets_.began()) return;
  sets_.start(jobs_of(*export_plan_, document().now(), document().path(), WEFTLIGHT_VERSION), document().snapshot());
}

void Editor::ask_other() {
  ask_path(FileAsk::kOpen, tr("Compare with a draft"), document().path(), [this](const std::string& path) {
    OpenResult result = open_document(path);
    if (!result.document) return report(std::move(result.remarks), path);
    view().differences.other = std::make_shared<const OtherDraft>(
        OtherDraft{std::filesystem::path(path).filename().string(), result.document->now(), result.document->cells()});
    view().differences.place = -1;
    settings_.inspector = true;
    settings_.inspector_tab = kAnalysisTab;
  });
}

void Editor::ask_environment() {
  const std::string now = document().now().scene.lights;
  ask_path(
      FileAsk::kOpen, tr("Environment picture"), is_environment(now) ? now : "",
      [this](const std::string& path) {
        if (!is_environment(path)) return say(tr("An environment picture ends in .hdr or .exr."));
        if (const std::string problem = environment_problem(path); !problem.empty()) return say(problem);
        commit({tr("Environment picture"), [path](Design d) {
                  d.scene = lit_by_environment(d.scene, path);
                  return d;
                }});
      },
      ".hdr");
}

void Editor::ask_print() {
  PrintPrompt prompt;
  prompt.options.end1_right = settings_.end1_right;
  prompt.options.pick1_bottom = settings_.pick1_bottom;
  prompt.options.threading_below = settings_.threading_below;
  prompt.options.heavy_lines = settings_.heavy_lines;
  prompt.options.plan = plan_of(document().now(), view().analysis, settings_);
  prompt.options.name = std::filesystem::path(document().shown_name()).stem().string();
  prompt.preview = std::make_shared<SheetPreview>(document().snapshot(), Window::wake);
  ask(std::move(prompt), [this](int) {
    const PrintPrompt p = std::get<PrintPrompt>(dialog_);
    dialog_ = {};
    const std::filesystem::path draft(document().path().empty() ? "untitled.wif" : document().path());
    const std::string ending = ending_of(p.format);
    ask_path(
        FileAsk::kSave, tr("Print to a file"), (draft.parent_path() / (draft.stem().string() + ending)).string(),
        [this, p](const std::string& path) { start_print(path, p); }, ending);
  });
}

void Editor::start_print(const std::string& path, const PrintPrompt& p) {
  const auto write = [this, path, p] {
    exporter_.run(path, fill(tr("Printed to {path}"), arg("path", path)), [path, p, design = document().snapshot()] {
      const print::Printed printed = print::printed(*design, p.format, chosen_options(p));
      std::string problem = printed.why;
      for (size_t i = 0; i < printed.files.size() && problem.empty(); ++i)
        problem = write_file_atomically(print::sheet_file(path, i, printed.files.size()), printed.files[i]);
      return problem.empty() ? problem : fill(tr("Not printed: {problem}"), arg("problem", problem));
    });
    say(tr("Printing\xE2\x80\xA6"));
  };
  // The dialog confirmed the name itself, but not those of further sheets.
  const auto sheets = static_cast<size_t>(p.format == print::PrintFormat::kPdf ? 1 : p.preview->last().sheets);
  std::error_code ignored;
  for (size_t i = 0; sheets > 1 && i < sheets; ++i)
    if (const std::string file = print::sheet_file(path, i, sheets); std::filesystem::exists(file, ignored))
      return ask(Question{fill(tr("Replace {file}?"), arg("file", std::filesystem::path(file).filename().string())),
                          tr("Sheets of that name already exist. Printing would replace them."),
                          {mark("Replace"), mark("Cancel")}},
                 [write](int button) {
                   if (button == 0) write();
                 });
  write();
}

}  // namespace weftlight::app
