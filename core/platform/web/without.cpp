// What a browser does itself, or does not let a page do.

#include <emscripten.h>

#include <filesystem>

#include "platform/clipboard.h"
#include "platform/crash_report.h"
#include "platform/desktop.h"
#include "platform/display.h"
#include "platform/folders.h"
#include "platform/own_addresses.h"
#include "platform/shared_library.h"
#include "platform/step_counter.h"

EM_JS(void, page_show, (const char* address), { window.open(UTF8ToString(address)); });

namespace weftlight::platform {

// The browser shows what went wrong in its console, and unsaved work is in its storage.
std::string crash_report_name(int number) { return "crash-" + std::to_string(number) + ".txt"; }
void report_crashes(const std::string& /*folder*/, const std::string& /*program*/) {}
void note_action(std::string_view /*action*/) {}
void report_exception() {}

void when_display_lost(std::function<void()> /*lost*/) {}
bool is_display_lost() { return false; }
void display_lost() {}

ClipboardText clipboard_text(void* /*window*/) { return {}; }

tl::expected<void, MissingProgram> show_folder(const std::string& /*folder*/) {
  return tl::unexpected(MissingProgram{"xdg-open"});
}
// What lies in the folder of the program, the handbook above all, has an address beside the page's.
tl::expected<void, MissingProgram> show_page(const std::string& file) {
  page_show(std::filesystem::path(file).lexically_relative(program_folder()).c_str());
  return {};
}

std::vector<OwnAddress> own_addresses() { return {}; }
bool has_library(const char* /*name*/) { return false; }

std::unique_ptr<StepCounter> StepCounter::start(const Work& /*work*/) { return nullptr; }
StepCounter::~StepCounter() = default;
std::optional<int64_t> StepCounter::count(std::string_view /*request*/) { return std::nullopt; }

}  // namespace weftlight::platform
