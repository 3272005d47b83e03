#pragma once
// The cards of the gallery: a thumbnail with words below it, and what a click on it asks for.

#include "views/dialogs/gallery_pictures.h"

namespace weftlight::views {

// Pixels at 96 dpi.
inline constexpr float kCardPadding = 8, kCardGap = 10;

/// A card of the library has only a name below its thumbnail.
ImVec2 card_size(const PanelContext& c, int page);

enum class CardRequest { kNone, kOpen, kRemove };
/// `index`: among the cards found.
CardRequest draw_card(const PanelContext& c, GalleryPrompt& p, const GalleryCard& card, int index, ImVec2 at);

/// Moves the chosen card by the arrow keys.
void move_choice(GalleryPrompt& p, int count, int columns);

/// The page of a folder, below the head of the gallery: where it is, what is searched for, and the cards found. The
/// path of a draft to open, or empty; `choose`: another folder is asked for.
std::string draw_folder_page(PanelContext& c, GalleryPrompt& p, ImVec2 size, int columns, bool& choose);

}  // namespace weftlight::views
