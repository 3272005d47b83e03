#pragma once
// The whole drawdown in a small picture: every pixel is the mean colour of all crossings that it stands for. After an
// edit only those pixels are made again whose crossings, or whose threads' colours, are others.

#include <vector>

#include "views/common/cell_image.h"
#include "views/common/names.h"

namespace weftlight::views {

class OverviewImage {
 public:
  /// Of width x height pixels, at most as many as there are ends and picks; end 1 at the left, pick 1 on top. True when
  /// a pixel may have changed. `warp`, `weft`: colours of the threads.
  bool follow(const BitMatrix& cells, bool front, const std::vector<ImU32>& warp, const std::vector<ImU32>& weft,
              int width, int height);
  const CellImage& image() const { return image_; }
  /// Pixels made by the last follow().
  int64_t made() const { return made_; }

 private:
  /// Half-open, in pixels.
  struct Area {
    int x0, x1, y0, y1;
    bool empty() const { return x0 >= x1 || y0 >= y1; }
  };
  Area whole() const { return {0, image_.width, 0, image_.height}; }
  /// What differs from the drawdown that was followed last, which becomes `cells`.
  Area take_changes(const BitMatrix& cells);
  void make(const Area& area);
  void make_row(int y, int x0, int x1);

  CellImage image_;
  BitMatrix cells_;
  bool front_ = true;
  std::vector<ImU32> warp_, weft_;
  int64_t made_ = 0;
};

}  // namespace weftlight::views
