#pragma once
// Printing the draft to files: the dialog, and the sheets, which are written in the background.

#include <string>

#include "app/dialogs.h"
#include "app/editing.h"
#include "app/messages.h"
#include "app/names.h"
#include "session/background_writer.h"
#include "session/user_files.h"

namespace weftlight::app {

class Printing {
 public:
  Printing(Editing& editing, const Settings& settings, Dialogs& dialogs, Messages& messages)
      : editing_(editing), settings_(settings), dialogs_(dialogs), messages_(messages) {}
  void ask();
  /// Shows what became of the last print. True if there is something to show.
  bool update();
  bool busy() const { return writer_.busy(); }

 private:
  void start(const std::string& path, const PrintPrompt& prompt);

  Editing& editing_;
  const Settings& settings_;
  Dialogs& dialogs_;
  Messages& messages_;
  BackgroundWriter writer_;
};

}  // namespace weftlight::app
