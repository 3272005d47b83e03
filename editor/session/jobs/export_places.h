#pragma once
// What is in the folders of an export already. They may be on a share that does not answer, so nobody waits for it.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/tasks.h"
#include "session/jobs/export_plan.h"

namespace weftlight::session {

class ExportPlaces {
 public:
  struct Found {
    std::vector<std::string> in_the_way{};  // files of others, in words
    int replaced = 0;                       // files of an earlier export
  };

  /// `wake` is called on another thread when a look has ended.
  explicit ExportPlaces(std::function<void()> wake) : runner_(std::move(wake)) {}
  /// Looks anew; an earlier look is left.
  void look(const std::vector<ExportJob>& jobs);
  bool busy() const { return runner_.busy(); }
  /// True if a look has ended since the last call.
  bool poll() { return runner_.take(); }
  /// Of the last look; null until it has ended.
  const Found* found() const { return found_ ? &*found_ : nullptr; }

 private:
  std::optional<Found> found_;
  base::TaskRunner runner_;
};

}  // namespace weftlight::session
