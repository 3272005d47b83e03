#pragma once
// Coarse mip levels of a face whose rows come one after another: as soon as two rows of a level are there, the next
// level has a row, so that no large level is in memory. The bits are those of half_of() of whole levels.

#include <functional>
#include <map>
#include <vector>

#include "base/result.h"
#include "texture_set/face_source.h"

namespace weftlight::texture_set {

class RowCascade {
 public:
  /// Is given the rows of a level from row y on, of each level in order.
  using Done = std::function<base::Result<void>(int level, int y, const SurfaceTexels& rows)>;
  /// `size`: of level 0.
  explicit RowCascade(TextureSize size) : size_(size) {}
  /// The next row of a level, always of the same one; of coarser levels the rows that are complete with it are `done`.
  base::Result<void> add(int level, SurfaceTexels row, const Done& done);
  /// The levels that are left, to 1 x 1.
  base::Result<void> finish(const Done& done);

 private:
  bool stays_whole(int level) const;
  TextureSize size_;
  std::map<int, SurfaceTexels> waiting_;  // by level, a row whose neighbour is to come
  std::map<int, int> made_;               // rows so far, by level
  std::vector<SurfaceTexels> rest_;       // all rows of a small level
  int rest_level_ = 0;
};

}  // namespace weftlight::texture_set
