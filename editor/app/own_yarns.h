#pragma once
// The library of the user's yarns: its dialog, keeping a yarn of the draft, lists in and out.

#include "actions/yarn_actions.h"
#include "app/background_tasks.h"
#include "app/dialogs.h"
#include "app/editing.h"
#include "app/messages.h"
#include "session/library/yarn_shelf.h"

namespace weftlight::app {

using actions::YarnActions;
using session::YarnShelf;

class OwnYarns {
 public:
  OwnYarns(Editing& editing, BackgroundTasks& tasks, Dialogs& dialogs, Messages& messages)
      : editing_(editing), dialogs_(dialogs), messages_(messages), shelf_(tasks.writing()) {}
  YarnActions actions();

 private:
  /// Reads the library, and shows it.
  void ask();
  void show(const std::string& problem);
  void keep();
  void import();
  void export_all();

  Editing& editing_;
  Dialogs& dialogs_;
  Messages& messages_;
  YarnShelf shelf_;
};

}  // namespace weftlight::app
