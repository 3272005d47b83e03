#pragma once
// Lets the shown cloth fall by its own stiffness, on a thread of its own: how far it is, stopped at any moment. What
// was simulated is kept in the user's cache and found there again; the design only says that it is wanted.

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "base/worker.h"
#include "draft/design.h"
#include "session/edit.h"
#include "session/names.h"

namespace weftlight::session {

enum class DrapeStage {
  kShipped,  // as cloths of its kind hang: what was simulated once for all
  kFalling,  // is being simulated; the shipped one is shown
  kOwn,      // hangs as it does itself
  kStopped,
  kFailed,
};
struct DrapeState {
  DrapeStage stage = DrapeStage::kShipped;
  float share = 0;      // of kFalling, 0..1
  std::string problem;  // of kFailed
};

/// As an edit: whether the cloth hangs by its own stiffness.
Edit simulated_drape_edit(bool own);

class Draper {
 public:
  struct News {
    bool any = false;     // state() is another than at the last call
    bool draped = false;  // there is a mesh to show that was not there
    std::string said;
  };

  /// `wake`: called from the thread when there is news.
  explicit Draper(std::function<void()> wake);
  /// The design that is shown: what it asks for is looked for, and simulated where it is not kept.
  void follow(const std::shared_ptr<const Design>& design);
  /// Leaves it; the design is not asked again until it asks for another drape, or by again().
  void stop();
  void again(const std::shared_ptr<const Design>& design);
  DrapeState state() const;
  bool busy() const { return state().stage == DrapeStage::kFalling; }
  News take_news();

 private:
  void run(const Design& design, const std::string& wanted, const std::stop_token& stop);
  /// From the thread, of what is still wanted.
  void tell(const std::string& wanted, DrapeState state, std::string said = {});

  std::function<void()> wake_;
  mutable std::mutex mutex_;  // of the next three
  DrapeState state_;
  News news_;
  std::string wanted_;   // where the drape is kept; empty: the shipped one
  base::Worker worker_;  // gone before what it writes to
};

}  // namespace weftlight::session
