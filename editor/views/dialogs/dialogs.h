#pragma once
// Questions in the middle of the window. One is open at a time; the answer comes back once.

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "draft/generators/table.h"
#include "views/common/names.h"
#include "views/common/panel.h"
#include "views/dialogs/export_dialog.h"
#include "views/dialogs/gallery.h"
#include "views/dialogs/print_dialog.h"

namespace weftlight::views {

/// A question with up to three buttons; the answer is the index of the one pressed (-1: left by Escape).
struct Question {
  std::string title, text;
  std::vector<std::string> buttons;  // the first is the one that Enter presses
};
/// A path typed in the window, where the system has no file dialog.
struct PathPrompt {
  std::string title, path, button;
};
struct SizePrompt {
  std::string title, button;
  int ends = 0, picks = 0, shafts = 0, treadles = 0;
  int loom_shafts = 0, loom_treadles = 0;  // that the loom has; 0: not said
};
/// The weave of a new draft, seen while it is chosen.
struct WeavePrompt {
  int kind = 0;  // of weave_kinds()
  WeaveValues values;
  int ends = 64, picks = 64;
  ClothSize repeat{0, 0};
  bool own_size = false;  // typed, else whole repeats
};
/// With the first numbers of the weave, about so large.
WeavePrompt prompt_for(int kind, ClothSize about);
struct ThreadPrompt {
  System system = System::kWarp;
  int number = 1, ends = 1, picks = 1;
};
/// A weave over the draft or some of its threads; the draft follows while the dialog is open.
struct WeaveOverPrompt {
  int kind = 0;  // of weave_kinds()
  bool whole = true;
  WeaveUse use;
  std::shared_ptr<const Design> base;  // as the dialog found it
  uint64_t stroke = 0;
  std::string why{};  // what could not be taken as it was asked
};
/// Threading and treadling from named sections; the draft follows while the dialog is open.
struct SectionsPrompt {
  System system = System::kWarp;
  int first_end = 1, last_end = 1, first_pick = 1, last_pick = 1;  // what is taken, from 1
  std::string name;                                                // of the next section
  Assembly warp, weft;
  std::shared_ptr<const Design> base;  // as the dialog found it
  uint64_t stroke = 0;
  std::string why{};  // what could not be made
};
/// The nearest that the loom weaves to what was painted; the draft shows it while the dialog is open.
struct ClosestWeavePrompt {
  std::shared_ptr<const ClosestWeave> nearest;
  std::shared_ptr<const Design> base;  // as the dialog found it
  uint64_t stroke = 0;
};
/// A name for something.
struct NamePrompt {
  std::string title, tip, name, button;
};
/// Things with names, to be renamed or dropped (an empty name).
struct NamesPrompt {
  std::string title;
  std::vector<std::string> before, names;
};
struct NotesPrompt {
  std::string title, author, notes;  // notes: one a line
};
/// Unsaved work that was left, a row each: name, when, where.
struct RecoveryPrompt {
  struct Row {
    std::string name, when, where;
  };
  std::vector<Row> rows;
  int chosen = 0;
  enum class Button { kOne, kAll, kLater, kDiscard };
  /// What the pressed one means: of several rows, all can be brought back.
  Button button(int pressed) const;
};
using Dialog = std::variant<std::monostate, Question, PathPrompt, NamePrompt, NamesPrompt, SectionsPrompt, SizePrompt,
                            ThreadPrompt, NotesPrompt, WeavePrompt, WeaveOverPrompt, ExportPrompt, PrintPrompt,
                            RecoveryPrompt, GalleryPrompt, ClosestWeavePrompt>;

/// kNone while it stands open; kDone with `button` when answered; kLeft when dismissed.
enum class Answer { kNone, kDone, kLeft };
struct DialogAnswer {
  Answer answer = Answer::kNone;
  int button = -1;
  MaybeEdit edit{};  // what a live dialog makes of the draft, also while it stands open
};
/// Draws the open dialog, whose fields hold what was typed.
DialogAnswer draw_dialog(PanelContext& c, Dialog& dialog);
/// What is worked out beside the window: `busy` while it is, true when there is something new to show.
bool update_dialog(Dialog& dialog, bool& busy);

}  // namespace weftlight::views
