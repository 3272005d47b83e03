#pragma once
// Files: what the File and Library menus open and save.

#include <functional>
#include <string>

namespace weftlight::actions {

/// Of the gallery, in the order of its tabs.
enum class GalleryPage { kRecent, kLibrary, kFolder };

struct FileActions {
  /// Asks for a new draft, with a weave of weave_kinds() chosen.
  std::function<void(int weave)> new_draft;
  std::function<void()> open;
  std::function<void(const std::string& path)> open_path;
  /// As a new, unnamed draft: a shipped one is never overwritten.
  std::function<void(const std::string& path)> open_copy;
  /// Shows recent drafts, the library, or a folder of drafts, with thumbnails.
  std::function<void(GalleryPage)> show_gallery;
  std::function<void()> save, save_as, save_all, save_for_others;
  std::function<bool()> any_unsaved;
  /// Opens a copy of the draft, unnamed, in a new tab.
  std::function<void()> duplicate;
  /// Reads the file again from disk.
  std::function<void()> reload;
  std::function<void()> show_in_folder;
  /// Offers unsaved work of crashed sessions.
  std::function<void()> offer_recovery;
  std::function<bool()> has_left_work;
  std::function<void()> quit;
};

}  // namespace weftlight::actions
