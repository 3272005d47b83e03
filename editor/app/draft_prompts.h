#pragma once
// The dialogs that make a draft, change it, or move in it.

#include <cstdint>
#include <functional>
#include <utility>

#include "actions/draft_dialogs.h"
#include "app/dialogs.h"
#include "app/draft_files.h"
#include "app/editing.h"
#include "app/messages.h"
#include "session/editing/palette_deletion.h"

namespace weftlight::app {

using actions::DraftDialogs;
using session::Deletion, session::Document, session::DocumentView, session::DrawingState, session::Edit,
    session::Settings;

class DraftPrompts {
 public:
  /// `show_flat`: shows the cloth as a flat swatch.
  DraftPrompts(Editing& editing, const Settings& settings, Files& files, Dialogs& dialogs, Messages& messages,
               std::function<void()> show_flat)
      : editing_(editing),
        settings_(settings),
        files_(files),
        dialogs_(dialogs),
        messages_(messages),
        show_flat_(std::move(show_flat)) {}

  /// A new draft, with a weave of weave_kinds() chosen.
  void ask_new_draft(int weave);
  void ask_size();
  void ask_notes();
  void ask_thread();
  void ask_weave();
  void ask_sections();
  void ask_join();
  void ask_picture();
  void ask_versions();
  void ask_gradient();
  void ask_delete_color();
  void ask_delete_yarn();
  void ask_closest_weave();

  DraftDialogs actions();

 private:
  const Document& document() const { return editing_.document(); }
  DocumentView& view() { return editing_.view(); }
  /// Deletes what nothing uses at once; otherwise asks, with `words` about what takes its place.
  void delete_or_ask(const Deletion& deletion, const Edit& edit, const std::string& words, int DrawingState::*active);

  Editing& editing_;
  const Settings& settings_;
  Files& files_;
  Dialogs& dialogs_;
  Messages& messages_;
  std::function<void()> show_flat_;
  uint64_t asked_ = 0;  // dialogs so far whose edits are one undo step each
};

}  // namespace weftlight::app
