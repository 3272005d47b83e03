#pragma once
// Writes texture sets on a thread of its own: how far it is, stopped at any moment, begun anew when the draft changed
// meanwhile. What stood there before stands until a set is whole.

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/worker.h"
#include "drape/mesh.h"
#include "session/export_plan.h"
#include "session/names.h"

namespace weftlight::session {

class Exporter {
 public:
  struct State {
    bool busy = false, stopped = false;
    size_t set = 0, sets = 0;           // at work on, of so many
    float share = 0;                    // of all of them, 0..1
    std::vector<std::string> written;   // folders
    std::vector<std::string> problems;  // what went wrong, a line each
  };

  /// `wake`: called from the thread when there is news.
  explicit Exporter(std::function<void()> wake);
  /// Leaves what it is at.
  void start(std::vector<ExportJob> jobs, std::shared_ptr<const Design> design);
  void stop();
  State state() const;
  bool busy() const;
  /// Whether a set was ever begun.
  bool began() const;
  /// True when state() is another than at the last call.
  bool take_news();
  /// What to say of a run that ended since the last call; empty: none did.
  std::string take_message();

 private:
  void run(const std::vector<ExportJob>& jobs, const Design& design, const std::stop_token& stop);
  /// False: there is none, told as a problem.
  bool use_mesh(const std::vector<ExportJob>& jobs, const Design& design);
  void tell(size_t set, size_t sets, float share);
  void end();

  std::function<void()> wake_;
  mutable std::mutex mutex_;  // of what is told
  State state_;
  bool news_ = false;
  std::string message_;
  std::string mesh_name_;  // the worker's
  Mesh mesh_;
  base::Worker worker_;  // gone before what it writes to
};

}  // namespace weftlight::session
