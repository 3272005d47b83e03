#pragma once
// The dialogs that make a draft, change it, or move in it.

#include <cstdint>

#include "actions/draft_dialogs.h"
#include "app/dialogs.h"
#include "app/editing.h"
#include "app/files.h"

namespace weftlight::app {

using actions::DraftDialogs;
using session::Document, session::DocumentView;

class DraftPrompts {
 public:
  DraftPrompts(Editing& editing, Files& files, Dialogs& dialogs)
      : editing_(editing), files_(files), dialogs_(dialogs) {}

  /// A new draft, with a weave of weave_kinds() chosen.
  void ask_new_draft(int weave);
  void ask_size();
  void ask_notes();
  void ask_thread();
  void ask_weave();
  void ask_sections();
  void ask_closest_weave();

  DraftDialogs actions();

 private:
  const Document& document() const { return editing_.document(); }
  DocumentView& view() { return editing_.view(); }

  Editing& editing_;
  Files& files_;
  Dialogs& dialogs_;
  uint64_t asked_ = 0;  // dialogs so far whose edits are one undo step each
};

}  // namespace weftlight::app
