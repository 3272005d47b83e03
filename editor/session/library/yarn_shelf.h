#pragma once
// The user's library of yarns: a plain text in the folder of settings (design/yarn_library.h). Every change reads the
// file, changes it and writes it, so that two windows keep each other's yarns and edits by hand. A file that cannot be
// read is never written over.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "base/tasks.h"
#include "design/yarn_library.h"

namespace weftlight::session {

using design::LibraryYarn, design::YarnLibrary;

/// $XDG_CONFIG_HOME/weftlight/yarns.txt
std::string yarn_shelf_path();

/// What came in from another file.
struct ImportedYarns {
  size_t count = 0;
  std::string remark;  // the first line that could not be used, and why; empty: none
};

class YarnShelf {
 public:
  using Change = std::function<void(YarnLibrary&)>;
  using Done = std::function<void(const base::Result<void>&)>;
  /// `runner`: its tasks run one after the other, and their results are taken on the window's thread.
  YarnShelf(base::TaskRunner& runner, std::string path = yarn_shelf_path()) : runner_(runner), path_(std::move(path)) {}

  /// As it was last read, with the changes that are still being written.
  const std::vector<LibraryYarn>& yarns() const { return library_.yarns; }
  /// Increases with every change of yarns().
  uint64_t revision() const { return revision_; }
  const std::string& path() const { return path_; }
  void load(Done done);
  /// `change` runs twice: on what is shown, and on what is in the file.
  void change(Change change, Done done);
  void import(const std::string& from, std::function<void(const base::Result<ImportedYarns>&)> done);
  /// Writes what is shown as a file of its own.
  void export_to(const std::string& to, Done done);

 private:
  void start(std::function<base::Result<YarnLibrary>()> work, Done done, bool writes);
  void show(YarnLibrary library);

  base::TaskRunner& runner_;
  std::string path_;
  YarnLibrary library_;
  uint64_t revision_ = 0, started_ = 0;
  int writing_ = 0;  // changes on their way to the file
};

/// Adds the yarn, or what is new of it.
YarnShelf::Change keep_yarn(const LibraryYarn& yarn);
/// Replaces a yarn by another, or removes it.
YarnShelf::Change replace_yarn(LibraryYarn before, const LibraryYarn& after);
YarnShelf::Change remove_yarn(LibraryYarn yarn);

}  // namespace weftlight::session
