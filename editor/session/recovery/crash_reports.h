#pragma once
// Reports that crashes left beside unsaved work (platform/crash_report.h), for the user to read, copy and delete.

#include <cstdint>
#include <string>
#include <vector>

namespace weftlight::session {

struct CrashReport {
  std::string path, text;
  int64_t written_ns = 0;  // since 1970
};

/// Those in the folder, newest first; none if it cannot be read. A file too long for a
/// report is none; what is not text in one is left out.
std::vector<CrashReport> crash_reports_in(const std::string& folder);
/// As one text, to be read or copied.
std::string joined_text(const std::vector<CrashReport>& reports);
/// Removes the files. What cannot be removed stays, and is shown again.
void remove_reports(const std::vector<CrashReport>& reports);

}  // namespace weftlight::session
