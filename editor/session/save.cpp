#include "session/save.h"

#include "wif/wif.h"

namespace weftlight::session {

using base::write_file_atomically;

SaveResult write(const SaveJob& job) {
  SaveResult result;
  if (job.known) {
    FileIdentity known = *job.known;
    result.changed = changed_since(job.path, known) == FileChange::kContent;
    if (result.changed) return result;
  }
  const std::string bytes = job.text();
  result.problem = write_file_atomically(job.path, bytes);
  if (result.problem.empty()) result.file = identify(job.path, bytes);
  return result;
}

}  // namespace weftlight::session
