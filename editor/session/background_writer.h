#pragma once
// Writes files on a thread of its own, so that the window never waits for a disk. Of several writes of
// one path that are waiting, the newest wins; one that is refused is tried again until it succeeds.

#include <chrono>
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

  /// Keeps `path` written by `job`, which returns what went wrong.
  void keep(const std::string& path, std::function<std::string()> job);
  /// Nothing is to be written there any more.
  void drop(const std::string& path);
  /// What stands wrong of what is kept, until it succeeds; empty: nothing.
  std::string problem() const;

  /// Once; returns what went wrong. `done` is what take_message then says.
  void run(const std::string& path, std::string done, std::function<std::string()> job);
  bool busy() const;
  std::string take_message();
  /// What last went wrong of what was to be done once, since the last call; empty: nothing did.
  std::string take_error();

 private:
  struct Job {
    std::function<std::string()> run;  // returns what went wrong
    bool again = false;                // where it went wrong
  };
  void post(const std::string& path, Job job);
  void work();
  /// The next job that is due; none until `retry_` where all that waits was refused.
  std::map<std::string, Job>::iterator due();

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::map<std::string, Job> waiting_;
  std::map<std::string, std::string> problems_;  // by path; only of what waits to be tried again
  std::chrono::steady_clock::time_point retry_{};
  std::string error_, message_;
  bool leaving_ = false, working_ = false;
  std::thread thread_;
};

}  // namespace weftlight::session
