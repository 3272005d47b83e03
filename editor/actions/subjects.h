#pragma once
// All that actions act on, by subject. The editor wires it; tests have one without a window. Each group of the table
// takes those subjects that it acts on, and nothing else.

#include "actions/active_draft.h"
#include "actions/clipboard_access.h"
#include "actions/cloth_actions.h"
#include "actions/comparison_actions.h"
#include "actions/draft_dialogs.h"
#include "actions/export_actions.h"
#include "actions/file_actions.h"
#include "actions/loom_actions.h"
#include "actions/tab_actions.h"
#include "actions/window_actions.h"
#include "actions/yarn_actions.h"
#include "session/files/user_files.h"

namespace weftlight::actions {

using session::Settings;

/// No function is empty. The compiler refuses an initializer that leaves one out (-Wmissing-field-initializers).
struct Subjects {
  ActiveDraft draft;
  Clipboard clipboard;
  Settings& settings;
  WindowActions window;
  FileActions files;
  ExportActions exports;
  TabActions tabs;
  DraftDialogs dialogs;
  YarnActions yarns;
  ClothActions cloth;
  LoomActions loom;
  ComparisonActions comparison;
};

}  // namespace weftlight::actions
