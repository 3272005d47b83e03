#pragma once
// The window: opens the editor and runs until it is closed.

#include "commands/exit_codes.h"

namespace weftlight::app {

using commands::EditorOptions;

/// Returns an exit code of the contract (kNoGraphics without a display).
int run_editor(const EditorOptions& options);

}  // namespace weftlight::app
