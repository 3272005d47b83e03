#include "session/library/yarn_shelf.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "base/text.h"
#include "base/user_folders.h"
#include "base/whole_files.h"

namespace weftlight::session {

using base::Result, base::arg, base::failed, base::fill, base::read_file, base::tr, base::write_file_atomically;
using design::as_written, design::kMaxLibraryBytes, design::read_yarn_library, design::with_library_yarn,
    design::yarn_library_text;

namespace {

namespace fs = std::filesystem;

Result<YarnLibrary> read_list(const std::string& path) {
  const Result<std::string> text = read_file(path, kMaxLibraryBytes);
  if (!text) return failed(text);
  Result<YarnLibrary> read = read_yarn_library(*text);
  if (!read) {
    base::Error error = read.error();
    error.file = path;
    return base::Failure(std::move(error));
  }
  return read;
}

/// A library that is not there yet is empty.
Result<YarnLibrary> read_own(const std::string& path) {
  std::error_code unknown;
  if (!fs::exists(path, unknown) && !unknown) return YarnLibrary{};
  return read_list(path);
}

Result<YarnLibrary> changed(const std::string& path, const YarnShelf::Change& change) {
  Result<YarnLibrary> library = read_own(path);
  if (!library) return library;
  change(*library);
  std::error_code ignored;  // writing says what is wrong
  fs::create_directories(fs::path(path).parent_path(), ignored);
  if (const Result<void> written = write_file_atomically(path, yarn_library_text(*library)); !written)
    return failed(written);
  return library;
}

auto place_of(YarnLibrary& library, const LibraryYarn& yarn) { return std::ranges::find(library.yarns, yarn); }

}  // namespace

std::string yarn_shelf_path() { return (fs::path(base::config_folder()) / "yarns.txt").string(); }

void YarnShelf::show(YarnLibrary library) {
  library_ = std::move(library);
  ++revision_;
}

void YarnShelf::start(std::function<Result<YarnLibrary>()> work, Done done, bool writes) {
  writing_ += writes ? 1 : 0;
  base::Task task = base::task_with_result([work = std::move(work)](const base::RunningTask&) { return work(); },
                                           [this, writes, done = std::move(done)](Result<YarnLibrary> library) {
                                             writing_ -= writes ? 1 : 0;
                                             if (library && writing_ == 0) show(std::move(*library));
                                             if (done) done(library ? Result<void>{} : Result<void>(failed(library)));
                                           });
  task.kind = "yarns:" + std::to_string(++started_);
  task.name = tr("Yarn library");
  task.finishes = writes;
  runner_.start(std::move(task));
}

void YarnShelf::load(Done done) {
  start([path = path_] { return read_own(path); }, std::move(done), false);
}

void YarnShelf::change(Change change, Done done) {
  YarnLibrary now = library_;
  change(now);
  show(std::move(now));
  start([path = path_, change] { return changed(path, change); },
        [this, done = std::move(done)](const Result<void>& written) {
          if (!written) load({});  // what is shown was not written
          if (done) done(written);
        },
        true);
}

void YarnShelf::import(const std::string& from, std::function<void(const Result<ImportedYarns>&)> done) {
  const auto imported = std::make_shared<ImportedYarns>();
  const auto work = [path = path_, from, imported]() -> Result<YarnLibrary> {
    const Result<YarnLibrary> list = read_list(from);
    if (!list) return failed(list);
    imported->count = list->yarns.size();
    if (!list->remarks.empty())
      imported->remark = fill(tr("line {line}: {problem}"), arg("line", list->remarks.front().line),
                              arg("problem", list->remarks.front().text));
    return changed(path, [&](YarnLibrary& own) {
      for (const LibraryYarn& yarn : list->yarns) own.yarns = with_library_yarn(std::move(own.yarns), yarn);
    });
  };
  start(
      work,
      [imported, done = std::move(done)](const Result<void>& written) {
        if (written) done(*imported);
        else done(failed(written));
      },
      true);
}

void YarnShelf::export_to(const std::string& to, Done done) {
  const auto list = std::make_shared<const YarnLibrary>(library_);
  start(
      [to, list]() -> Result<YarnLibrary> {
        if (const Result<void> written = write_file_atomically(to, yarn_library_text(*list)); !written)
          return failed(written);
        return *list;
      },
      std::move(done), true);
}

YarnShelf::Change keep_yarn(const LibraryYarn& yarn) {
  return [yarn = as_written(yarn)](YarnLibrary& l) { l.yarns = with_library_yarn(std::move(l.yarns), yarn); };
}

YarnShelf::Change replace_yarn(LibraryYarn before, const LibraryYarn& after) {
  return [before = std::move(before), after = as_written(after)](YarnLibrary& l) {
    const auto at = place_of(l, before);
    if (at == l.yarns.end()) return;
    if (before.yarn.name == after.yarn.name) {
      *at = after;
      return;
    }
    l.yarns.erase(at);
    l.yarns = with_library_yarn(std::move(l.yarns), after);
  };
}

YarnShelf::Change remove_yarn(LibraryYarn yarn) {
  return [yarn = std::move(yarn)](YarnLibrary& l) {
    if (const auto at = place_of(l, yarn); at != l.yarns.end()) l.yarns.erase(at);
  };
}

}  // namespace weftlight::session
