#pragma once
// All files of a folder and of the folders in it.

#include <string>
#include <vector>

namespace weftlight::platform {

struct FilesBelow {
  std::vector<std::string> files;   // their paths, sorted
  std::vector<std::string> unread;  // folders whose contents are not known, since they cannot be read
};
/// Regular files, and links to them. Folders behind links are not entered: such links may lead round in a circle.
/// Without memory it throws std::bad_alloc; libstdc++'s recursive_directory_iterator would end the program.
FilesBelow files_below(const std::string& folder);

}  // namespace weftlight::platform
