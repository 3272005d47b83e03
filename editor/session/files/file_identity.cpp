#include "session/files/file_identity.h"

#include <sys/stat.h>

#include <filesystem>

#include "wif/wif.h"

namespace weftlight::session {
namespace fs = std::filesystem;

FileIdentity facts_of(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0 || !S_ISREG(info.st_mode)) return {};
  constexpr int64_t kNsPerS = 1'000'000'000;
#ifdef __APPLE__
  const timespec modified = info.st_mtimespec;
#else
  const timespec modified = info.st_mtim;
#endif
  FileIdentity id;
  id.there = true;
  id.device = static_cast<uint64_t>(info.st_dev);
  id.inode = static_cast<uint64_t>(info.st_ino);
  id.size = static_cast<uint64_t>(info.st_size);
  id.modified_ns = static_cast<int64_t>(modified.tv_sec) * kNsPerS + modified.tv_nsec;
  return id;
}

uint64_t content_hash(std::string_view bytes, uint64_t from) {
  for (const char c : bytes) from = (from ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return from;
}

FileIdentity identify(const std::string& path, std::string_view bytes) {
  FileIdentity id = facts_of(path);
  if (id.there) id.hash = content_hash(bytes);
  return id;
}

FileIdentity identify(const std::string& path) {
  if (!facts_of(path).there) return {};
  const FileBytes file = read_file(path);
  return file.error.empty() ? identify(path, file.bytes) : FileIdentity{};
}

FileChange changed_since(const std::string& path, FileIdentity& known) {
  FileIdentity now = facts_of(path);
  now.hash = known.hash;
  if (now == known) return FileChange::kNone;
  if (!now.there) return FileChange::kGone;
  now = identify(path);
  if (!known.there || now.size != known.size || now.hash != known.hash) return FileChange::kContent;
  known = now;
  return FileChange::kNone;
}

bool same_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const fs::path full_a = fs::weakly_canonical(a, error), full_b = fs::weakly_canonical(b, error);
  return !error && full_a == full_b;
}

}  // namespace weftlight::session
