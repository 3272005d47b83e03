#pragma once
// Ownership of the files in a folder, and how a finished set is moved into it. Only files that an earlier set of the
// same draft and target lists as its own are replaced or removed; all others are never touched.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "platform/file_lock.h"

namespace weftlight::texture_set {

/// The source of a set. `draft`: relative path from the set's folder to the draft; empty: never saved.
struct SetIdentity {
  std::string draft, source, target;
};
std::string draft_from(const std::filesystem::path& folder, const std::string& draft_path);

/// Whether a set may be written here, or what is in the way. A set may be written into a folder that does not exist,
/// holds nothing but what was left of sets that were cut short, or holds a set of the same identity.
base::Result<void> check_place(const std::filesystem::path& folder, const SetIdentity& identity);
/// The same with what to do about it on the command line.
base::Result<void> check_place_with_remedy(const std::filesystem::path& folder, const SetIdentity& identity);

/// A folder that is being filled. The lock is held while its owner lives; the folder goes with its owner, before the
/// lock.
struct Staging {
  std::filesystem::path folder;
  platform::FileLock lock;
  std::string name;  // of the folder, for RemovedAtEnd
};
/// Makes an empty folder beside `folder`, and removes those of the same set whose lock can be taken: their owners have
/// ended. So it does with all in `folder`. Where the file system has no locks all stay, whatever their age.
base::Result<Staging> make_staging(const std::filesystem::path& folder);

/// Moves the files of `made` into `folder`, texture_set.json with the list of them last, and removes `made`. Files that
/// only the earlier set lists are removed. A foreign file with the name of a new one is an error, unless `force`. Sets
/// finished at the same time are put in place one after the other.
base::Result<void> put_in_place(Staging made, const std::filesystem::path& folder, const SetIdentity& identity,
                                bool force);

/// The size of a file in bytes and a hash of them, 16 hexadecimal digits; throws filesystem_error if it cannot be read.
struct FileContents {
  uint64_t bytes = 0;
  std::string hash;
  bool operator==(const FileContents&) const = default;
};
FileContents contents_of(const std::filesystem::path& path);

/// True if the folder holds a complete set with this key, and every file has the contents that its list gives.
bool is_complete(const std::filesystem::path& folder, const std::string& key);
/// The files of the set in the folder, including its list; empty if there is none.
std::vector<std::string> listed_files(const std::filesystem::path& folder);
/// True if that set has an archive beside the folder.
bool lists_archive(const std::filesystem::path& folder);

}  // namespace weftlight::texture_set
