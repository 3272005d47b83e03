#pragma once
// Drafts with their pictures: those that were open lately, and the library.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "session/draft_thumbnails.h"
#include "session/gallery.h"
#include "ui/pixel_texture.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// The pictures of files, as textures; what was looked at is looked for beside the window.
class GalleryPictures {
 public:
  /// `wake`: called on another thread when there is news. `now_ns`: since 1970, for "today".
  GalleryPictures(std::string cache_folder, std::function<void()> wake, int64_t now_ns);
  struct Seen {
    bool known = false;
    DraftThumbnail::State state = DraftThumbnail::State::kMissing;
    std::string when;
    PixelTexture texture;
  };
  const Seen& of(const std::string& path);
  /// True when there is something new to show. In the window's thread.
  bool poll();
  bool busy() const { return looks_.busy(); }

 private:
  int64_t now_ns_;
  std::map<std::string, Seen> seen_;
  DraftThumbnails looks_;
};

struct GalleryPrompt {
  int page = 0;  // 0: recent, 1: library
  std::string typed;
  int chosen = -1;      // of what is found
  bool focus = false;   // the keyboard goes back to what is typed
  bool follow = false;  // the chosen card is brought into sight
  std::vector<GalleryCard> recent, library;
  std::shared_ptr<GalleryPictures> pictures;
  GalleryCard open{};  // what was chosen, when answered by kOpen
  enum Button { kOpen, kClose, kBrowse, kNew };
};

}  // namespace weftlight::views
