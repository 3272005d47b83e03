#pragma once
// The library of yarns: what is on the weaver's shelf, to use in the draft, and to change.

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "session/library/yarn_shelf.h"
#include "views/common/panel.h"
#include "views/common/yarn_strip.h"
#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {

using design::LibraryYarn;
using session::YarnShelf;

struct YarnsPrompt {
  enum Button { kUse, kClose, kImport, kExport };
  YarnShelf* shelf = nullptr;             // outlives the dialog
  int active_yarn = 0, active_color = 0;  // of the draft
  std::string typed{};                    // to find a yarn
  int chosen = -1;                        // of the library; -1: none
  int color = 0;                          // of the chosen yarn
  bool searching = false;                 // the search field had the keyboard in the last frame
  bool follow = false;                    // scroll to the chosen row
  // What the fields show of the chosen yarn. It goes to the library when the field is left.
  LibraryYarn fields{};
  std::string count{};
  bool count_unread = false;
  uint64_t revision = ~uint64_t{0};        // of the library, when they were filled
  std::optional<LibraryYarn> removed{};    // can be put back
  std::shared_ptr<std::string> problem{};  // why the library cannot be read or written; empty: it can
  struct Strips {
    std::array<YarnStrip, 64> of;  // by row; more are never seen at once
  };
  std::shared_ptr<Strips> strips = std::make_shared<Strips>();
};

DialogResult draw_prompt(PanelContext& c, YarnsPrompt& p);

}  // namespace weftlight::views
