#include "texture_set/set_folder.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <optional>
#include <set>
#include <utility>

#include "base/hash.h"
#include "base/json.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "platform/durable_file.h"
#include "platform/file.h"
#include "platform/removed_at_end.h"
#include "platform/unique_name.h"

namespace weftlight::texture_set {

using base::arg, base::fill, base::tr, base::write_file_atomically;
using platform::FileLock, platform::LockAnswer, platform::RemovedAtEnd;

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kList = "texture_set.json";
constexpr const char* kFormat = "weftlight texture set";
constexpr uintmax_t kLongestList = uintmax_t{16} << 20;    // bytes
constexpr const char* kStaged = ".weftlight_texture_set";  // in a folder that is being written; its owner locks it
constexpr const char* kPlaceLock = ".part-lock";           // beside a folder into which a set is being put

/// The list of an earlier set. `files` are plain names within its folder.
struct Listed {
  SetIdentity identity;
  std::set<std::string> files;
};

bool plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find_first_of("/\\") == std::string::npos;
}

void add_name(Listed& out, const json& name) {
  if (name.is_string() && plain_name(name.get<std::string>())) out.files.insert(name.get<std::string>());
}

std::string text_of(const json& root, const char* key) {
  const auto at = root.find(key);
  return at != root.end() && at->is_string() ? at->get<std::string>() : std::string{};
}

std::optional<json> list_in(const fs::path& folder) {
  std::error_code ec;
  const fs::path path = folder / kList;
  if (!fs::is_regular_file(path, ec)) return std::nullopt;
  json root = base::read_json(base::read_file(path.string(), kLongestList).value_or(""));
  if (!root.is_object() || text_of(root, "format") != kFormat) return std::nullopt;
  return root;
}

std::optional<Listed> listed_in(const fs::path& folder) {
  const std::optional<json> root = list_in(folder);
  if (!root) return std::nullopt;
  Listed out{{text_of(*root, "draft"), text_of(*root, "source"), text_of(*root, "target")}, {}};
  if (const auto files = root->find("files"); files != root->end() && files->is_array()) {
    for (const json& name : *files) add_name(out, name);
  }
  return out;
}

bool same(const SetIdentity& a, const SetIdentity& b) {
  return a.draft == b.draft && a.source == b.source && a.target == b.target;
}

/// The mark goes last, so that what is left of a removal that was cut short is known again.
void remove_staged(const fs::path& made) {
  std::error_code ec;
  for (const std::string& name : platform::names_in(made.string(), ec))
    if (name != kStaged) platform::remove_with_contents((made / name).string());
  platform::remove_with_contents(made.string());
}

/// The lock of a folder whose owner ended while it was filled; of any other none is held.
FileLock lock_of_stale(const fs::path& made) {
  std::error_code ec;
  if (!fs::is_directory(fs::symlink_status(made, ec))) return {};
  const std::string mark = (made / kStaged).string();
  FileLock lock = FileLock::take_existing(mark);
  // Not where it was put in place meanwhile.
  return lock.held() && lock.stands_at(mark) ? std::move(lock) : FileLock();
}

/// Those beside `folder` that were to become it, and all within it, of sets for several targets.
void remove_stale_files(const fs::path& folder) {
  std::error_code ec;
  const fs::path beside = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  std::vector<fs::path> found;
  for (const std::string& name : platform::names_in(beside.string(), ec))
    if (platform::is_temporary_of(folder.string(), name)) found.push_back(beside / name);
  for (const std::string& name : platform::names_in(folder.string(), ec))
    if (platform::is_temporary(name)) found.push_back(folder / name);
  for (const fs::path& made : found)
    if (const FileLock lock = lock_of_stale(made); lock.held()) remove_staged(made);
}

/// Held by who puts a set into a folder; it is removed with the lock still held.
FileLock lock_place(const std::string& path) {
  for (;;) {
    FileLock lock = FileLock::wait_for(path);
    if (!lock.held() || lock.stands_at(path)) return lock;
  }
}

/// Sorted, without the list.
std::vector<std::string> files_in(const fs::path& folder) {
  std::error_code ec;
  std::vector<std::string> out = platform::names_in(folder.string(), ec);
  std::erase_if(out, [](const std::string& name) { return name == kList || name == kStaged; });
  std::sort(out.begin(), out.end());
  return out;
}

bool holds_nothing(const fs::path& folder) {
  std::error_code ec;
  return platform::names_in(folder.string(), ec).empty() && !ec;
}

