#include "session/save.h"

#include "base/caught.h"
#include "wif/wif.h"

namespace weftlight::session {

SaveResult write(const SaveJob& job) noexcept {
  SaveResult result;
  const std::string thrown = caught([&] {
    FileIdentity known = job.known.value_or(FileIdentity{});
    result.changed = job.known && changed_since(job.path, known) == FileChange::kContent;
    if (result.changed) return;
    const std::string bytes = job.text();
    result.problem = write_file_atomically(job.path, bytes);
    if (result.problem.empty()) result.file = identify(job.path, bytes);
  });
  if (!thrown.empty()) result.problem = thrown;
  return result;
}

}  // namespace weftlight::session
