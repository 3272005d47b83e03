#include "app/app.h"

#include <cstdio>
#include <string>

#include "app/editor.h"
#include "app/window.h"

namespace weftlight::app {

int run_editor(const EditorOptions& options) {
  const Settings settings = load_settings();
  std::string error;
  const auto window = Window::open(settings.width, settings.height, error);
  if (!window) {
    std::fprintf(stderr, "weftlight: %s\n", error.c_str());
    return kNoGraphics;
  }
  Editor(*window, options).run();
  return kDone;
}

}  // namespace weftlight::app
