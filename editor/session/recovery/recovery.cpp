#include "session/recovery/recovery.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/text.h"
#include "base/user_folders.h"
#include "platform/durable_file.h"
#include "platform/file.h"
#include "platform/unique_name.h"
#include "wif/wif.h"

namespace weftlight::session {

using base::content_hash, base::read_file, base::tr;
using platform::FileLock;

namespace {

namespace fs = std::filesystem;
constexpr const char* kLock = "lock";
constexpr const char* kMaking = ".making";  // ending of a folder that has no lock yet
constexpr const char* kJournal = ".journal";

std::vector<fs::path> sessions_in(const fs::path& root) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const std::string& name : platform::names_in(root.string(), error))
    if (platform::is_unique_name(name) && fs::is_directory(root / name, error)) found.push_back(root / name);
  return found;
}

/// "NUMBER.journal", and not what is written to replace one.
bool is_journal(const fs::path& name) {
  return name.extension() == kJournal && name.stem().string().find_first_not_of("0123456789") == std::string::npos;
}

std::vector<fs::path> journals_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const std::string& name : platform::names_in(folder.string(), error))
    if (is_journal(name)) found.push_back(folder / name);
  return found;
}

base::Result<JournalEntry> last_entry(const std::string& journal) {
  const auto unreadable = [&](std::string why) {
    return base::failure(base::ErrorKind::kInput, std::move(why), journal);
  };
  if (facts_of(journal).size > 2 * kMaxJournalText) return unreadable(tr("it is too large to be a journal"));
  const base::Result<std::string> bytes = read_file(journal);
  if (!bytes) return failed(bytes);
  std::optional<JournalEntry> last = read_journal(*bytes);
  if (!last) return unreadable(tr("it is damaged before the end of its first entry"));
  return std::move(*last);
}

/// An empty journal: its session ended before it wrote to it.
bool holds_nothing(const fs::path& journal) {
  std::error_code error;
  return fs::is_regular_file(journal, error) && fs::file_size(journal, error) == 0 && !error;
}

/// True if the session saved the file but ended before it removed the journal.
bool stands_saved(const JournalEntry& last) {
  if (last.note.path.empty() || facts_of(last.note.path).size != last.text.size()) return false;
  return identify(last.note.path).hash == content_hash(last.text);
}

/// Drafts are nobody else's business, nor are their names.
std::error_code keep_to_user(const fs::path& folder) {
  std::error_code error;
  fs::permissions(folder, fs::perms::owner_all, error);
  // Where a file system has no such rights, the folder is as any other.
  return error == std::errc::operation_not_permitted || error == std::errc::not_supported ? std::error_code() : error;
}

/// A folder with its lock appears at once, under its own name: one without would be taken for that of a crashed
/// session. Nobody is waited for. The lock is not held if that failed.
FileLock make_session(const fs::path& folder, std::error_code& error) {
  constexpr int kMaxTries = 200;  // another session may clear the folder away before it is locked
  if (fs::is_directory(folder, error)) return FileLock::take((folder / kLock).string());  // only its lock was removed
  fs::path making;
  FileLock lock;
  for (int i = 0; i < kMaxTries; ++i) {
    // Each time another one: on a busy machine it may take long until the last one is cleared away.
    making = folder.parent_path() / (platform::unique_name() + kMaking);
    fs::create_directories(making, error);
    if (!error) error = keep_to_user(making);
    if (error == std::errc::no_such_file_or_directory) continue;  // cleared away meanwhile
    if (error) return lock;
    lock = FileLock::take((making / kLock).string());
    if (lock.answer() == platform::LockAnswer::kNoLocks) break;
    if (!lock.held() || !lock.stands_at((making / kLock).string())) continue;
    fs::rename(making, folder, error);
    if (!error) platform::sync(folder.parent_path().string());
    if (!error) return lock;
  }
  platform::remove_with_contents(making.string());
  return lock;
}

/// Removes what a session left that ended before its folder was made.
void clear_half_made(const fs::path& root) {
  std::error_code error;
  for (const std::string& name : platform::names_in(root.string(), error)) {
    const fs::path at = root / name;
    if (at.extension() != kMaking || !platform::is_unique_name(at.stem().string())) continue;
    const FileLock lock = FileLock::take_existing((at / kLock).string());
    if (lock.held() && lock.stands_at((at / kLock).string())) platform::remove_with_contents(at.string());
  }
}

/// Removes the folder and its contents unless it holds a journal.
void remove_session(const fs::path& folder) {
  if (journals_in(folder).empty()) platform::remove_with_contents(folder.string());
}

}  // namespace

std::string recovery_folder() { return (fs::path(base::state_folder()) / "recovery").string(); }

Recovery::Recovery(std::string root)
    : root_(std::move(root)), folder_((fs::path(root_) / platform::unique_name()).string()) {}

Recovery::~Recovery() {
  if (lock_.held()) remove_session(folder_);
}

base::Result<void> Recovery::open() {
  const std::lock_guard lock(own_);
  const std::string path = (fs::path(folder_) / kLock).string();
  if (lock_.stands_at(path)) return {};
  std::error_code error;
  error = platform::make_folders(root_);
  if (!error) error = keep_to_user(root_);
  if (!error) lock_ = make_session(folder_, error);
  if (error) return base::failure(base::ErrorKind::kOutput, error.message(), folder_);
  if (!lock_.held()) return base::failure(base::ErrorKind::kOutput, lock_.cause().message(), path);
  return {};
}

std::string Recovery::journal_path(uint64_t document) const {
  return (fs::path(folder_) / (std::to_string(document) + kJournal)).string();
}

std::vector<LeftWork> Recovery::left_behind() {
  const std::lock_guard hold(others_);
  std::vector<LeftWork> found;
  std::error_code error;
  if (!fs::is_directory(root_, error)) return found;
  clear_half_made(root_);
  for (const fs::path& folder : sessions_in(root_)) {
    if (folder == folder_) continue;
    FileLock& lock = crashed_[folder.string()];
    if (!lock.held()) lock = FileLock::take((folder / kLock).string());
    if (!lock.held()) continue;  // the session is running
    for (const fs::path& journal : journals_in(folder)) {
      if (!fs::is_regular_file(journal, error)) continue;  // not a journal of ours
      const base::Result<JournalEntry> last = last_entry(journal.string());
      if (holds_nothing(journal) || (last && stands_saved(*last))) {
        fs::remove(journal, error);
        continue;
      }
      const auto note_of = [](const JournalEntry& entry) { return entry.note; };
      found.push_back(LeftWork{journal.string(), last.map(note_of), facts_of(journal.string()).modified_ns});
    }
    remove_session(folder);
  }
  std::erase_if(crashed_, [](const auto& session) { return !session.second.held(); });
  std::sort(found.begin(), found.end(), [](const LeftWork& a, const LeftWork& b) {
    return a.note.has_value() != b.note.has_value() ? a.note.has_value() : a.written_ns > b.written_ns;
  });
  return found;
}

void Recovery::discard(const LeftWork& left) {
  const std::lock_guard hold(others_);
  std::error_code ignored;
  fs::remove(left.journal, ignored);
  const fs::path folder = fs::path(left.journal).parent_path();
  remove_session(folder);
  if (!fs::exists(folder, ignored)) crashed_.erase(folder.string());
}

base::Result<JournalEntry> read_left(const LeftWork& left) { return last_entry(left.journal); }

}  // namespace weftlight::session
