#pragma once
// Printing the draft, to files or on the system's printer (CUPS): the dialog, and the sheets, which are made in the
// background.

#include <string>

#include "app/background_tasks.h"
#include "app/dialogs.h"
#include "app/editing.h"
#include "app/messages.h"
#include "session/files/user_files.h"

namespace weftlight::app {

using session::Settings;
using views::PrintPrompt;

class Printing {
 public:
  Printing(Editing& editing, const Settings& settings, BackgroundTasks& tasks, Dialogs& dialogs, Messages& messages)
      : editing_(editing), settings_(settings), tasks_(tasks), dialogs_(dialogs), messages_(messages) {}
  void ask();

 private:
  void save(const PrintPrompt& prompt);
  void start(const std::string& path, const PrintPrompt& prompt);
  /// Hands it to the system's printers.
  void send(const PrintPrompt& prompt);

  Editing& editing_;
  const Settings& settings_;
  BackgroundTasks& tasks_;
  Dialogs& dialogs_;
  Messages& messages_;
};

}  // namespace weftlight::app
