// A system that keeps reports of crashes itself: Windows in its Reliability Monitor, a browser in its console. Unsaved
// work is in the journal.

#include "platform/crash_report.h"

namespace weftlight::platform {

std::string crash_report_name(int number) { return "crash-" + std::to_string(number) + ".txt"; }
void report_crashes(const std::string& /*folder*/, const std::string& /*program*/) {}
void note_action(std::string_view /*action*/) {}
void report_exception() {}

}  // namespace weftlight::platform
