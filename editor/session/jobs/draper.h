#pragma once
// Simulates the drape of the shown cloth from its own stiffness, on its own thread, with progress and a stop. Results
// are kept in the user's cache; the design only says that a simulated drape is wanted.

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "base/tasks.h"
#include "design/design.h"
#include "session/document/edit.h"

namespace weftlight::session {

using design::Design;

enum class DrapeStage {
  kGeneric,     // the drape that is shipped
  kSimulating,  // the generic drape is shown meanwhile
  kSimulated,   // the drape of this fabric
  kStopped,
  kFailed,
};
struct DrapeState {
  DrapeStage stage = DrapeStage::kGeneric;
  float share = 0;      // progress of kSimulating, 0..1
  std::string problem;  // of kFailed, for the user
};

/// The edit that switches the simulated drape on or off.
Edit simulated_drape_edit(bool on);

class Draper {
 public:
  struct Update {
    bool any = false;       // state() changed since the last call
    bool new_mesh = false;  // there is one to show
    std::string message;    // for the user; empty if there is none
  };

  /// `wake` is called on its thread when there is an update.
  explicit Draper(std::function<void()> wake);
  /// Follows the shown design: loads its drape from the cache, or simulates it.
  void follow(const std::shared_ptr<const Design>& design);
  /// Stops the simulation until the design needs another drape or again() is called.
  void stop();
  void again(const std::shared_ptr<const Design>& design);
  DrapeState state() const;
  bool busy() const { return state().stage == DrapeStage::kSimulating; }
  Update take_update();

 private:
  void run(const Design& design, const std::string& wanted, const std::stop_token& stop);
  void fail(const base::Error& error);
  void tell_failed(const std::string& wanted, const base::Error& error);
  /// Reports from its thread, if the drape is still wanted.
  void tell(const std::string& wanted, DrapeState state, std::string message = {});

  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards the next three
  DrapeState state_;
  Update update_;
  std::string wanted_;       // cache path of the drape; empty for the generic one
  base::TaskRunner runner_;  // destroyed first: its tasks write to the members above
};

}  // namespace weftlight::session
