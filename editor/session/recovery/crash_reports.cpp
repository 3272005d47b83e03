#include "session/recovery/crash_reports.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <utility>

#include "base/whole_files.h"
#include "platform/crash_report.h"
#include "platform/file.h"

namespace weftlight::session {
namespace {

namespace fs = std::filesystem;
constexpr size_t kMaxText = size_t{1} << 16;  // far above any report

/// A report is plain ASCII; a damaged one is shown as far as it is.
std::string readable(std::string text) {
  std::erase_if(text, [](char c) { return c != '\n' && (c < ' ' || c > '~'); });
  return text;
}

}  // namespace

std::vector<CrashReport> crash_reports_in(const std::string& folder) {
  std::vector<CrashReport> found;
  for (int number = 1; number <= platform::kMaxCrashReports; ++number) {
    const std::string path = (fs::path(folder) / platform::crash_report_name(number)).string();
    base::Result<std::string> text = base::read_file(path, kMaxText);
    if (text) found.push_back({path, readable(std::move(*text)), platform::file_facts(path).modified_ns});
  }
  std::ranges::stable_sort(found, std::ranges::greater(), &CrashReport::written_ns);
  return found;
}

std::string joined_text(const std::vector<CrashReport>& reports) {
  std::string all;
  for (const CrashReport& report : reports) {
    if (!all.empty()) all += "\n";
    all += report.text;
  }
  return all;
}

void remove_reports(const std::vector<CrashReport>& reports) {
  for (const CrashReport& report : reports) platform::remove_with_contents(report.path);
}

}  // namespace weftlight::session
