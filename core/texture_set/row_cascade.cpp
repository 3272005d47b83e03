#include "texture_set/row_cascade.h"

#include <algorithm>

namespace weftlight::texture_set {

using base::Result;

namespace {

constexpr int kMaxWhole = 512 * 512;  // texels of a level that is kept; 26 MB

SurfaceTexels joined(const std::vector<SurfaceTexels>& rows) {
  SurfaceTexels out = blank_like(rows[0], rows[0].texels.width, static_cast<int>(rows.size()));
  for (size_t y = 0; y < rows.size(); ++y)
    std::copy_n(rows[y].texels.row(0), out.texels.width, out.texels.row(static_cast<int>(y)));
  return out;
}

}  // namespace

bool RowCascade::stays_whole(int level) const {
  const int width = std::max(size_.width >> level, 1), height = std::max(size_.height >> level, 1);
  return height == 1 || width * height <= kMaxWhole;
}

Result<void> RowCascade::add(int level, SurfaceTexels row, const Done& done) {
  if (stays_whole(level)) {
    rest_level_ = level;
    rest_.push_back(std::move(row));
    return {};
  }
  const auto waiting = waiting_.find(level);
  if (waiting == waiting_.end()) {
    waiting_.emplace(level, std::move(row));
    return {};
  }
  SurfaceTexels half = half_of(joined({std::move(waiting->second), std::move(row)}), 1);
  waiting_.erase(waiting);
  if (Result<void> used = done(level + 1, made_[level + 1]++, half); !used) return used;
  return add(level + 1, std::move(half), done);
}

Result<void> RowCascade::finish(const Done& done) {
  if (rest_.empty()) return {};
  SurfaceTexels level = joined(rest_);
  rest_ = {};
  for (int k = rest_level_ + 1; level.texels.width > 1 || level.texels.height > 1; ++k) {
    level = half_of(level, 1);
    if (Result<void> used = done(k, 0, level); !used) return used;
  }
  return {};
}

}  // namespace weftlight::texture_set
