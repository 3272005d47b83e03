#pragma once
// Lit flat pictures of several designs at one scale, made one after the other on a thread of their own.

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "base/tasks.h"
#include "design/design.h"
#include "session/jobs/thumbnail.h"

namespace weftlight::session {

using design::Design;

/// The design's flat cloth, `across_mm` wide. Empty if it has none, or `stop` was requested.
Thumbnail lit_picture(const Design& design, int width, int height, float across_mm, const std::stop_token& stop = {});

class ClothPictures {
 public:
  using Picture = std::pair<std::shared_ptr<const Design>, Thumbnail>;

  /// `wake` is called on the other thread when there is a picture.
  explicit ClothPictures(std::function<void()> wake) : runner_(std::move(wake)) {}
  /// Queues a design. With another scale or size than before, all that was asked for is dropped.
  void ask(const std::shared_ptr<const Design>& design, int width, int height, float across_mm);
  /// The pictures since the last call; an empty one could not be made.
  std::vector<Picture> take();
  bool busy() const { return runner_.busy(); }
  /// Blocks until all are made.
  void wait() const { runner_.wait(); }

 private:
  int width_ = 0, height_ = 0;
  float across_mm_ = 0;
  std::vector<Picture> made_;
  base::TaskRunner runner_;
};

}  // namespace weftlight::session
