#include <string>
#include <vector>

#include "app/app.h"
#include "base/caught.h"
#include "base/resources.h"
#include "commands/commands.h"
#include "platform/crash_report.h"
#include "platform/error_line.h"
#include "platform/file.h"
#include "platform/language.h"
#include "platform/start.h"

namespace weftlight {
namespace {

int run(int argc, char** argv) {
  platform::survive_size_limit();
  try {
    const std::string language = commands::requested_language(argc, argv);
    platform::use_language(language, base::languages_dir());
    commands::CommandLine line = commands::run_command_line(argc, argv);
    line.editor.language_asked = !language.empty();
    return line.open_editor ? app::run_editor(line.editor) : line.exit_code;
  } catch (...) {  // unsaved work is in the journal
    platform::report_exception();
    platform::write_error_line("weftlight: " + base::words_of_thrown());
    return commands::kNotWritten;
  }
}

}  // namespace
}  // namespace weftlight

int main(int argc, char** argv) {
  std::vector<std::string> words = weftlight::platform::start(argc, argv);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return weftlight::run(static_cast<int>(words.size()), pointers.data());
}
