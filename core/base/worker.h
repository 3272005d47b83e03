#pragma once
// A thread that runs the newest job of each kind: a newer job replaces a waiting one of the same kind, and asks a
// running one to stop. What a job throws ends that job alone.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace weftlight::base {

class Worker {
 public:
  /// `stop` is requested when a newer job of the same kind waits, or by drop().
  using Job = std::function<void(const std::stop_token& stop)>;
  /// What the destructor does with waiting jobs.
  enum class Leaving { kDrop, kFinish };

  /// Called on the worker thread with the text of what a job threw, unless the job was asked to stop.
  using Failed = std::function<void(const std::string& why, const std::stop_token& stop)>;

  explicit Worker(Leaving leaving = Leaving::kDrop, Failed failed = {});
  explicit Worker(Failed failed) : Worker(Leaving::kDrop, std::move(failed)) {}
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Replaces a waiting job of the same kind.
  void post(Job job, const std::string& kind = {});
  /// Removes all waiting jobs and asks the running one to stop.
  void drop();
  /// True if a job waits, or runs without a request to stop.
  bool busy() const;
  /// Blocks until no job waits or runs.
  void wait() const;

 private:
  void work();
  void run(Job job, const std::stop_token& stop) const noexcept;

  const Leaving leaving_;
  const Failed failed_;
  mutable std::mutex mutex_;  // protects all members below
  mutable std::condition_variable changed_;
  std::vector<std::pair<std::string, Job>> waiting_;  // oldest first, one of a kind
  std::string kind_;                                  // of the running job
  std::stop_source stop_;                             // of the running job
  bool working_ = false, closing_ = false;
  std::thread thread_;  // must be the last member
};

}  // namespace weftlight::base
