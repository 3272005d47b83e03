#include "views/common/overview_image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>

#include "base/loops.h"

namespace weftlight::views {

using base::for_each_job;

namespace {

constexpr int kWord = 64;
constexpr int kPlanes = 18;  // bits of a count of picks

/// First thread, of `count`, of pixel `p`, of `pixels`.
int first_of(int p, int pixels, int count) { return static_cast<int>(int64_t{p} * count / pixels); }
/// Pixel of a thread.
int pixel_of(int thread, int pixels, int count) {
  return static_cast<int>((int64_t{thread} * pixels + pixels - 1) / count);
}

struct Sum {
  int64_t r = 0, g = 0, b = 0, n = 0;
  void add(ImU32 c, int64_t times) {
    r += times * ((c >> IM_COL32_R_SHIFT) & 255);
    g += times * ((c >> IM_COL32_G_SHIFT) & 255);
    b += times * ((c >> IM_COL32_B_SHIFT) & 255);
    n += times;
  }
  ImU32 mean() const {
    const auto of = [this](int64_t v) { return static_cast<ImU32>((v + n / 2) / std::max<int64_t>(n, 1)); };
    return IM_COL32(of(r), of(g), of(b), 255);
  }
};

/// Counts how often each of 64 ends is up, in bit planes: all 64 counters are incremented at once.
class Counter {
 public:
  void add(uint64_t bits) {
    for (size_t p = 0; bits != 0 && p < plane_.size(); ++p) {
      const uint64_t carry = plane_[p] & bits;
      plane_[p] ^= bits;
      bits = carry;
      digits_ = std::max(digits_, p + 1);
    }
  }
  int of(int end) const {
    int count = 0;
    for (size_t p = 0; p < digits_; ++p) count |= static_cast<int>((plane_[p] >> end) & 1) << p;
    return count;
  }

 private:
  std::array<uint64_t, kPlanes> plane_{};
  size_t digits_ = 0;
};

/// Stores the colours and returns the half-open range of threads whose colour changed.
std::pair<int, int> update_colors(std::vector<ImU32>& before, const std::vector<ImU32>& now) {
  const auto first = std::mismatch(before.begin(), before.end(), now.begin(), now.end()).second;
  const auto last = std::mismatch(before.rbegin(), before.rend(), now.rbegin(), now.rend()).second.base();
  const std::pair range{static_cast<int>(first - now.begin()), static_cast<int>(last - now.begin())};
  if (range.first < range.second) before = now;
  return range;
}

}  // namespace

bool OverviewImage::update(const BitMatrix& cells, bool front, const CrossingColors& colors, int width, int height) {
  width = std::min(width, cells.cols());
  height = std::min(height, cells.rows());
  computed_ = 0;
  if (width <= 0 || height <= 0) return false;
  const bool rebuild = image_.width != width || image_.height != height || cells_.rows() != cells.rows() ||
                       cells_.cols() != cells.cols() || front_ != front || colors_.dyed != colors.dyed;
  if (rebuild) {
    image_ = {width, height, std::vector<ImU32>(static_cast<size_t>(width) * static_cast<size_t>(height))};
    cells_ = cells;
    front_ = front;
    colors_ = colors;
    compute(whole());
    return true;
  }
  const auto [end0, end1] = update_colors(colors_.warp, colors.warp);
  const auto [pick0, pick1] = update_colors(colors_.weft, colors.weft);
  compute(update_cells(cells));
  if (end0 < end1)
    compute({pixel_of(end0, width, cells.cols()), pixel_of(end1 - 1, width, cells.cols()) + 1, 0, height});
  if (pick0 < pick1)
    compute({0, width, pixel_of(pick0, height, cells.rows()), pixel_of(pick1 - 1, height, cells.rows()) + 1});
  return computed_ > 0;
}

OverviewImage::Area OverviewImage::update_cells(const BitMatrix& cells) {
  int first_row = cells.rows(), end_row = 0, first_word = cells.words(), end_word = 0;
  for (int r = 0; r < cells.rows(); ++r) {
    const std::span<const uint64_t> now = cells.row(r), before = cells_.row(r);
    if (std::equal(now.begin(), now.end(), before.begin())) continue;
    first_row = std::min(first_row, r);
    end_row = r + 1;
    for (int w = 0; w < cells.words(); ++w)
      if (now[static_cast<size_t>(w)] != before[static_cast<size_t>(w)])
        first_word = std::min(first_word, w), end_word = std::max(end_word, w + 1);
    std::copy(now.begin(), now.end(), cells_.row(r).begin());
  }
  if (first_row >= end_row) return {0, 0, 0, 0};
  const int last_end = std::min(end_word * kWord, cells.cols()) - 1;
  return {pixel_of(first_word * kWord, image_.width, cells.cols()), pixel_of(last_end, image_.width, cells.cols()) + 1,
          pixel_of(first_row, image_.height, cells.rows()), pixel_of(end_row - 1, image_.height, cells.rows()) + 1};
}

void OverviewImage::compute(const Area& area) {
  if (area.empty()) return;
  computed_ += int64_t{area.x1 - area.x0} * (area.y1 - area.y0);
  for_each_job(area.y1 - area.y0, [&](int i) { compute_row(area.y0 + i, area.x0, area.x1); });
}

/// Sums thread colours: an end counts once per crossing where it is on top, a pick where the end is not.
void OverviewImage::compute_row(int y, int x0, int x1) {
  const int ends = cells_.cols();
  const int pick0 = first_of(y, image_.height, cells_.rows()), pick1 = first_of(y + 1, image_.height, cells_.rows());
  const int end0 = first_of(x0, image_.width, ends), end1 = first_of(x1, image_.width, ends);
  std::vector<Sum> sums(static_cast<size_t>(x1 - x0));
  const int middle_pick = (pick0 + pick1 - 1) / 2;
  int x = x0;
  for (int end = end0; end < end1;) {
    // All ends within one word and one pixel.
    while (first_of(x + 1, image_.width, ends) <= end) ++x;
    Sum& sum = sums[static_cast<size_t>(x - x0)];
    const int word = end / kWord, stop = std::min({end1, (word + 1) * kWord, first_of(x + 1, image_.width, ends)});
    const int width = stop - end;
    const uint64_t mask = (width == kWord ? ~uint64_t{0} : (uint64_t{1} << width) - 1) << (end % kWord);
    const int middle_end = (end + stop - 1) / 2;
    Counter up;
    for (int pick = pick0; pick < pick1; ++pick) {
      const uint64_t bits = cells_.row(pick)[static_cast<size_t>(word)] & mask;
      const uint64_t visible = front_ ? bits : ~bits & mask;
      up.add(visible);
      sum.add(colors_.of(System::kWeft, pick, middle_end), width - std::popcount(visible));
    }
    for (int e = end; e < stop; ++e) sum.add(colors_.of(System::kWarp, e, middle_pick), up.of(e % kWord));
    end = stop;
  }
  for (int i = x0; i < x1; ++i)
    image_.pixels[static_cast<size_t>(y) * static_cast<size_t>(image_.width) + static_cast<size_t>(i)] =
        sums[static_cast<size_t>(i - x0)].mean();
}

}  // namespace weftlight::views
