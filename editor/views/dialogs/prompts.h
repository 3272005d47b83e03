#pragma once
// What the smaller dialogs ask, with the input in their fields, and how they are drawn. The larger ones have headers of
// their own.

#include <memory>
#include <string>
#include <vector>

#include "analysis/loom_sett.h"
#include "design/palette_edits.h"
#include "session/document/rejected_edit.h"
#include "views/dialogs/dialog_parts.h"
#include "views/dialogs/weave_preview.h"
#include "weaves/joined_drafts.h"
#include "weaves/table.h"

namespace weftlight::views {

using analysis::LoomSett, analysis::Units;
using design::Assembly, design::Design, design::Gradient, design::WeaveUse;
using draft::System;
using session::ClosestWeave;
using weaves::Joining;

/// A question with up to four buttons; the result is the index of the pressed one, -1 for Escape. Buttons, here and in
/// the other prompts, are marked texts.
struct Question {
  std::string title, text;
  std::vector<std::string> buttons;
  int by_enter = 0;  // the button that Enter presses: none that loses what Undo cannot bring back
};
/// A path to type, if the system has no file dialog.
struct PathPrompt {
  std::string title, path, button;
};
struct SizePrompt {
  std::string title, button;
  int ends = 0, picks = 0, shafts = 0, treadles = 0;
  int loom_shafts = 0, loom_treadles = 0;  // loom limits; 0: none
  std::shared_ptr<const Design> base{};    // before the dialog
};
/// The weave of a new draft, with a preview.
struct WeavePrompt {
  int kind = 0;  // of weave_kinds()
  WeaveValues values;
  int ends = 64, picks = 64;
  ClothSize repeat{0, 0};
  bool own_size = false;  // the size was typed; otherwise it is whole repeats
  int yarn = 0;           // of design::ready_yarns()
  Units units = Units::kMetric;
  LoomSett firm, sett;    // of that weave in that yarn; the draft's, in the same proportion
  bool own_sett = false;  // it was typed; otherwise it is the firm one
  std::shared_ptr<WeavePreview> preview{};
  float below = 0;      // pixels that all below the picture took when it was last drawn
  std::string typed{};  // to find a weave
};
/// The weave with its default parameters, near that size.
WeavePrompt prompt_for(int kind, ClothSize about, Units units);
/// The draft that was asked for.
Design new_design(const WeavePrompt& p);
struct ThreadPrompt {
  System system = System::kWarp;
  int ends = 1, picks = 1;
  std::string typed = "1";
  int number = 1;  // what it says; in the draft when it is done
};
/// A weave over the draft or some of its threads. The draft shows it while the dialog is open.
struct WeaveOverPrompt {
  int kind = 0;  // of weave_kinds()
  bool whole = true;
  WeaveUse use;
  std::shared_ptr<const Design> base;  // before the dialog
  uint64_t stroke = 0;
  std::string why{};     // what could not be done as requested
  bool refused = false;  // nothing could
  std::string typed{};   // to find a weave
};
/// Threading and treadling from named sections. The draft shows them while the dialog is open.
struct SectionsPrompt {
  System system = System::kWarp;
  int first_end = 1, last_end = 1, first_pick = 1, last_pick = 1;  // the range to add as a section, from 1
  std::string name;                                                // of the next section
  Assembly warp, weft;
  std::shared_ptr<const Design> base;  // before the dialog
  uint64_t stroke = 0;
  std::string why{};  // what could not be made
};
/// The draft and another one in one cloth. The draft shows it while the dialog is open.
struct JoinPrompt {
  std::string name;  // of the other draft
  std::shared_ptr<const Design> other;
  Joining joining;
  std::shared_ptr<const Design> base;  // before the dialog
  uint64_t stroke = 0;
  bool shown = false;  // the draft shows it
  std::string why{};   // why they cannot be joined so
};
/// Colours from one to another across threads. The draft shows it while the dialog is open.
struct GradientPrompt {
  System system = System::kWarp;
  std::vector<int> chosen;  // threads of the system in which it opened; empty: all
  System chosen_of = system;
  Gradient gradient;
  std::shared_ptr<const Design> base;  // before the dialog
  uint64_t stroke = 0;
  bool shown = false;  // the draft shows it
};
/// The closest weave that the loom can make to an edit beyond its limits. The draft shows it while the dialog is open.
struct ClosestWeavePrompt {
  std::shared_ptr<const ClosestWeave> closest;
  std::shared_ptr<const Design> base;  // before the dialog
  uint64_t stroke = 0;
  int place = -1;  // the chosen difference, an index; -1: none yet
};
/// How large the screen's pixels are, by a credit card that is held to it.
struct CardPrompt {
  std::string screen;          // its name
  float px_a_mm = 0;           // window units in a millimetre
  float eye_to_screen_cm = 0;  // how far the weaver sits from it
  bool dragging = false;
};
/// Asks for a name.
struct NamePrompt {
  std::string title, tip, name, button;
};
/// Named things to rename, or to delete (an empty name).
struct NamesPrompt {
  std::string title;
  std::vector<std::string> before, names;
};
struct NotesPrompt {
  std::string title, author, notes;  // notes: one per line
};
/// Unsaved work to recover, a row each, and reports of crashes; at least one of the two.
struct RecoveryPrompt {
  struct Row {
    std::string name, when, where;
  };
  std::vector<Row> rows;
  std::string reports{};  // empty: none
  int chosen = 0;
  bool copied = false;  // the reports are on the clipboard
  enum class Button { kOne, kAll, kLater, kDiscard, kDeleteReports };
  /// Meaning of the pressed button. With several rows there is also one for all, without any only kLater.
  Button button(int pressed) const;
};

DialogResult draw_prompt(PanelContext& c, WeavePrompt& p);
DialogResult draw_prompt(PanelContext& c, WeaveOverPrompt& p);
DialogResult draw_prompt(PanelContext& c, SectionsPrompt& p);
DialogResult draw_prompt(PanelContext& c, JoinPrompt& p);
DialogResult draw_prompt(PanelContext& c, GradientPrompt& p);
DialogResult draw_prompt(PanelContext& c, ClosestWeavePrompt& p);
DialogResult draw_prompt(PanelContext& c, CardPrompt& p);
/// The edit that restores the draft as the dialog found it.
MaybeEdit restored(const WeaveOverPrompt& p);
MaybeEdit restored(const SectionsPrompt& p);
MaybeEdit restored(const JoinPrompt& p);
MaybeEdit restored(const GradientPrompt& p);
MaybeEdit restored(const ClosestWeavePrompt& p);

}  // namespace weftlight::views
