#pragma once
// The drafts of a folder and of those in it. Each file is read once: what it holds is kept in an index in the user's
// cache folder, by path, size and time.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "collection/draft_entry.h"

namespace weftlight::collection {

using Entries = std::vector<DraftEntry>;  // sorted by path

/// Where the indexes are kept, in the cache folder of the user.
std::string index_folder();
/// The file of a folder's index in `cache_folder`.
std::string index_file_of(const std::string& folder, const std::string& cache_folder);

/// What the index knew when the folder was last looked at; null if never, or if it is damaged. Quick.
std::shared_ptr<const Entries> known_drafts(const std::string& folder, const std::string& cache_folder);

struct FolderIndex {
  std::shared_ptr<const Entries> entries;  // never null
  std::vector<std::string> unread;         // folders that could not be read
  size_t read = 0;                         // files that were read, because they are new or have changed
  size_t left_out = 0;                     // drafts beyond kMaxIndexed
  bool stopped = false;                    // by `progress`: entries are what was known until then
};
/// Looks at all files and reads those that are new or have changed, on all cores. `so_far` is called now and then on
/// the calling thread with what is there. The index is written at the end, also when it is stopped; without a cache
/// folder (empty) there is none.
FolderIndex look_through(const std::string& folder, const std::string& cache_folder,
                         const base::TaskProgress& progress = {},
                         const std::function<void(std::shared_ptr<const Entries>)>& so_far = {});

}  // namespace weftlight::collection
