#include "views/dialogs/gallery_pictures.h"

#include <algorithm>
#include <utility>

#include "session/document/bring_back.h"

namespace weftlight::views {

using session::Thumbnail, session::time_in_words;

GalleryPictures::GalleryPictures(std::string cache_folder, std::function<void()> wake, int64_t now_ns)
    : now_ns_(now_ns), thumbnails_(std::move(cache_folder), std::move(wake)) {}

const GalleryPictures::Entry& GalleryPictures::entry(const std::string& path) {
  const auto [at, is_new] = entries_.try_emplace(path);
  if (is_new) thumbnails_.ask(path);
  at->second.seen = frame_;
  return at->second;
}

void GalleryPictures::begin_frame() {
  constexpr size_t kKept = 300;  // of a folder with tens of thousands, those that were seen last
  ++frame_;
  std::erase_if(entries_, [&](const auto& one) {
    const auto& [path, entry] = one;
    const bool waited_for = entry.seen + 2 > frame_;  // in the frame before this one
    if (entry.known || waited_for) return false;
    thumbnails_.forget(path);
    return true;
  });
  if (entries_.size() <= kKept) return;
  std::vector<uint64_t> seen;
  for (const auto& [path, entry] : entries_) seen.push_back(entry.seen);
  std::ranges::nth_element(seen, seen.end() - kKept);
  const uint64_t oldest = *(seen.end() - kKept);
  std::erase_if(entries_, [&](const auto& one) { return one.second.seen < oldest; });
}

bool GalleryPictures::poll() {
  const auto finished = thumbnails_.take();
  for (const auto& [path, thumbnail] : finished) {
    Entry& e = entries_[path];
    e.known = true;
    e.state = thumbnail.state;
    if (thumbnail.state != DraftThumbnail::State::kMissing) e.when = time_in_words(thumbnail.modified_ns, now_ns_);
    const Thumbnail& picture = thumbnail.picture;
    if (!picture.pixels.empty()) e.texture.set(picture.width, picture.height, picture.pixels, true);
  }
  return !finished.empty();
}

}  // namespace weftlight::views
