#pragma once
// Whose the files of a folder are, and how a finished set comes into it: only what an earlier set of the
// same draft and target lists as its own is replaced or taken away; the rest is never touched.

#include <filesystem>
#include <string>
#include <vector>

#include "platform/file_lock.h"
#include "texture_set/names.h"

namespace weftlight::texture_set {

/// What a set is of. `draft`: the way from the set's folder to the draft's file; empty: never saved.
struct SetIdentity {
  std::string draft, source, target;
};
std::string draft_from(const std::filesystem::path& folder, const std::string& draft_path);

/// Empty where a set may be written, else what is there instead and what to do. A folder that does not exist, an empty
/// one and one that holds a set of the same identity are free.
std::string in_the_way(const std::filesystem::path& folder, const SetIdentity& identity);

/// A folder that is being filled. Its lock says that its owner lives.
struct Staging {
  std::filesystem::path folder;
  platform::FileLock lock;
};
/// A new, empty folder beside `folder`. Those of the same set whose owner is no more go: those alone whose lock can be
/// had. Where there are no locks all stay, however old, and none is ever taken for a dead one's. No folder: `problem`
/// says why.
Staging make_staging(const std::filesystem::path& folder, std::string& problem);

/// Moves the files of `made` into `folder` and removes `made`; texture_set.json, which lists them all, last. Files that
/// the set there listed and this one lacks go. A file of another's with the name of a new one is refused, unless
/// `force`. Sets that are finished at once come one after the other, each whole. Empty: done; else what went wrong.
std::string put_in_place(Staging made, const std::filesystem::path& folder, const SetIdentity& identity, bool force);

/// True where a set made of the same stands whole.
bool is_complete(const std::filesystem::path& folder, const std::string& key);
/// The files of the set that stands there, its list among them; none: there is none.
std::vector<std::string> listed_files(const std::filesystem::path& folder);
/// True where that set has its archive beside the folder.
bool lists_archive(const std::filesystem::path& folder);

}  // namespace weftlight::texture_set
