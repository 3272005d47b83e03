#include "texture_set/set_folder.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "base/files.h"

namespace weftlight::texture_set {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kList = "texture_set.json";
constexpr const char* kFormat = "weftlight texture set";
constexpr const char* kPart = ".part-";                    // then the process and a number: base/files.h
constexpr uintmax_t kLongestList = uintmax_t{16} << 20;    // bytes
constexpr const char* kStaged = ".weftlight_texture_set";  // marks a folder that is being written

/// What an earlier set says of itself. `files` are plain names within its folder.
struct Listed {
  SetIdentity identity;
  std::set<std::string> files;
};

bool plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find_first_of("/\\") == std::string::npos;
}

void take_name(Listed& out, const json& name) {
  if (name.is_string() && plain_name(name.get<std::string>())) out.files.insert(name.get<std::string>());
}

std::string text_of(const json& root, const char* key) {
  const auto at = root.find(key);
  return at != root.end() && at->is_string() ? at->get<std::string>() : std::string{};
}

std::optional<json> list_in(const fs::path& folder) {
  std::error_code ec;
  const fs::path path = folder / kList;
  if (!fs::is_regular_file(path, ec) || fs::file_size(path, ec) > kLongestList) return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  const json root = json::parse(in, nullptr, false);
  if (!root.is_object() || text_of(root, "format") != kFormat) return std::nullopt;
  return root;
}

std::optional<Listed> listed_in(const fs::path& folder) {
  const std::optional<json> root = list_in(folder);
  if (!root) return std::nullopt;
  Listed out{{text_of(*root, "draft"), text_of(*root, "source"), text_of(*root, "target")}, {}};
  if (const auto files = root->find("files"); files != root->end() && files->is_array()) {
    for (const json& name : *files) take_name(out, name);
  }
  return out;
}

bool same(const SetIdentity& a, const SetIdentity& b) {
  return a.draft == b.draft && a.source == b.source && a.target == b.target;
}

std::string words(const SetIdentity& of) { return "a set of " + of.source + " for " + of.target; }

/// The process is gone. One of another user still lives.
bool dead(const std::string& process) {
  const long id = std::atol(process.c_str());
  return id > 0 && ::kill(static_cast<pid_t>(id), 0) != 0 && errno == ESRCH;
}

void remove_stale_files(const fs::path& folder) {
  std::error_code ec;
  const fs::path beside = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  const std::string start = folder.stem().string() + kPart;
  std::vector<fs::path> gone;
  for (const fs::directory_entry& entry : fs::directory_iterator(beside, ec)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(start) || !entry.is_directory(ec) || entry.is_symlink(ec)) continue;
    if (fs::exists(entry.path() / kStaged, ec) && dead(name.substr(start.size()))) gone.push_back(entry.path());
  }
  for (const fs::path& path : gone) fs::remove_all(path, ec);
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> out;
  std::error_code ec;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ec)) {
    const std::string name = entry.path().filename().string();
    if (name != kList && name != kStaged) out.push_back(name);
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// The list of both sets, so that a program killed between leaves no file that the next one does not know as its own.
std::string list_both(const fs::path& made, const fs::path& folder, const std::set<std::string>& old) {
  std::optional<json> root = list_in(made);
  if (!root) return (made / kList).string() + ": is not there";
  std::set<std::string> all = old;
  for (const std::string& name : names_in(made)) all.insert(name);
  (*root)["files"] = all;
  return write_file_atomically((folder / kList).string(),
                               root->dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

std::string moved(const fs::path& from, const fs::path& to) {
  std::error_code ec;
  fs::rename(from, to, ec);
  return ec ? to.string() + ": " + ec.message() : std::string{};
}

std::string merge(const fs::path& made, const fs::path& folder, const std::set<std::string>& old) {
  if (std::string problem = list_both(made, folder, old); !problem.empty()) return problem;
  const std::vector<std::string> fresh = names_in(made);
  for (const std::string& name : fresh) {
    if (std::string problem = moved(made / name, folder / name); !problem.empty()) return problem;
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

std::string in_the_way(const fs::path& folder, const SetIdentity& identity) {
  std::error_code ec;
  if (!fs::exists(fs::symlink_status(folder, ec))) return {};
  if (!fs::is_directory(folder, ec)) return folder.string() + ": is a file; choose another folder";
  if (fs::is_empty(folder, ec)) return {};
  const std::optional<Listed> there = listed_in(folder);
  if (!there) return folder.string() + ": there are other files; choose another folder, or --force to write among them";
  if (same(there->identity, identity)) return {};
  const bool namesake = there->identity.source == identity.source && there->identity.target == identity.target;
  return folder.string() + ": holds " + words(there->identity) + (namesake ? " in another place" : "") +
         "; choose another folder, or --force to write among them";
}

fs::path make_staging(const fs::path& folder, std::string& problem) {
  std::error_code ec;
  if (folder.has_parent_path()) fs::create_directories(folder.parent_path(), ec);
  remove_stale_files(folder);
  const fs::path made = temporary_beside(folder.string());
  if (!fs::create_directory(made, ec)) {
    problem = folder.string() + ": cannot be made: " + ec.message();
    return {};
  }
  std::ofstream(made / kStaged).flush();
  return made;
}

std::string put_in_place(const fs::path& made, const fs::path& folder, const SetIdentity& identity, bool force) {
  std::error_code ec;
  fs::remove(made / kStaged, ec);
  if (!fs::exists(folder, ec) || fs::is_empty(folder, ec)) return moved(made, folder);
  const std::optional<Listed> there = listed_in(folder);
  const bool ours = there && same(there->identity, identity);
  const std::set<std::string> old = ours ? there->files : std::set<std::string>{};
  for (const std::string& name : names_in(made)) {
    const fs::path at = folder / name;
    if (fs::is_directory(at, ec)) return at.string() + ": is a folder; choose another folder for the set";
    if (!force && fs::exists(fs::symlink_status(at, ec)) && !old.contains(name))
      return at.string() + ": is not of the set that is there; move it away, or --force to replace it";
  }
  std::string problem = merge(made, folder, old);
  fs::remove_all(made, ec);
  return problem;
}

std::vector<std::string> listed_files(const fs::path& folder) {
  const std::optional<Listed> there = listed_in(folder);
  if (!there) return {};
  std::set<std::string> all = there->files;
  all.insert(kList);
  return {all.begin(), all.end()};
}

bool is_complete(const fs::path& folder, const std::string& key) {
  const std::optional<json> root = list_in(folder);
  if (!root || key.empty() || text_of(*root, "key") != key) return false;
  std::error_code ec;
  const std::vector<std::string> files = listed_files(folder);
  return std::all_of(files.begin(), files.end(), [&](const std::string& f) { return fs::exists(folder / f, ec); });
}

bool lists_archive(const fs::path& folder) {
  const std::optional<json> root = list_in(folder);
  return root && root->value("archived", false);
}

}  // namespace weftlight::texture_set
