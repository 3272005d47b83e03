#pragma once
// The page of drafts with pictures: what was open lately, and the library. Which cards stand on it and which of them
// the keys lead to; how it looks is views/dialogs/gallery.

#include <string>
#include <string_view>
#include <vector>

#include "session/names.h"

namespace weftlight::session {

struct GalleryCard {
  std::string path, name;
  std::string where;  // its folder, the home as ~; of the library "Cloths" or "Drafts"
  bool copy = false;  // opened as a new, unnamed draft
};

/// Newest first, as they were open. `home`: the user's folder, or empty.
std::vector<GalleryCard> recent_cards(const std::vector<std::string>& paths, std::string_view home);
std::vector<GalleryCard> library_cards();

/// Indices of the cards whose name or place holds every word that was typed, whatever the case.
std::vector<int> found_cards(const std::vector<GalleryCard>& cards, std::string_view typed);

enum class Step { kLeft, kRight, kUp, kDown };
/// Where a step leads from card `chosen` (-1: none yet) of `count` in rows of `columns`; it ends at the edges.
int stepped(int chosen, int count, int columns, Step step);

struct Settings;
/// Whether the page opens by itself: the weaver opened drafts before, named none now, and is no program (`driven`).
bool opens_with_gallery(const Settings& settings, bool file_named, bool driven);

}  // namespace weftlight::session
