#pragma once
// What a long computation is given: the request to stop it, and a listener to its progress.

#include <functional>
#include <stop_token>
#include <string>
#include <utility>

namespace weftlight::base {

/// By default nobody asks to stop and nobody listens.
class TaskProgress {
 public:
  using Listener = std::function<void(float share, const std::string& sentence)>;
  TaskProgress() = default;
  explicit TaskProgress(std::stop_token stop, Listener listener = {})
      : stop_(std::move(stop)), listener_(std::move(listener)) {}

  const std::stop_token& stop() const { return stop_; }
  bool stopped() const { return stop_.stop_requested(); }
  /// `share`: 0..1. `sentence`: what is being done; empty: as before.
  void report(float share, const std::string& sentence = {}) const {
    if (listener_) listener_(share, sentence);
  }

 private:
  std::stop_token stop_;
  Listener listener_;
};

}  // namespace weftlight::base
