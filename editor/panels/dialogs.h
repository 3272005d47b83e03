#pragma once
// Questions in the middle of the window. One is open at a time; the answer comes back once.

#include <string>
#include <variant>
#include <vector>

#include "panels/panel.h"

namespace weftlight {

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
};
struct NotesPrompt {
  std::string title, author, notes;  // notes: one a line
};
using Dialog = std::variant<std::monostate, Question, PathPrompt, SizePrompt, NotesPrompt>;

/// kNone while it stands open; kDone with `button` when answered; kLeft when dismissed.
enum class Answer { kNone, kDone, kLeft };
struct DialogAnswer {
  Answer answer = Answer::kNone;
  int button = -1;
};
/// Draws the open dialog, whose fields hold what was typed.
DialogAnswer draw_dialog(PanelContext& c, Dialog& dialog);

}  // namespace weftlight
