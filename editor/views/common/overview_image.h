#pragma once
// The whole drawdown as a small image. Each pixel is the mean colour of its crossings. After an edit only the pixels
// whose crossings or thread colours changed are computed again.

#include <vector>

#include "views/common/cell_image.h"

namespace weftlight::views {

using draft::BitMatrix;

class OverviewImage {
 public:
  /// An image of width x height pixels, at most the number of ends and picks; end 1 at the left, pick 1 on top. True if
  /// a pixel may have changed. A thread whose colour changes along it has one in each pixel, that at its middle.
  bool update(const BitMatrix& cells, bool front, const CrossingColors& colors, int width, int height);
  const CellImage& image() const { return image_; }
  /// Number of pixels computed by the last update().
  int64_t computed() const { return computed_; }

 private:
  /// Half-open, in pixels.
  struct Area {
    int x0, x1, y0, y1;
    bool empty() const { return x0 >= x1 || y0 >= y1; }
  };
  Area whole() const { return {0, image_.width, 0, image_.height}; }
  /// The pixels that changed since the last drawdown; stores `cells`.
  Area update_cells(const BitMatrix& cells);
  void compute(const Area& area);
  void compute_row(int y, int x0, int x1);

  CellImage image_;
  BitMatrix cells_;
  bool front_ = true;
  CrossingColors colors_;
  int64_t computed_ = 0;
};

}  // namespace weftlight::views
