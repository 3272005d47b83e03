#include "session/stale_files.h"

#include <signal.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <vector>

namespace weftlight::session {
namespace {

namespace fs = std::filesystem;

/// "PROCESS-COUNT" of a process that is gone. One of another user still lives.
bool is_of_the_dead(std::string_view mark) {
  int process = 0, count = 0;
  const char* end = mark.data() + mark.size();
  const auto [dash, bad_process] = std::from_chars(mark.data(), end, process);
  if (bad_process != std::errc() || process <= 0 || dash == end || *dash != '-') return false;
  const auto [rest, bad_count] = std::from_chars(dash + 1, end, count);
  if (bad_count != std::errc() || rest != end) return false;
  return ::kill(process, 0) != 0 && errno == ESRCH;
}

}  // namespace

void remove_stale_files(const std::string& path) {
  if (path.empty()) return;
  const fs::path file(path), folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const std::string start = file.stem().string() + ".part-", ending = file.extension().string();
  std::vector<fs::path> gone;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    std::string name = entry.path().filename().string();
    if (!name.starts_with(start) || !name.ends_with(ending) || name.size() < start.size() + ending.size()) continue;
    name.resize(name.size() - ending.size());
    if (is_of_the_dead(std::string_view(name).substr(start.size())) && !entry.is_symlink(error) &&
        entry.is_regular_file(error))
      gone.push_back(entry.path());
  }
  for (const fs::path& left : gone) fs::remove(left, error);
}

}  // namespace weftlight::session