/// Nothing but what was left of sets that were cut short, which make_staging() removes.
bool holds_only_stale(const fs::path& folder) {
  std::error_code ec;
  const std::vector<std::string> names = platform::names_in(folder.string(), ec);
  return !ec && std::ranges::all_of(names, [&folder](const std::string& name) {
    return platform::is_temporary(name) && lock_of_stale(folder / name).held();
  });
}

base::Failure not_written(const fs::path& file, std::string text) {
  return base::failure(base::ErrorKind::kOutput, std::move(text), file.string());
}

/// Writes a list of the files of both sets, so that after a crash in between the next export still owns all of them.
base::Result<void> list_both(const fs::path& made, const fs::path& folder, const std::set<std::string>& old) {
  std::optional<json> root = list_in(made);
  if (!root) return not_written(made / kList, tr("is missing"));
  std::set<std::string> all = old;
  for (const std::string& name : files_in(made)) all.insert(name);
  (*root)["files"] = all;
  return write_file_atomically((folder / kList).string(),
                               root->dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

base::Result<void> moved(const fs::path& from, const fs::path& to) {
  const std::error_code ec = platform::put_in_place(from.string(), to.string());
  if (ec) return not_written(to, ec.message());
  return {};
}

base::Result<void> merge(const fs::path& made, const fs::path& folder, const std::set<std::string>& old) {
  if (base::Result<void> listed = list_both(made, folder, old); !listed) return listed;
  const std::vector<std::string> fresh = files_in(made);
  for (const std::string& name : fresh) {
    if (base::Result<void> there = moved(made / name, folder / name); !there) return there;
  }
  std::error_code ec;
  for (const std::string& name : old) {
    const bool kept = std::binary_search(fresh.begin(), fresh.end(), name) || name == kList;
    if (!kept && fs::is_regular_file(fs::symlink_status(folder / name, ec))) fs::remove(folder / name, ec);
  }
  return moved(made / kList, folder / kList);
}

}  // namespace

std::string draft_from(const fs::path& folder, const std::string& draft_path) {
  if (draft_path.empty()) return {};
  std::error_code ec;
  const fs::path from = fs::weakly_canonical(fs::absolute(folder, ec), ec);
  const fs::path to = fs::weakly_canonical(fs::absolute(draft_path, ec), ec);
  return to.lexically_relative(from).generic_string();
}

base::Result<void> check_place(const fs::path& folder, const SetIdentity& identity) {
  std::error_code ec;
  if (!fs::exists(fs::symlink_status(folder, ec))) return {};
  if (!fs::is_directory(folder, ec)) return not_written(folder, tr("is a file"));
  if (holds_only_stale(folder)) return {};
  const std::optional<Listed> there = listed_in(folder);
  if (!there) return not_written(folder, tr("there are other files"));
  if (same(there->identity, identity)) return {};
  const bool namesake = there->identity.source == identity.source && there->identity.target == identity.target;
  const char* form =
      namesake ? tr("holds a set of another {source} for {target}") : tr("holds a set of {source} for {target}");
  return not_written(folder, fill(form, arg("source", there->identity.source), arg("target", there->identity.target)));
}

base::Result<void> check_place_with_remedy(const fs::path& folder, const SetIdentity& identity) {
  base::Result<void> place = check_place(folder, identity);
  if (place) return place;
  std::error_code ec;
  const char* form = fs::is_directory(folder, ec)
                         ? tr("{problem}; choose another folder, or --force to write among them")
                         : tr("{problem}; choose another folder");
  place.error().text = fill(form, arg("problem", place.error().text));
  return place;
}

base::Result<Staging> make_staging(const fs::path& folder) {
  constexpr int kMaxTries = 10;
  std::error_code ec;
  if (folder.has_parent_path()) fs::create_directories(folder.parent_path(), ec);
  remove_stale_files(folder);
  for (int i = 0; i < kMaxTries; ++i) {
    std::string name = platform::temporary_beside(folder.string());
    Staging made{name, {}, {}};
    if (!fs::create_directory(made.folder, ec))
      return not_written(folder, fill(tr("the folder cannot be created: {cause}"), arg("cause", ec.message())));
    RemovedAtEnd removed(std::move(name));
    const std::string mark = (made.folder / kStaged).string();
    made.lock = FileLock::take(mark);
    const bool locks = made.lock.answer() != LockAnswer::kNoLocks;
    // Without its mark nobody takes it for a dead one's.
    if (!locks) fs::remove(mark, ec);
    if (!locks || (made.lock.held() && made.lock.stands_at(mark))) {
      made.name = removed.keep();
      return made;
    }
    if (made.lock.answer() == LockAnswer::kNoFile && fs::is_directory(made.folder, ec))
      return not_written(mark, fill(tr("cannot be created: {cause}"), arg("cause", made.lock.cause().message())));
    // A process that removes stale folders came between the mark and its lock.
  }
  return not_written(folder, tr("the folder cannot be created: another process is removing its contents"));
}

namespace {

/// Nobody takes the folder for a dead one's any more. Windows removes a file once nobody has it open, and moves no
/// folder in which one is.
void remove_mark(Staging& made) {
  std::error_code ec;
  fs::remove(made.folder / kStaged, ec);
  made.lock = FileLock();
}

base::Result<void> put(Staging& staging, const fs::path& folder, const SetIdentity& identity, bool force) {
  const fs::path& made = staging.folder;
  std::error_code ec;
  // Another's may have come since it was asked first.
  if (!force)
    if (base::Result<void> place = check_place_with_remedy(folder, identity); !place) return place;
  remove_mark(staging);
  if (!fs::exists(folder, ec) || holds_nothing(folder)) return moved(made, folder);
  const std::optional<Listed> there = listed_in(folder);
  const bool ours = there && same(there->identity, identity);
  const std::set<std::string> old = ours ? there->files : std::set<std::string>{};
  for (const std::string& name : files_in(made)) {
    const fs::path at = folder / name;
    if (fs::is_directory(at, ec)) return not_written(at, tr("is a folder; choose another folder for the set"));
    if (!force && fs::exists(fs::symlink_status(at, ec)) && !old.contains(name))
      return not_written(at, tr("does not belong to the set in this folder; move it away, or --force to replace it"));
  }
  base::Result<void> merged = merge(made, folder, old);
  platform::remove_with_contents(made.string());
  return merged;
}

}  // namespace

base::Result<void> put_in_place(Staging made, const fs::path& folder, const SetIdentity& identity, bool force) {
  const std::string path = folder.string() + kPlaceLock;
  const FileLock one_by_one = lock_place(path);
  // While the lock is held.
  const RemovedAtEnd removed(one_by_one.held() ? path : std::string());
  return put(made, folder, identity, force);
}

std::vector<std::string> listed_files(const fs::path& folder) {
  const std::optional<Listed> there = listed_in(folder);
  if (!there) return {};
  std::set<std::string> all = there->files;
  all.insert(kList);
  return {all.begin(), all.end()};
}

FileContents contents_of(const fs::path& path) {
  constexpr size_t kBlock = size_t{1} << 16;
  std::ifstream in(path, std::ios::binary);
  std::string block(kBlock, '\0');
  FileContents out;
  uint64_t hash = base::content_hash({});
  while (in.read(block.data(), kBlock), in.gcount() > 0) {
    const auto read = static_cast<size_t>(in.gcount());
    hash = base::content_hash(std::string_view(block).substr(0, read), hash);
    out.bytes += read;
  }
  if (!in.eof()) throw fs::filesystem_error("contents of a file", path, std::make_error_code(std::errc::io_error));
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  out.hash = digits;
  return out;
}

namespace {

/// The contents that the list gives for a file; empty if it gives none.
std::optional<FileContents> listed_contents(const json& root, const std::string& file) {
  const auto all = root.find("contents");
  if (all == root.end() || !all->is_object()) return std::nullopt;
  const auto one = all->find(file);
  if (one == all->end() || !one->is_object()) return std::nullopt;
  const auto bytes = one->find("bytes");
  if (bytes == one->end() || !bytes->is_number_unsigned()) return std::nullopt;
  return FileContents{bytes->get<uint64_t>(), text_of(*one, "fnv1a")};
}

}  // namespace

bool is_complete(const fs::path& folder, const std::string& key) {
  const std::optional<json> root = list_in(folder);
  if (!root || key.empty() || text_of(*root, "key") != key) return false;
  std::vector<std::string> files = listed_files(folder);
  std::erase(files, kList);
  const auto whole = [&](const std::string& file, bool all_bytes) {
    const std::optional<FileContents> wanted = listed_contents(*root, file);
    std::error_code ec;
    if (!wanted || !fs::is_regular_file(folder / file, ec) || fs::file_size(folder / file, ec) != wanted->bytes)
      return false;
    return !all_bytes || contents_of(folder / file) == *wanted;
  };
  // Sizes first: they tell most broken sets apart without reading a byte.
  return std::ranges::all_of(files, [&](const std::string& f) { return whole(f, false); }) &&
         std::ranges::all_of(files, [&](const std::string& f) { return whole(f, true); });
}

bool lists_archive(const fs::path& folder) {
  const std::optional<json> root = list_in(folder);
  const json archived = root ? root->value("archived", json()) : json();
  return archived.is_boolean() && archived.get<bool>();
}

}  // namespace weftlight::texture_set
