// The editor in a page: opens the window and returns, since the browser gives each turn (platform/turns.h). The first
// argument, if any, is the draft to open.

#include <cstdio>

#include "app/app.h"
#include "base/caught.h"
#include "commands/exit_codes.h"

int main(int argc, char** argv) {
  try {
    weftlight::app::EditorOptions options;
    if (argc > 1 && *argv[1] != 0) options.files = {argv[1]};  // empty where only a map is asked for
    if (argc > 2) options.ui_map = argv[2];
    return weftlight::app::run_editor(options);
  } catch (...) {
    std::fprintf(stderr, "weftlight: %s\n", weftlight::base::words_of_thrown().c_str());
    return weftlight::commands::kNotWritten;
  }
}
