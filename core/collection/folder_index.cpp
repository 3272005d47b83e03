#include "collection/folder_index.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <unordered_map>

#include "base/hash.h"
#include "base/loops.h"
#include "base/text.h"
#include "base/user_folders.h"
#include "base/whole_files.h"
#include "collection/index_text.h"
#include "platform/file.h"
#include "platform/files_below.h"
#include "wif/other_formats.h"

namespace weftlight::collection {

using base::TaskProgress, base::arg, base::fill, base::for_each_job, base::read_file, base::tr;

namespace {

namespace fs = std::filesystem;
constexpr uint64_t kMaxIndexBytes = uint64_t{1} << 30;
constexpr uint64_t kMaxBytes = uint64_t{1} << 26;  // of a draft; larger ones are listed as unreadable
constexpr size_t kChunk = 128;                     // files between two looks at the request to stop
constexpr size_t kShownAfter = 2048;               // files, while a folder is looked through for the first time
constexpr size_t kMaxIndexes = 40;                 // in the cache; the oldest are removed

std::string whole_path(const std::string& folder) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(folder, error);
  return error ? folder : whole.string();
}

std::vector<std::string> draft_names(std::vector<std::string> files) {
  std::erase_if(files, [](const std::string& file) { return !wif::is_draft_name(file); });
  return files;
}

using Known = std::unordered_map<std::string_view, const DraftEntry*>;

Known by_path(const Entries& entries) {
  Known known;
  known.reserve(entries.size());
  for (const DraftEntry& e : entries) known.emplace(e.path, &e);
  return known;
}

/// The entry as it is known, or as the file says now. `read`: it did.
DraftEntry entry_of_file(const std::string& path, const Known& known, const TaskProgress& progress, bool& read) {
  const platform::FileFacts facts = platform::file_facts(path);
  const auto found = known.find(path);
  if (found != known.end() && found->second->size == facts.size && found->second->modified_ns == facts.modified_ns)
    return *found->second;
  read = true;
  DraftEntry file;
  file.path = path, file.size = facts.size, file.modified_ns = facts.modified_ns;
  const base::Result<std::string> bytes = read_file(path, kMaxBytes, progress.stop());
  return bytes ? entry_of(std::move(file), *bytes) : with_search_text(std::move(file));
}

void keep_index(const std::string& file, const Entries& entries) {
  std::error_code ignored;  // without a cache the folder is looked through again next time
  fs::create_directories(fs::path(file).parent_path(), ignored);
  if (base::write_file_atomically(file, index_text(entries)))
    base::keep_newest(fs::path(file).parent_path().string(), ".drafts", kMaxIndexes, file);
}

/// Where it was stopped: what was looked at, and behind it what was known.
void add_known_behind(Entries& entries, const Entries& known) {
  const auto behind =
      entries.empty() ? known.begin() : std::ranges::upper_bound(known, entries.back().path, {}, &DraftEntry::path);
  entries.insert(entries.end(), behind, known.end());
}

}  // namespace

std::string index_folder() { return base::cache_folder() + "/folders"; }

std::string index_file_of(const std::string& folder, const std::string& cache_folder) {
  char name[32];
  std::snprintf(name, sizeof name, "%016llx.drafts",
                static_cast<unsigned long long>(base::content_hash(whole_path(folder))));
  return cache_folder + "/" + name;
}

std::shared_ptr<const Entries> known_drafts(const std::string& folder, const std::string& cache_folder) {
  if (cache_folder.empty()) return {};
  const base::Result<std::string> text = read_file(index_file_of(folder, cache_folder), kMaxIndexBytes);
  auto entries = text ? entries_from(*text) : std::nullopt;
  return entries ? std::make_shared<const Entries>(std::move(*entries)) : nullptr;
}

FolderIndex look_through(const std::string& folder, const std::string& cache_folder, const TaskProgress& progress,
                         const std::function<void(std::shared_ptr<const Entries>)>& so_far) {
  const auto before = known_drafts(folder, cache_folder);
  if (before && so_far) so_far(before);
  static const Entries kNone;
  const Known known = by_path(before ? *before : kNone);
  FolderIndex out;
  platform::FilesBelow below = platform::files_below(whole_path(folder));
  out.unread = std::move(below.unread);
  std::vector<std::string> paths = draft_names(std::move(below.files));
  if (paths.size() > kMaxIndexed) out.left_out = paths.size() - kMaxIndexed, paths.resize(kMaxIndexed);
  auto entries = std::make_shared<Entries>();
  size_t shown = 0;
  for (size_t first = 0; first < paths.size() && !progress.stopped(); first += kChunk) {
    const size_t count = std::min(kChunk, paths.size() - first);
    std::vector<DraftEntry> made(count);
    std::vector<char> read(count, 0);
    for_each_job(static_cast<int>(count), [&](int i) {
      const auto at = static_cast<size_t>(i);
      bool anew = false;
      made[at] = entry_of_file(paths[first + at], known, progress, anew);
      read[at] = anew ? 1 : 0;
    });
    if (progress.stopped()) break;  // the last ones may not have been read to their ends
    std::ranges::move(made, std::back_inserter(*entries));
    out.read += static_cast<size_t>(std::ranges::count(read, 1));
    progress.report(static_cast<float>(first + count) / static_cast<float>(paths.size()),
                    fill(tr("{done} of {all} drafts"), arg("done", first + count), arg("all", paths.size())));
    if (!before && so_far && entries->size() >= shown + kShownAfter) {
      shown = entries->size();
      so_far(std::make_shared<const Entries>(*entries));
    }
  }
  out.stopped = progress.stopped();
  if (out.stopped && before) add_known_behind(*entries, *before);
  const bool changed = !before || out.read > 0 || before->size() != entries->size();
  if (changed && !cache_folder.empty()) keep_index(index_file_of(folder, cache_folder), *entries);
  out.entries = std::move(entries);
  return out;
}

}  // namespace weftlight::collection
