#pragma once
// Modal dialogs. One is open at a time and gives one result.

#include <variant>

#include "views/dialogs/export_dialog.h"
#include "views/dialogs/gallery_dialog.h"
#include "views/dialogs/picture_dialog.h"
#include "views/dialogs/print_dialog.h"
#include "views/dialogs/prompts.h"
#include "views/dialogs/versions_dialog.h"
#include "views/dialogs/yarns_dialog.h"

namespace weftlight::views {

using Dialog = std::variant<std::monostate, Question, PathPrompt, NamePrompt, NamesPrompt, SectionsPrompt, SizePrompt,
                            ThreadPrompt, NotesPrompt, WeavePrompt, WeaveOverPrompt, ExportPrompt, PrintPrompt,
                            RecoveryPrompt, GalleryPrompt, ClosestWeavePrompt, JoinPrompt, VersionsPrompt,
                            PicturePrompt, GradientPrompt, YarnsPrompt, CardPrompt>;

/// Draws the open dialog, whose fields hold the input.
DialogResult draw_dialog(PanelContext& c, Dialog& dialog);
/// Takes finished background work. `busy`: some is running. True if there is something new to draw.
bool update_dialog(Dialog& dialog, bool& busy);

}  // namespace weftlight::views
