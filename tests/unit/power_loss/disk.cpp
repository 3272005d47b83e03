#include "disk.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

namespace weftlight {
namespace {

namespace fs = std::filesystem;

Disk* g_recording = nullptr;

std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string folder_of(const std::string& path) { return fs::path(path).parent_path().string(); }
std::string name_of(const std::string& path) { return fs::path(path).filename().string(); }

}  // namespace

Disk::Disk(fs::path root) : root_(std::move(root)) {
  new_node(root_.string(), true);
  take_up(root_);
  first_.resize(folders_.size());
  for (size_t i = 0; i < folders_.size(); ++i) first_[i].is_folder = folders_[i];
  // What was there before is synced: it is linked and written, and then nothing of it is left to lose.
  for (const Call& call : calls_) {
    apply(call, first_);
    if (call.kind == Call::Kind::kData) first_[static_cast<size_t>(call.node)].synced = call.bytes;
  }
  calls_.clear();
  g_recording = this;
}

Disk::~Disk() { g_recording = nullptr; }

Disk* Disk::recording() { return g_recording; }

void Disk::take_up(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    made(entry.path().string(), entry.is_directory());
    if (entry.is_directory()) take_up(entry.path());
    else wrote(entry.path().string());
  }
}

bool Disk::holds(const std::string& path) const { return path.starts_with(root_.string()); }

int Disk::node_at(const std::string& path) const {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return -1;
  const auto found = by_number_.find({info.st_dev, info.st_ino});
  return found == by_number_.end() ? -1 : found->second;
}

/// Numbers of files are used again, so a new file is always a new node.
int Disk::new_node(const std::string& path, bool folder) {
  struct stat info {};
  ::stat(path.c_str(), &info);
  folders_.push_back(folder);
  return by_number_[{info.st_dev, info.st_ino}] = static_cast<int>(folders_.size()) - 1;
}

void Disk::link(const std::string& path, int node) {
  calls_.push_back({Call::Kind::kLink, node, node_at(folder_of(path)), 0, name_of(path), {}, {}, 0});
}

void Disk::promise(int stage) {
  const std::lock_guard hold(lock_);
  calls_.push_back({Call::Kind::kPromise, 0, 0, 0, {}, {}, {}, stage});
}

void Disk::made(const std::string& path, bool folder) { link(path, new_node(path, folder)); }

void Disk::wrote(const std::string& path) {
  if (const int node = node_at(path); node > 0)
    calls_.push_back({Call::Kind::kData, node, 0, 0, {}, {}, bytes_of(path), 0});
}

void Disk::synced(const std::string& path) {
  if (node_at(path) < 0) made(path, fs::is_directory(path));  // by a library, unseen
  const int node = node_at(path);
  if (!folders_[static_cast<size_t>(node)]) wrote(path);
  calls_.push_back({Call::Kind::kSync, node, 0, 0, {}, {}, {}, 0});
}

void Disk::about_to_go(const std::string& path) {
  struct stat info {};
  if (::lstat(path.c_str(), &info) == 0 && (info.st_nlink == 1 || S_ISDIR(info.st_mode)))
    by_number_.erase({info.st_dev, info.st_ino});
}

void Disk::about_to_rename(const std::string& from, const std::string& to) {
  about_to_go(to);
  if (node_at(from) < 0) made(from, fs::is_directory(from));
  if (!fs::is_directory(from)) wrote(from);
}

void Disk::renamed(const std::string& from, const std::string& to) {
  calls_.push_back({Call::Kind::kRename,
                    node_at(to),
                    node_at(folder_of(from)),
                    node_at(folder_of(to)),
                    name_of(from),
                    name_of(to),
                    {},
                    0});
}

void Disk::removed(const std::string& path) {
  calls_.push_back({Call::Kind::kUnlink, 0, node_at(folder_of(path)), 0, name_of(path), {}, {}, 0});
}

