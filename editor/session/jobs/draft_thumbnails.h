#pragma once
// Thumbnails of draft files. They are made on a thread of their own and cached in the user's cache folder by path, size
// and time, so that a file is read again only after it changed.

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "base/tasks.h"
#include "session/jobs/thumbnail.h"

namespace weftlight::session {

/// Size of cached thumbnails in pixels: twice the size of a gallery card at 96 dpi.
inline constexpr int kThumbnailWidth = 384, kThumbnailHeight = 248;
inline constexpr size_t kMaxThumbnails = 400;  // in the cache; the oldest are removed

struct DraftThumbnail {
  enum class State { kThere, kMissing, kUnreadable } state = State::kMissing;
  int64_t modified_ns = 0;  // since 1970
  Thumbnail picture;        // empty unless state is kThere
};

/// Reads the file, or its thumbnail in `cache_folder` (no cache if empty). Callable from any thread.
DraftThumbnail look_of_file(const std::string& path, const std::string& cache_folder, const std::stop_token& stop = {});

class DraftThumbnails {
 public:
  /// `wake` is called on that thread when there is a result.
  DraftThumbnails(std::string cache_folder, std::function<void()> wake);
  /// Queues a file.
  void ask(const std::string& path);
  /// Leaves a file out that is still waited for.
  void forget(const std::string& path) { runner_.stop(path); }
  /// The results since the last call.
  std::vector<std::pair<std::string, DraftThumbnail>> take();
  bool busy() const { return runner_.busy(); }

 private:
  std::string cache_folder_;
  std::vector<std::pair<std::string, DraftThumbnail>> made_;
  base::TaskRunner runner_;
};

}  // namespace weftlight::session
