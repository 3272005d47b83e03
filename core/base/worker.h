#pragma once
// A thread that does the newest job of each kind: what waits is replaced by what is newer, and what is at work
// is asked to give way. What a job throws ends that job alone.

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
  /// `stop` is asked for when a newer job of its kind waits, or when nobody wants the job any more.
  using Job = std::function<void(const std::stop_token& stop)>;
  /// What becomes of jobs that wait when the worker goes.
  enum class Leaving { kDrop, kFinish };

  /// Told on the thread what a job threw, in words, unless it was asked to stop.
  using Failed = std::function<void(const std::string& why, const std::stop_token& stop)>;

  explicit Worker(Leaving leaving = Leaving::kDrop, Failed failed = {});
  explicit Worker(Failed failed) : Worker(Leaving::kDrop, std::move(failed)) {}
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Takes the place of the waiting job of the same kind.
  void post(Job job, const std::string& kind = {});
  /// Nothing waits any more, and the job at work is asked to stop.
  void drop();
  /// A job waits, or is at work and was not asked to stop.
  bool busy() const;
  /// Until nothing waits and nothing is at work.
  void wait() const;

 private:
  void work();
  void run(Job job, const std::stop_token& stop) const noexcept;

  const Leaving leaving_;
  const Failed failed_;
  mutable std::mutex mutex_;  // of all below
  mutable std::condition_variable changed_;
  std::vector<std::pair<std::string, Job>> waiting_;  // oldest first, one of a kind
  std::string kind_;                                  // of the job at work
  std::stop_source stop_;                             // of the job at work
  bool working_ = false, closing_ = false;
  std::thread thread_;  // the last to be made
};

}  // namespace weftlight::base
