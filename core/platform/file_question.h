#pragma once
// What a dialog for files is asked.

#include <string>
#include <vector>

namespace weftlight::platform {

enum class FileAsk { kOpen, kSave, kFolder };

/// Files of one kind: what the user reads, and the endings' patterns such as "*.wif *.WIF".
struct FileFilter {
  std::string name, patterns;
};
struct FileQuestion {
  FileAsk what = FileAsk::kOpen;
  std::string title;
  std::string start;                // the file or folder that is proposed; empty: none
  std::vector<FileFilter> filters;  // the first is in force at the start; none for a folder
};

}  // namespace weftlight::platform
