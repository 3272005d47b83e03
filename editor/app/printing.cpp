#include "app/printing.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/window.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "platform/environment_variables.h"
#include "platform/process.h"
#include "platform/unique_name.h"
#include "views/common/panel.h"

namespace weftlight::app {

using base::arg, base::fill, base::mark, base::tr, base::write_file_atomically;
using design::Design;
using session::Document;
using views::Question, views::SheetPreview, views::chosen_options, views::ending_of, views::units_of;

namespace {

constexpr const char* kSpooler = "lp";  // of CUPS, as of other systems

/// Hands a PDF to the spooler, at its own scale.
base::Result<void> spool(const std::string& pdf, const std::string& title, const std::string& paper) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("weftlight-" + platform::unique_name() + ".pdf");
  if (auto done = write_file_atomically(file.string(), pdf); !done) return done;
  platform::Process lp(
      {kSpooler, "-t", title, "-o", "media=" + paper, "-o", "print-scaling=none", "--", file.string()});
  const bool started = lp.running();
  while (lp.running()) {
    lp.look();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  std::error_code ignored;
  std::filesystem::remove(file, ignored);  // the spooler has a copy
  if (started && lp.succeeded()) return {};
  return base::failure(base::ErrorKind::kOutput,
                       fill(tr("the system's printing program ({program}) reports an error; is a printer set up?"),
                            arg("program", kSpooler)));
}

base::Result<void> print_to(const std::string& path, const Design& design, const PrintPrompt& p,
                            const base::TaskProgress& progress) {
  const base::Result<print::Printed> printed = print::printed(design, p.format, chosen_options(p));
  if (!printed) return failed(printed);
  const size_t sheets = printed->files.size();
  for (size_t i = 0; i < sheets; ++i) {
    progress.report(static_cast<float>(i) / static_cast<float>(sheets));
    const std::string file = print::sheet_file(path, i, sheets);
    if (auto done = write_file_atomically(file, printed->files[i]); !done) return done;
  }
  return {};
}

}  // namespace

void Printing::ask() {
  const Document& document = editing_.document();
  PrintPrompt prompt;
  prompt.options.end1_right = settings_.end1_right;
  prompt.options.pick1_bottom = settings_.pick1_bottom;
  prompt.options.threading_below = settings_.threading_below;
  prompt.options.heavy_lines = settings_.heavy_lines;
  prompt.options.units = units_of(settings_);
  prompt.options.name = document.is_named() ? document.file_stem() : document.shown_name();
  prompt.preview = std::make_shared<SheetPreview>(document.snapshot(), Window::wake);
  prompt.has_printer = platform::is_program(kSpooler, platform::variable("PATH"));
  dialogs_.ask(std::move(prompt), [this](int pressed) {
    const PrintPrompt p = dialogs_.prompt<PrintPrompt>();
    dialogs_.close();
    if (p.button(pressed) == PrintPrompt::Button::kPrint) send(p);
    else save(p);
  });
}

void Printing::save(const PrintPrompt& p) {
  const Document& document = editing_.document();
  const std::filesystem::path folder = std::filesystem::path(document.path()).parent_path();
  const std::string ending = ending_of(p.format);
  dialogs_.ask_path(
      FileAsk::kSave, tr("Print to a file"), (folder / (document.file_stem() + ending)).string(),
      [this, p](const std::string& to) { start(to, p); }, ending);
}

void Printing::send(const PrintPrompt& p) {
  const std::string name = editing_.document().shown_name();
  base::Task task = base::task_with_result(
      [p, name, design = editing_.document().snapshot()](const base::RunningTask&) -> base::Result<void> {
        const base::Result<print::Printed> printed =
            print::printed(*design, print::PrintFormat::kPdf, chosen_options(p));
        if (!printed) return failed(printed);
        return spool(printed->files.front(), name, print::kPapers[p.paper].name);
      },
      [this, name](const base::Result<void>& sent) {
        if (sent) messages_.say(fill(tr("Sent to the printer: {file}"), arg("file", name)));
        else messages_.refuse(fill(tr("Not printed: {problem}"), arg("problem", message(sent.error()))));
      });
  task.kind = "print";
  task.name = fill(tr("Printing {file}"), arg("file", name));
  task.finishes = true;
  tasks_.computing().start(std::move(task));
}

void Printing::start(const std::string& path, const PrintPrompt& p) {
  const auto write = [this, path, p] {
    base::Task task = base::task_with_result(
        [path, p, design = editing_.document().snapshot()](const base::RunningTask& running) {
          return print_to(path, *design, p, running);
        },
        [this, path](const base::Result<void>& printed) {
          if (printed) messages_.say(fill(tr("Printed to {path}"), arg("path", path)));
          else messages_.refuse(fill(tr("Not printed: {problem}"), arg("problem", message(printed.error()))));
        });
    task.kind = "print:" + path;
    task.name = fill(tr("Printing to {file}"), arg("file", std::filesystem::path(path).filename().string()));
    task.finishes = true;
    tasks_.computing().start(std::move(task));
  };
  // The dialog confirmed the name itself, but not those of further sheets.
  const auto sheets = static_cast<size_t>(p.format == print::PrintFormat::kPdf ? 1 : p.preview->last().sheets);
  if (sheets <= 1) return write();
  std::vector<std::string> files;
  for (size_t i = 0; i < sheets; ++i) files.push_back(print::sheet_file(path, i, sheets));
  dialogs_.before_replacing(
      std::move(files),
      [](const std::string& there) {
        return Question{fill(tr("Replace {file}?"), arg("file", std::filesystem::path(there).filename().string())),
                        tr("Sheets of that name already exist. Printing would replace them."),
                        {mark("Replace"), mark("Cancel")},
                        1};
      },
      write);
}

}  // namespace weftlight::app
