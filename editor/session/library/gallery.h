#pragma once
// The gallery: recent drafts and the library as cards with thumbnails. Here are its cards and its keyboard navigation;
// views/dialogs/gallery draws it.

#include <string>
#include <string_view>
#include <vector>

namespace weftlight::session {

struct GalleryCard {
  std::string path, name;
  std::string where;  // its folder, with ~ for the home folder; in the library "Cloths" or "Drafts", translated
  bool copy = false;  // opened as a new, unnamed draft
  bool kept = true;   // in a list from which it can be removed
};

/// Most recent first. `home` is the home folder of the user, or empty.
std::vector<GalleryCard> recent_cards(const std::vector<std::string>& paths, std::string_view home);
std::vector<GalleryCard> library_cards();

/// Indices of the cards whose name or folder contains every typed word, ignoring case.
std::vector<int> found_cards(const std::vector<GalleryCard>& cards, std::string_view typed);

enum class Step { kLeft, kRight, kUp, kDown };
/// The card after a step from `chosen` (-1 if none) of `count` cards in rows of `columns`; stops at the edges.
int stepped(int chosen, int count, int columns, Step step);

struct Settings;
/// True if the gallery opens at the start: the user has recent drafts, named no file, and no program drives the window
/// (`driven`).
bool opens_with_gallery(const Settings& settings, bool file_named, bool driven);

}  // namespace weftlight::session