void Disk::apply(const Call& call, std::vector<Node>& nodes) {
  const auto names = [&](int folder) -> std::map<std::string, int>& {
    return nodes[static_cast<size_t>(folder)].names;
  };
  switch (call.kind) {
    case Call::Kind::kLink:
      names(call.folder)[call.name] = call.node;
      break;
    case Call::Kind::kUnlink:
      names(call.folder).erase(call.name);
      break;
    case Call::Kind::kRename:
      names(call.folder).erase(call.name);
      names(call.to)[call.new_name] = call.node;
      break;
    case Call::Kind::kData:
      nodes[static_cast<size_t>(call.node)].now = call.bytes;
      break;
    case Call::Kind::kSync:
      nodes[static_cast<size_t>(call.node)].synced = nodes[static_cast<size_t>(call.node)].now;
      break;
    case Call::Kind::kPromise:
      break;
  }
}

std::string Disk::bytes_after(const Node& node, Unsynced unsynced) {
  if (unsynced == Unsynced::kNone || node.now == node.synced) return node.synced;
  if (unsynced == Unsynced::kAll) return node.now;
  const size_t kept = node.now.starts_with(node.synced) ? node.synced.size() : 0;
  if (unsynced == Unsynced::kHalf) return node.now.substr(0, kept + (node.now.size() - kept) / 2);
  return node.now.substr(0, kept) + std::string(node.now.size() - kept, '\0');
}

void Disk::list(const std::vector<Node>& nodes, int folder, const std::string& path, Unsynced unsynced, Tree& tree) {
  for (const auto& [name, at] : nodes[static_cast<size_t>(folder)].names) {
    const Node& node = nodes[static_cast<size_t>(at)];
    const std::string inner = path + name;
    if (!node.is_folder) tree[inner] = bytes_after(node, unsynced);
    else if (tree.emplace(inner + "/", "").second) list(nodes, at, inner + "/", unsynced, tree);
  }
}

size_t Disk::after_each_crash(const std::function<void(int promised)>& check) {
  g_recording = nullptr;
  std::set<std::pair<Tree, int>> seen;
  int promised = 0;
  const auto see = [&](std::vector<Node> nodes, const std::vector<Call>& pending, const auto& kept) {
    for (size_t i = 0; i < pending.size(); ++i)
      if (kept(i)) apply(pending[i], nodes);
    for (const Unsynced unsynced : {Unsynced::kNone, Unsynced::kHalf, Unsynced::kZeros, Unsynced::kAll}) {
      Tree tree;
      list(nodes, 0, "", unsynced, tree);
      seen.emplace(std::move(tree), promised);
    }
  };
  std::vector<Node> nodes = first_;  // with the names that are synced
  nodes.resize(folders_.size());
  for (size_t i = 0; i < folders_.size(); ++i) nodes[i].is_folder = folders_[i];
  std::vector<Call> pending;  // calls for names, not synced
  const auto cut = [&] {
    const size_t n = pending.size();
    for (size_t k = 0; k <= n; ++k) see(nodes, pending, [&](size_t i) { return i < k; });
    for (size_t k = 0; k < n; ++k) see(nodes, pending, [&](size_t i) { return i == k; });
    for (size_t k = 0; k < n; ++k) see(nodes, pending, [&](size_t i) { return i != k; });
  };
  cut();
  for (const Call& call : calls_) {
    const bool of_names =
        call.kind == Call::Kind::kLink || call.kind == Call::Kind::kUnlink || call.kind == Call::Kind::kRename;
    if (of_names) pending.push_back(call);
    else apply(call, nodes);
    if (call.kind == Call::Kind::kPromise) promised = call.stage;
    if (call.kind == Call::Kind::kSync && folders_[static_cast<size_t>(call.node)]) {
      const auto in_it = [&](const Call& c) {
        return c.folder == call.node || (c.kind == Call::Kind::kRename && c.to == call.node);
      };
      for (const Call& c : pending)
        if (in_it(c)) apply(c, nodes);
      std::erase_if(pending, in_it);
    }
    cut();
  }
  for (const auto& [tree, stage] : seen) {
    fs::remove_all(root_);
    fs::create_directories(root_);
    for (const auto& [path, bytes] : tree) {
      if (path.ends_with('/')) fs::create_directories(root_ / path);
      else std::ofstream(root_ / path, std::ios::binary) << bytes;
    }
    check(stage);
  }
  return seen.size();
}

