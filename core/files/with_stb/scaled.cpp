#include "files/scaled.h"

#include <algorithm>
#include <cmath>

namespace weftlight::files {
namespace {

/// Adds, for every texel of the result, what it covers of the rows (or columns) of the source: add(from, to, share).
template <class Add>
void for_each_share(int from, int to, const Add& add) {
  const double step = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    const double low = i * step, high = std::min((i + 1) * step, static_cast<double>(from));
    for (int k = static_cast<int>(low); k < high; ++k)
      add(k, i, static_cast<float>((std::min(high, k + 1.0) - std::max(low, static_cast<double>(k))) / step));
  }
}

}  // namespace

Image scaled(Image image, int width, int height) {
  const auto channels = static_cast<size_t>(image.channels);
  const auto at = [channels](const Image& of, int x, int y) {
    return (static_cast<size_t>(y) * static_cast<size_t>(of.width) + static_cast<size_t>(x)) * channels;
  };
  const auto empty = [&](int w, int h) {
    return Image{w, h, image.channels, std::vector<float>(static_cast<size_t>(w) * static_cast<size_t>(h) * channels)};
  };
  Image rows = empty(image.width, height);
  for_each_share(image.height, height, [&](int from, int to, float share) {
    const size_t count = static_cast<size_t>(image.width) * channels;
    for (size_t i = 0; i < count; ++i) rows.texels[at(rows, 0, to) + i] += share * image.texels[at(image, 0, from) + i];
  });
  Image out = empty(width, height);
  for_each_share(image.width, width, [&](int from, int to, float share) {
    for (int y = 0; y < height; ++y)
      for (size_t c = 0; c < channels; ++c)
        out.texels[at(out, to, y) + c] += share * rows.texels[at(rows, from, y) + c];
  });
  return out;
}

}  // namespace weftlight::files
