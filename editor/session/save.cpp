#include "session/save.h"

#include "wif/wif.h"

namespace weftlight::session {

using base::write_file_atomically;

SaveResult write(const SaveJob& job) {
  if (job.known) {
    FileIdentity known = *job.known;
    if (changed_since(job.path, known) == FileChange::kContent) return Saved{true, {}};
  }
  const std::string bytes = job.text();
  if (const auto written = write_file_atomically(job.path, bytes); !written) return failed(written);
  return Saved{false, identify(job.path, bytes)};
}

}  // namespace weftlight::session
