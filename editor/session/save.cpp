#include "session/save.h"

#include <algorithm>

#include "base/text.h"
#include "wif/wif.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr, base::write_file_atomically;

SaveResult write(const SaveJob& job) {
  const FileIdentity there = facts_of(job.path);
  if (std::ranges::any_of(job.others, [&](const FileIdentity& other) { return is_one_file(other, there); }))
    return base::failure(base::ErrorKind::kOutput, fill(tr("{path} is open in another tab."), arg("path", job.path)));
  const std::string& path = is_one_file(job.own_file, there) ? job.own_path : job.path;
  FileIdentity known = job.own_file;
  if (path == job.own_path && !job.over_changes && changed_since(path, known) == FileChange::kContent)
    return Saved{true, path, {}};
  const std::string bytes = job.text();
  if (const auto written = write_file_atomically(path, bytes); !written) return failed(written);
  return Saved{false, path, identify(path, bytes)};
}

}  // namespace weftlight::session
