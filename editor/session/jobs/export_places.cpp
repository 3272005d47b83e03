#include "session/jobs/export_places.h"

namespace weftlight::session {

void ExportPlaces::look(const std::vector<ExportJob>& jobs) {
  found_.reset();
  base::Task task = base::task_with_result(
      [jobs](const base::RunningTask&) {
        return Found{in_the_way(jobs), replaced_files(jobs)};
      },
      // What cannot be told now is told by the export itself.
      [this](const base::Result<Found>& look) { found_ = look ? *look : Found(); });
  task.kind = "look";
  task.may_be_left = true;
  runner_.stop();
  runner_.start(std::move(task));
}

}  // namespace weftlight::session
