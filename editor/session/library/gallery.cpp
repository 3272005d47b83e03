#include "session/library/gallery.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "base/text.h"
#include "session/files/user_files.h"
#include "session/library/library.h"

namespace weftlight::session {

using base::tr;

namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

std::string folder_of(const std::string& path, std::string_view home) {
  std::string folder = std::filesystem::path(path).parent_path().string();
  while (home.size() > 1 && home.ends_with('/')) home.remove_suffix(1);
  const bool at_home =
      !home.empty() && folder.starts_with(home) && (folder.size() == home.size() || folder[home.size()] == '/');
  return at_home ? std::string("~").append(folder, home.size()) : folder;
}

}  // namespace

std::vector<GalleryCard> recent_cards(const std::vector<std::string>& paths, std::string_view home) {
  std::vector<GalleryCard> cards;
  for (const std::string& path : paths)
    cards.push_back({path, std::filesystem::path(path).filename().string(), folder_of(path, home), false});
  return cards;
}

std::vector<GalleryCard> library_cards() {
  std::vector<GalleryCard> cards;
  for (LibraryFile& file : library_files())
    cards.push_back({std::move(file.path), std::move(file.name), file.cloth ? tr("Cloths") : tr("Drafts"), true});
  return cards;
}

std::vector<int> found_cards(const std::vector<GalleryCard>& cards, std::string_view typed) {
  std::vector<int> found;
  for (size_t i = 0; i < cards.size(); ++i) {
    const std::string text = lower(cards[i].name + " " + cards[i].where);
    std::istringstream words{lower(typed)};
    bool all = true;
    for (std::string word; words >> word;) all = all && text.find(word) != std::string::npos;
    if (all) found.push_back(static_cast<int>(i));
  }
  return found;
}

int stepped(int chosen, int count, int columns, Step step) {
  if (count <= 0) return -1;
  if (chosen < 0) return 0;
  columns = std::max(columns, 1);
  const int by = step == Step::kLeft ? -1 : step == Step::kRight ? 1 : step == Step::kUp ? -columns : columns;
  const int to = std::min(chosen, count - 1) + by;
  if (to < 0) return std::min(chosen, count - 1);
  // A step down into a last row that is not full goes to its end.
  const bool row_below = step == Step::kDown && chosen / columns < (count - 1) / columns;
  return to < count ? to : row_below ? count - 1 : std::min(chosen, count - 1);
}

bool opens_with_gallery(const Settings& settings, bool file_named, bool driven) {
  return settings.start_page && settings.toured && !settings.recent.empty() && !file_named && !driven;
}

}  // namespace weftlight::session
