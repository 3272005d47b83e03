#include "session/files/file_identity.h"

#include <filesystem>

#include "platform/file.h"
#include "wif/wif.h"

namespace weftlight::session {

using base::content_hash, base::read_file;

namespace fs = std::filesystem;

FileIdentity facts_of(const std::string& path) {
  const platform::FileFacts facts = platform::file_facts(path);
  if (facts.kind != platform::FileKind::kRegular) return {};
  FileIdentity id;
  id.there = true;
  id.device = facts.volume;
  id.inode = facts.number;
  id.size = facts.size;
  id.modified_ns = facts.modified_ns;
  return id;
}

FileIdentity identify(const std::string& path, std::string_view bytes) {
  FileIdentity id = facts_of(path);
  if (id.there) id.hash = content_hash(bytes);
  return id;
}

FileIdentity identify(const std::string& path) {
  if (!facts_of(path).there) return {};
  const base::Result<std::string> bytes = read_file(path);
  return bytes ? identify(path, *bytes) : FileIdentity{};
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

bool is_one_file(const FileIdentity& a, const FileIdentity& b) {
  // With the time, since a file system gives the number of a removed file to another one.
  return a.there && b.there && a.device == b.device && a.inode == b.inode && a.size == b.size &&
         a.modified_ns == b.modified_ns;
}

bool is_same_name(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code error;
  const fs::path full_a = fs::absolute(a, error), full_b = fs::absolute(b, error);
  return full_a.lexically_normal() == full_b.lexically_normal();
}

}  // namespace weftlight::session
