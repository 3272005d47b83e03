#pragma once
// Writes files on its own thread, so that the window never waits for a disk. Of several waiting writes of one path only
// the newest is done; a write that fails is tried again until it succeeds.

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "base/result.h"

namespace weftlight::session {

class BackgroundWriter {
 public:
  BackgroundWriter();
  /// Finishes the waiting jobs.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  using Job = std::function<base::Result<void>()>;
  /// Writes `path` by `job`, again and again until it succeeds.
  void keep(const std::string& path, Job job);
  /// Cancels the writes of `path`.
  void drop(const std::string& path);
  /// The message of a kept file's error until its write succeeds; empty if there is none.
  std::string problem() const;
  bool busy() const;

 private:
  using Jobs = std::map<std::string, Job>;  // by path
  void work();
  /// The next job that is due. While all waiting jobs have failed there is none until `retry_`.
  Jobs::iterator due();

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  Jobs waiting_;
  std::map<std::string, base::Error> errors_;  // by path, of jobs that wait for a retry
  std::chrono::steady_clock::time_point retry_{};
  bool leaving_ = false, working_ = false;
  std::thread thread_;
};

}  // namespace weftlight::session
