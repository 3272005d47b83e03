#pragma once
// Drafts with their thumbnails: the recent ones, the library, and those of a folder.

#include "views/dialogs/dialog_parts.h"
#include "views/dialogs/gallery_pictures.h"

namespace weftlight::views {

DialogResult draw_prompt(PanelContext& c, GalleryPrompt& p);

}  // namespace weftlight::views
