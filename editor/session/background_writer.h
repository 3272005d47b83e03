#pragma once
// Writes files on a thread of its own, so that the window never waits for a disk. Of several writes of
// one path that are waiting, the newest wins.

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "session/names.h"

namespace weftlight::session {

class BackgroundWriter {
 public:
  BackgroundWriter();
  /// Finishes what is waiting.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  void write(const std::string& path, std::function<std::string()> make_bytes);
  void remove(const std::string& path);
  /// Anything else that writes `path`; returns what went wrong. `done` is what take_message then says.
  void run(const std::string& path, std::string done, std::function<std::string()> job);
  bool busy();
  std::string take_message();
  /// The last thing that went wrong since the last call; empty: nothing did.
  std::string take_error();

 private:
  using Job = std::function<std::string()>;  // returns what went wrong
  void post(const std::string& path, Job job);
  void work();

  std::mutex mutex_;
  std::condition_variable wake_;
  std::map<std::string, Job> waiting_;
  std::string error_, message_;
  bool leaving_ = false, working_ = false;
  std::thread thread_;
};

}  // namespace weftlight::session