namespace {

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// The path of an open file below the folder; empty if it is another.
std::string path_of(int file) {
  if (g_recording == nullptr) return {};
  char path[4096] = {};
  if (readlink(("/proc/self/fd/" + std::to_string(file)).c_str(), path, sizeof path - 1) <= 0) return {};
  return g_recording->holds(path) ? path : "";
}

/// Notes that a file is about to go.
void note_end(const char* path) {
  if (g_recording == nullptr || !g_recording->holds(path)) return;
  const std::lock_guard hold(g_recording->lock());
  g_recording->about_to_go(path);
}

/// Runs a call on a path, and records it if it succeeded.
int recorded(const char* path, const auto& call, const auto& record) {
  if (g_recording == nullptr || !g_recording->holds(path)) return call();
  const std::lock_guard hold(g_recording->lock());
  const int result = call();
  if (result == 0) record();
  return result;
}

}  // namespace
}  // namespace weftlight

// The functions of the system that this program and its libraries call, recorded.
extern "C" {

using weftlight::next;
using weftlight::path_of;
using weftlight::recorded;

int open(const char* path, int flags, ...) {
  static auto* const real = next<int(const char*, int, ...)>("open");
  va_list more;
  va_start(more, flags);
  const unsigned mode = (flags & O_CREAT) != 0 ? va_arg(more, unsigned) : 0;
  va_end(more);
  weftlight::Disk* const disk = weftlight::g_recording;
  if (disk == nullptr || (flags & (O_CREAT | O_TRUNC)) == 0 || !disk->holds(path)) return real(path, flags, mode);
  const std::lock_guard hold(disk->lock());
  const bool was = access(path, F_OK) == 0;
  const int file = real(path, flags, mode);
  if (file >= 0 && !was) disk->made(path, false);
  else if (file >= 0 && (flags & O_TRUNC) != 0) disk->wrote(path);
  return file;
}

ssize_t write(int file, const void* from, size_t bytes) {
  static auto* const real = next<ssize_t(int, const void*, size_t)>("write");
  const std::string path = path_of(file);
  if (path.empty()) return real(file, from, bytes);
  const std::lock_guard hold(weftlight::g_recording->lock());
  const ssize_t written = real(file, from, bytes);
  weftlight::g_recording->wrote(path);
  return written;
}

int fsync(int file) {
  static auto* const real = next<int(int)>("fsync");
  const std::string path = path_of(file);
  if (path.empty()) return real(file);
  // Recorded alone: a disk that is waited for would only make the test slow.
  const std::lock_guard hold(weftlight::g_recording->lock());
  weftlight::g_recording->synced(path);
  return 0;
}

int rename(const char* from, const char* to) {
  static auto* const real = next<int(const char*, const char*)>("rename");
  if (weftlight::g_recording != nullptr && weftlight::g_recording->holds(from)) {
    const std::lock_guard hold(weftlight::g_recording->lock());
    weftlight::g_recording->about_to_rename(from, to);
  }
  return recorded(
      from, [&] { return real(from, to); }, [&] { weftlight::g_recording->renamed(from, to); });
}

int unlink(const char* path) {
  static auto* const real = next<int(const char*)>("unlink");
  weftlight::note_end(path);
  return recorded(
      path, [&] { return real(path); }, [&] { weftlight::g_recording->removed(path); });
}

int remove(const char* path) {
  static auto* const real = next<int(const char*)>("remove");
  weftlight::note_end(path);
  return recorded(
      path, [&] { return real(path); }, [&] { weftlight::g_recording->removed(path); });
}

int rmdir(const char* path) {
  static auto* const real = next<int(const char*)>("rmdir");
  weftlight::note_end(path);
  return recorded(
      path, [&] { return real(path); }, [&] { weftlight::g_recording->removed(path); });
}

int mkdir(const char* path, mode_t mode) {
  static auto* const real = next<int(const char*, mode_t)>("mkdir");
  return recorded(
      path, [&] { return real(path, mode); }, [&] { weftlight::g_recording->made(path, true); });
}
}
