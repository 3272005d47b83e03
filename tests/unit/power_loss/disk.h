#pragma once
// A disk that is watched, and what it may hold after the power failed. Based on: T. S. Pillai et al., "All File Systems
// Are Not Created Equal: On the Complexity of Crafting Crash-Consistent Applications" (ALICE), OSDI 2014.
//
// Recorded are the calls of this program that make, write, sync, rename and remove files below a folder. A crash may
// come after any of them. Then the disk has what was synced: the bytes of a file as they were when it was synced, and
// the names in a folder as they were when the folder was. Of what was not synced it may have anything: none, all, the
// first calls, any one alone, all but one; of bytes written since: none, half, zeros in their place, or all.
// Differs: a rename is never torn, and calls within one folder are the smallest that is lost.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace weftlight {

class Disk {
 public:
  /// What is below `root` counts as synced. There is one at a time.
  explicit Disk(std::filesystem::path root);
  ~Disk();
  Disk(const Disk&) = delete;
  Disk& operator=(const Disk&) = delete;

  /// From here on the program has told its user that stage `stage` is safe.
  void promise(int stage);

  /// Ends the recording. Gives the folder every content that a crash may leave, each once, and calls `check` with the
  /// last promise before that crash. Returns how many there were.
  size_t after_each_crash(const std::function<void(int promised)>& check);

  // Called by the recorded functions of the system, which hold the lock.
  static Disk* recording();
  std::recursive_mutex& lock() { return lock_; }
  bool holds(const std::string& path) const;
  void made(const std::string& path, bool folder);
  void wrote(const std::string& path);
  void synced(const std::string& path);
  /// Before the call. Its number may be given to another file.
  void about_to_go(const std::string& path);
  /// Before the call: a file that a library made unseen is noticed.
  void about_to_rename(const std::string& from, const std::string& to);
  void renamed(const std::string& from, const std::string& to);
  void removed(const std::string& path);

 private:
  struct Call {
    enum class Kind { kLink, kUnlink, kRename, kData, kSync, kPromise } kind;
    int node = 0;            // file or folder: linked, written, synced
    int folder = 0, to = 0;  // of the name; a rename goes from one to the other
    std::string name, new_name, bytes;
    int stage = 0;
  };
  struct Node {
    bool is_folder = false;
    std::string synced, now;           // bytes of a file
    std::map<std::string, int> names;  // of a folder, those synced
  };
  using Tree = std::map<std::string, std::string>;  // path to bytes; folders end with '/'
  enum class Unsynced { kNone, kHalf, kZeros, kAll };

  int node_at(const std::string& path) const;
  int new_node(const std::string& path, bool folder);
  void take_up(const std::filesystem::path& folder);
  void link(const std::string& path, int node);
  static void apply(const Call& call, std::vector<Node>& nodes);
  static void list(const std::vector<Node>& nodes, int folder, const std::string& path, Unsynced unsynced, Tree& tree);
  static std::string bytes_after(const Node& node, Unsynced unsynced);

  const std::filesystem::path root_;
  std::recursive_mutex lock_;
  std::map<std::pair<uint64_t, uint64_t>, int> by_number_;  // of the system's device and file
  std::vector<Node> first_;                                 // at the start of the recording; 0 is the root
  std::vector<bool> folders_;                               // of all nodes
  std::vector<Call> calls_;
};

}  // namespace weftlight
