// What Windows does itself, or what its window library cannot hang on.

#include "platform/clipboard.h"
#include "platform/crash_report.h"
#include "platform/display.h"
#include "platform/step_counter.h"

namespace weftlight::platform {

// Windows keeps reports of crashes itself (Reliability Monitor), and unsaved work is in the journal.
std::string crash_report_name(int number) { return "crash-" + std::to_string(number) + ".txt"; }
void report_crashes(const std::string& /*folder*/, const std::string& /*program*/) {}
void note_action(std::string_view /*action*/) {}
void report_exception() {}

void when_display_lost(std::function<void()> /*lost*/) {}
bool is_display_lost() { return false; }
void display_lost() {}

ClipboardText clipboard_text(void* /*window*/) { return {}; }

std::unique_ptr<StepCounter> StepCounter::start(const Work& /*work*/) { return nullptr; }
StepCounter::~StepCounter() = default;
std::optional<int64_t> StepCounter::count(std::string_view /*request*/) { return std::nullopt; }

}  // namespace weftlight::platform
