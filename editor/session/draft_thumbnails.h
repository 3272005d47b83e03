#pragma once
// How files of drafts look, for lists with pictures: worked out beside the window, and kept in the user's cache folder
// by path, size and time, so that a file is read once and not again until it changes.

#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "base/worker.h"
#include "session/names.h"
#include "session/thumbnail.h"

namespace weftlight::session {

/// Of the kept pictures, pixels: twice what a card of the list shows at 96 dpi.
inline constexpr int kThumbnailWidth = 384, kThumbnailHeight = 248;
inline constexpr size_t kMaxThumbnails = 400;  // kept; the oldest go

struct DraftThumbnail {
  enum class State { kThere, kMissing, kUnreadable } state = State::kMissing;
  int64_t modified_ns = 0;  // since 1970
  Thumbnail picture;        // empty unless it is there
};

/// Reads the file, or its picture in `cache_folder` (empty: none is kept). Any thread.
DraftThumbnail look_of_file(const std::string& path, const std::string& cache_folder);

class DraftThumbnails {
 public:
  /// `wake`: called on the other thread when there is news.
  DraftThumbnails(std::string cache_folder, std::function<void()> wake);
  /// To be looked at, after those that were asked for before.
  void ask(const std::string& path);
  /// What became known since the last call.
  std::vector<std::pair<std::string, DraftThumbnail>> take();
  bool busy() const;

 private:
  void look(const std::stop_token& stop);

  std::string cache_folder_;
  std::function<void()> wake_;
  mutable std::mutex mutex_;  // of the next two
  std::deque<std::string> waiting_;
  std::vector<std::pair<std::string, DraftThumbnail>> news_;
  base::Worker worker_;  // gone before what it writes to
};

}  // namespace weftlight::session
