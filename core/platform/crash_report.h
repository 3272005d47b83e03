#pragma once
// What a crash leaves on the disk, for the next start to show: which program it was, where it stopped, and what was
// done last. Nothing of the user's: no text, no path, no name of a file.

#include <string>
#include <string_view>

namespace weftlight::platform {

/// At most as many reports are in a folder; the oldest gives way to a new one.
inline constexpr int kMaxCrashReports = 5;
/// The name of one, `number` from 1 to kMaxCrashReports: "crash-1.txt".
std::string crash_report_name(int number);

/// From now on a crash (a memory fault, a call of abort, an exception that nobody catches) writes a report into
/// `folder` before the program ends as it would have ended. The folder is made then, if it is not there; its user alone
/// can read it and the report. `program`: name and version, for the first line. A crash during a crash, a disk that
/// does not answer (ten seconds), or a folder that cannot be written leaves no report, or a part of one.
void report_crashes(const std::string& folder, const std::string& program);

/// For the report, which lists the last ten, newest first. `action`: an identifier; it is taken up to the first
/// character other than a letter, a digit, '.', '_' and '-', and up to 47 characters. From one thread at a time.
void note_action(std::string_view action);

/// Writes a report now, about the exception that is being handled, if report_crashes() was called. The program goes on.
void report_exception();

}  // namespace weftlight::platform
