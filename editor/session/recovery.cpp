#include "session/recovery.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>
#include <utility>

#include "wif/wif.h"

namespace weftlight::session {
namespace {

namespace fs = std::filesystem;
constexpr const char* kLock = "lock";
constexpr const char* kJournal = ".journal";

/// 64 random bits as 16 hexadecimal digits: no two sessions draw the same.
std::string random_name() {
  std::random_device random;
  std::string name;
  for (int digit = 0; digit < 16; ++digit) name += "0123456789abcdef"[random() % 16];
  return name;
}

bool is_session_name(const std::string& name) {
  return name.size() == 16 && name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::vector<fs::path> sessions_in(const fs::path& root) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(root, error))
    if (is_session_name(entry.path().filename().string()) && entry.is_directory(error)) found.push_back(entry.path());
  return found;
}

std::vector<fs::path> journals_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == kJournal) found.push_back(entry.path());
  return found;
}

struct ReadEntry {
  std::optional<JournalEntry> last;
  std::string problem;  // where there is none
};

ReadEntry read_entry(const std::string& journal) {
  if (facts_of(journal).size > 2 * kMaxJournalText) return {{}, "it is larger than any journal"};
  const FileBytes file = read_file(journal);
  if (!file.error.empty()) return {{}, file.error};
  ReadEntry read{read_journal(file.bytes), {}};
  if (!read.last) read.problem = "it is damaged before the end of its first entry";
  return read;
}

/// Made by a session that ended before it wrote into it.
bool holds_nothing(const fs::path& journal) {
  std::error_code error;
  return fs::is_regular_file(journal, error) && fs::file_size(journal, error) == 0 && !error;
}

/// The session ended after its file was written and before its journal went.
bool stands_saved(const JournalEntry& last) {
  if (last.note.path.empty() || facts_of(last.note.path).size != last.text.size()) return false;
  return identify(last.note.path).hash == content_hash(last.text);
}

/// With all that a session writes into it, as long as there is no journal.
void remove_session(const fs::path& folder) {
  std::error_code ignored;
  if (journals_in(folder).empty()) fs::remove_all(folder, ignored);
}

}  // namespace

FileLock::~FileLock() {
  if (file_ >= 0) ::close(file_);
}

FileLock::FileLock(FileLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(file_, other.file_);
  return *this;
}

FileLock FileLock::take(const std::string& path, int how) {
  FileLock lock;
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) return lock;
  int result = 0;
  while ((result = ::flock(file, how)) != 0 && errno == EINTR) {
  }
  if (result == 0) lock.file_ = file;
  else ::close(file);
  return lock;
}

FileLock FileLock::take(const std::string& path) { return take(path, LOCK_EX | LOCK_NB); }
FileLock FileLock::wait_for(const std::string& path) { return take(path, LOCK_EX); }

bool FileLock::stands_at(const std::string& path) const {
  struct stat held {
  }, there{};
  return file_ >= 0 && ::fstat(file_, &held) == 0 && ::stat(path.c_str(), &there) == 0 && held.st_dev == there.st_dev &&
         held.st_ino == there.st_ino;
}

Recovery::Recovery(std::string root) : root_(std::move(root)), folder_((fs::path(root_) / random_name()).string()) {}

Recovery::~Recovery() {
  if (lock_.held()) remove_session(folder_);
}

std::string Recovery::open() {
  const std::lock_guard mine(mutex_);
  const std::string path = (fs::path(folder_) / kLock).string();
  if (lock_.stands_at(path)) return {};
  std::error_code error;
  fs::create_directories(root_, error);
  // Whoever looks for crashed sessions waits: a folder without its lock would be taken for one.
  const FileLock all = FileLock::wait_for((fs::path(root_) / kLock).string());
  if (!error) fs::create_directories(folder_, error);
  if (error) return folder_ + ": " + error.message();
  lock_ = FileLock::take(path);
  return lock_.held() ? std::string() : path + ": " + std::strerror(errno);
}

std::string Recovery::journal_path(uint64_t document) const {
  return (fs::path(folder_) / (std::to_string(document) + kJournal)).string();
}

std::vector<LeftWork> Recovery::left_behind() {
  const std::lock_guard mine(mutex_);
  std::vector<LeftWork> found;
  std::error_code error;
  if (!fs::is_directory(root_, error)) return found;
  const FileLock all = FileLock::wait_for((fs::path(root_) / kLock).string());
  for (const fs::path& folder : sessions_in(root_)) {
    if (folder == folder_) continue;
    FileLock& lock = crashed_[folder.string()];
    if (!lock.held()) lock = FileLock::take((folder / kLock).string());
    if (!lock.held()) continue;  // it lives
    for (const fs::path& journal : journals_in(folder)) {
      if (!fs::is_regular_file(journal, error)) continue;  // not ours
      ReadEntry read = read_entry(journal.string());
      if (holds_nothing(journal) || (read.last && stands_saved(*read.last))) {
        fs::remove(journal, error);
        continue;
      }
      found.push_back(LeftWork{journal.string(), read.last ? read.last->note : DocumentNote{},
                               facts_of(journal.string()).modified_ns, std::move(read.problem)});
    }
    remove_session(folder);
  }
  std::erase_if(crashed_, [](const auto& session) { return !session.second.held(); });
  std::sort(found.begin(), found.end(), [](const LeftWork& a, const LeftWork& b) {
    return a.problem.empty() != b.problem.empty() ? a.problem.empty() : a.written_ns > b.written_ns;
  });
  return found;
}

void Recovery::discard(const LeftWork& left) {
  const std::lock_guard mine(mutex_);
  std::error_code ignored;
  fs::remove(left.journal, ignored);
  const fs::path folder = fs::path(left.journal).parent_path();
  remove_session(folder);
  if (!fs::exists(folder, ignored)) crashed_.erase(folder.string());
}

std::optional<JournalEntry> read_left(const LeftWork& left) { return read_entry(left.journal).last; }

}  // namespace weftlight::session
