#include "session/files/own_output.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <utility>

#include "base/file_names.h"
#include "base/json.h"
#include "base/text.h"
#include "platform/durable_file.h"
#include "session/files/file_identity.h"
#include "wif/wif.h"

namespace weftlight::session {

using base::content_hash, base::mark, base::read_file, base::same_file, base::tr, base::write_file_atomically;

namespace {

namespace fs = std::filesystem;

bool is_one_of(const std::string& path, const std::vector<std::string>& drafts) {
  return std::ranges::any_of(drafts, [&](const std::string& draft) { return same_file(path, draft); });
}

/// True if nothing is lost: no file, an empty one, or a device such as /dev/null.
bool is_free(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return true;
  return fs::is_regular_file(path, error) ? fs::file_size(path, error) == 0 : !fs::is_directory(path, error);
}

base::Failure refused(const std::string& path, std::string why) {
  return base::failure(base::ErrorKind::kUsage, std::move(why), path);
}

constexpr uint64_t kLongestMap = uint64_t{16} << 20;  // bytes
constexpr const char* kIsTheDraft = mark("it is the draft to open; give another file");

/// The hashes in a record; empty if there is no record.
std::vector<uint64_t> hashes_in(const std::string& record) {
  std::vector<uint64_t> hashes;
  std::istringstream lines(read_file(record).value_or(""));
  for (uint64_t hash = 0; lines >> std::hex >> hash;) hashes.push_back(hash);
  return hashes;
}

}  // namespace

LiveExport::LiveExport(std::string path, const std::string& state_folder) : path_(std::move(path)) {
  std::error_code error;
  const fs::path full = fs::weakly_canonical(path_, error);
  std::ostringstream name;
  name << std::hex << content_hash(full.string());
  record_ = (fs::path(state_folder) / "live_exports" / name.str()).string();
}

base::Result<void> LiveExport::check(const std::vector<std::string>& drafts) const {
  if (is_one_of(path_, drafts)) return refused(path_, tr(kIsTheDraft));
  if (is_free(path_)) return {};
  std::error_code error;
  if (fs::is_directory(path_, error)) return refused(path_, tr("it is a folder; give a file"));
  const std::vector<uint64_t> own = hashes_in(record_);
  const uint64_t there = identify(path_).hash;
  if (std::find(own.begin(), own.end(), there) != own.end()) return {};
  // A copy of an opened draft: writing it again changes nothing.
  for (const std::string& draft : drafts)
    if (there == identify(draft).hash) return {};
  return refused(path_, tr("another program's file already exists; remove it or give another name"));
}

base::Result<void> LiveExport::write(std::string_view bytes) {
  const uint64_t now = content_hash(bytes);
  // Recorded before the write, together with the present hash: whenever the process ends, one of the two is right.
  platform::make_folders(fs::path(record_).parent_path().string());  // an error is that of the record
  std::ostringstream record;
  record << std::hex << now << "\n" << (last_ != 0 ? last_ : identify(path_).hash) << "\n";
  write_file_atomically(record_, record.str());
  base::Result<void> written = write_file_atomically(path_, bytes);
  if (written) last_ = now;
  return written;
}

base::Result<void> check_ui_map(const std::string& path, const std::vector<std::string>& drafts) {
  if (is_one_of(path, drafts)) return refused(path, tr(kIsTheDraft));
  if (is_free(path)) return {};
  const nlohmann::json json = base::read_json(read_file(path, kLongestMap).value_or(""));
  if (json.is_object() && json.contains("frame") && json.contains("controls") && json.contains("grids")) return {};
  return refused(path, tr("the existing file is not a map of the window; remove it or give another name"));
}

}  // namespace weftlight::session
