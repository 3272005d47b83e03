#pragma once
// A name server that does not answer until it is told to.

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>

#include "platform/line.h"

namespace weftlight {

class HangingLookup {
 public:
  /// For LineConnector. A test that waits for the answer would end after half a minute, and fail.
  platform::LookUpHost look_up() const {
    return [state = state_](const std::string&, const std::string&) {
      std::unique_lock lock(state->mutex);
      ++state->asked;
      state->changed.notify_all();
      state->changed.wait_for(lock, kPatience, [&] { return state->told; });
      state->answered = true;
      state->changed.notify_all();
      return state->found;
    };
  }
  void answer(platform::HostFound found) const {
    std::unique_lock lock(state_->mutex);
    state_->found = std::move(found);
    state_->told = true;
    state_->changed.notify_all();
    state_->changed.wait_for(lock, kPatience, [this] { return state_->answered; });
  }
  /// Waits for the first question.
  bool is_asked() const {
    std::unique_lock lock(state_->mutex);
    return state_->changed.wait_for(lock, kPatience, [this] { return state_->asked > 0; });
  }
  int asked() const {
    const std::lock_guard lock(state_->mutex);
    return state_->asked;
  }
  bool answered() const {
    const std::lock_guard lock(state_->mutex);
    return state_->answered;
  }

 private:
  static constexpr std::chrono::seconds kPatience{30};
  struct State {
    std::mutex mutex;
    std::condition_variable changed;
    platform::HostFound found;
    int asked = 0;
    bool told = false, answered = false;
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

}  // namespace weftlight
