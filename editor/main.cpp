#include <cstdio>

#include "app/app.h"
#include "base/caught.h"
#include "commands/commands.h"

int main(int argc, char** argv) {
  try {
    const weftlight::commands::CommandLine line = weftlight::commands::run_command_line(argc, argv);
    return line.open_editor ? weftlight::app::run_editor(line.editor) : line.exit_code;
  } catch (...) {  // the journal has what was not saved
    std::fprintf(stderr, "weftlight: %s\n", weftlight::base::words_of_thrown().c_str());
    return weftlight::commands::kNotWritten;
  }
}
