#pragma once
// What the gallery shows: the thumbnails of drafts as textures, and the state of its dialog.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "session/jobs/draft_thumbnails.h"
#include "session/library/folder_browser.h"
#include "session/library/gallery.h"
#include "ui/pixel_texture.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::DraftThumbnail, session::DraftThumbnails, session::FolderBrowser, session::GalleryCard;
using ui::PixelTexture;

/// Thumbnails of files as textures. They are made on another thread when first requested.
class GalleryPictures {
 public:
  /// `wake`: called on the other thread when one is done. `now_ns`: since 1970, for "today".
  GalleryPictures(std::string cache_folder, std::function<void()> wake, int64_t now_ns);
  struct Entry {
    bool known = false;  // the file was looked at
    DraftThumbnail::State state = DraftThumbnail::State::kMissing;
    std::string when;
    PixelTexture texture;
    uint64_t seen = 0;  // the frame that last asked for it
  };
  /// Drops what is no longer in sight: pictures that are waited for, and all but the last few hundred.
  void begin_frame();
  const Entry& entry(const std::string& path);
  /// True if there is something new to show. Call it on the window's thread.
  bool poll();
  bool busy() const { return thumbnails_.busy(); }

 private:
  uint64_t frame_ = 0;
  int64_t now_ns_;
  std::map<std::string, Entry> entries_;
  DraftThumbnails thumbnails_;
};

inline constexpr int kFolderPage = 2;

struct GalleryPrompt {
  int page = 0;  // 0: recent, 1: library, 2: folder
  std::string typed;
  int chosen = -1;      // index in the cards found
  bool focus = false;   // the keyboard returns to the search field
  bool follow = false;  // scroll to the chosen card
  std::vector<GalleryCard> recent, library;
  std::shared_ptr<GalleryPictures> pictures;
  GalleryCard open{};  // the chosen card, with kOpen
  std::shared_ptr<FolderBrowser> browser{};
  collection::DraftQuery filter{};  // of the folder, but for the words
  enum Button { kOpen, kClose, kBrowse, kNew, kFolder };
};

}  // namespace weftlight::views
