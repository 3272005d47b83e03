#include "app/own_yarns.h"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "base/text.h"

namespace weftlight::app {

using base::arg, base::fill, base::message, base::tr, base::tr_n;
using design::LibraryYarn, design::library_yarn_of;
using session::ImportedYarns, session::keep_yarn;
using views::YarnsPrompt;

namespace {

constexpr const char* kEnding = ".txt";

}  // namespace

YarnActions OwnYarns::actions() {
  return {.show_library = [this] { ask(); }, .keep = [this] { keep(); }};
}

void OwnYarns::ask() {
  shelf_.load([this](const base::Result<void>& read) {
    dialogs_.when_none([this, problem = problem_of(read)] { show(problem); });
  });
}

void OwnYarns::show(const std::string& problem) {
  YarnsPrompt p;
  p.shelf = &shelf_;
  p.active_yarn = editing_.view().drawing.yarn;
  p.active_color = editing_.view().drawing.color;
  p.chosen = shelf_.yarns().empty() ? -1 : 0;
  p.problem = std::make_shared<std::string>(problem);
  dialogs_.ask(std::move(p), [this](int button) {
    if (button == YarnsPrompt::kImport) import();
    if (button == YarnsPrompt::kExport) export_all();
  });
}

void OwnYarns::keep() {
  const LibraryYarn kept =
      library_yarn_of(editing_.document().now(), editing_.view().drawing.yarn, editing_.view().drawing.color);
  shelf_.change(keep_yarn(kept), [this, name = kept.yarn.name](const base::Result<void>& written) {
    if (written) messages_.say(fill(tr("Added to the yarn library: {yarn}"), arg("yarn", name)));
    else messages_.refuse(fill(tr("Not added to the library: {problem}"), arg("problem", message(written.error()))));
  });
}

void OwnYarns::import() {
  dialogs_.close();
  dialogs_.ask_path(
      FileAsk::kOpen, tr("Import yarns"), {},
      [this](const std::string& path) {
        shelf_.import(path, [this](const base::Result<ImportedYarns>& in) {
          if (!in) return messages_.refuse(fill(tr("Not imported: {problem}"), arg("problem", message(in.error()))));
          const auto count = static_cast<long long>(in->count);
          const std::string yarns =
              fill(tr_n("Imported {count} yarn", "Imported {count} yarns", count), arg("count", count));
          messages_.say(in->remark.empty()
                            ? yarns
                            : fill(tr("{yarns}; {remark}"), arg("yarns", yarns), arg("remark", in->remark)));
          dialogs_.when_none([this] { show({}); });
        });
      },
      kEnding);
}

void OwnYarns::export_all() {
  dialogs_.close();
  const std::string start = (std::filesystem::path(editing_.document().path()).parent_path() / "yarns.txt").string();
  dialogs_.ask_path(
      FileAsk::kSave, tr("Export yarns"), start,
      [this](const std::string& path) {
        shelf_.export_to(path, [this, path](const base::Result<void>& written) {
          if (written) messages_.say(fill(tr("Wrote {file}"), arg("file", path)));
          else messages_.refuse(fill(tr("Not saved: {problem}"), arg("problem", message(written.error()))));
        });
      },
      kEnding);
}

}  // namespace weftlight::app
