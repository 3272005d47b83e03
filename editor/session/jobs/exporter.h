#pragma once
// Writes texture sets on its own thread, with progress and a stop, and restarts when the draft changes. The earlier
// files stay until a set is complete.

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/tasks.h"
#include "drape/mesh.h"
#include "session/jobs/export_plan.h"

namespace weftlight::session {

using design::Design;
using drape::Mesh;

class Exporter {
 public:
  struct State {
    bool busy = false, stopped = false;
    size_t set = 0, sets = 0;           // the set in progress, and their number
    float share = 0;                    // progress over all sets, 0..1
    std::vector<std::string> written;   // folders
    std::vector<std::string> problems;  // one line each
  };

  /// `wake` is called on that thread when there is an update.
  explicit Exporter(std::function<void()> wake);
  /// Drops the export in progress.
  void start(std::vector<ExportJob> jobs, std::shared_ptr<const Design> design);
  void stop();
  State state() const;
  bool busy() const;
  /// True if a set was ever started.
  bool began() const;
  /// True if state() changed since the last call.
  bool take_change();
  /// The message of an export that ended since the last call; empty if none did.
  std::string take_message();

 private:
  void run(const std::vector<ExportJob>& jobs, const Design& design, const std::stop_token& stop);
  /// Loads the mesh if a target needs it. On failure adds a problem and returns false.
  bool use_mesh(const std::vector<ExportJob>& jobs, const Design& design);
  void tell(size_t set, size_t sets, float share);
  void fail(const base::Error& error);
  void end();

  std::function<void()> wake_;
  mutable std::mutex mutex_;  // guards state_, changed_ and message_
  State state_;
  bool changed_ = false;
  std::string message_;
  std::string mesh_name_;  // used by its tasks only, as is mesh_
  Mesh mesh_;
  base::TaskRunner runner_;  // destroyed first: its tasks write to the members above
};

}  // namespace weftlight::session
