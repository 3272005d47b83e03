// `drawdown`: one line a pick (pick 1 first), one character an end (end 1 first), 1 where the warp is on
// top; or the coloured drawdown as a picture, as the editor shows it: end 1 at the right, pick 1 at the top.

#include <algorithm>
#include <cstdio>

#include "commands/commands.h"
#include "files/files.h"

namespace weftlight::commands {
namespace {

std::string as_text(const BitMatrix& cells) {
  std::string text;
  text.reserve(static_cast<size_t>(cells.rows()) * static_cast<size_t>(cells.cols() + 1));
  for (int pick = 0; pick < cells.rows(); ++pick) {
    for (int end = 0; end < cells.cols(); ++end) text += cells.get(pick, end) ? '1' : '0';
    text += '\n';
  }
  return text;
}

/// Pixels a cell: what makes the longer side about 1,024, from 1 to 16.
int cell_size(const BitMatrix& cells) {
  constexpr int kWanted = 1024, kLargest = 16;
  return std::clamp(kWanted / std::max({cells.rows(), cells.cols(), 1}), 1, kLargest);
}

Image as_image(const BitMatrix& cells, const Draft& draft) {
  const int size = cell_size(cells);
  Image image{cells.cols() * size, cells.rows() * size, 3, {}};
  image.texels.reserve(static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * 3);
  for (int y = 0; y < image.height; ++y) {
    const int pick = y / size;
    for (int x = 0; x < image.width; ++x) {
      const int end = cells.cols() - 1 - x / size;
      const int color = cells.get(pick, end) ? draft.warp.color[static_cast<size_t>(end)]
                                             : draft.weft.color[static_cast<size_t>(pick)];
      const Rgb& c = draft.palette[static_cast<size_t>(color)];
      image.texels.insert(image.texels.end(), {c.r, c.g, c.b});
    }
  }
  return image;
}

/// Black where the warp is on top, laid out as the coloured one.
Image as_points(const BitMatrix& cells) {
  Image image{cells.cols(), cells.rows(), 3, {}};
  for (int pick = 0; pick < cells.rows(); ++pick)
    for (int end = cells.cols() - 1; end >= 0; --end)
      image.texels.insert(image.texels.end(), 3, cells.get(pick, end) ? 0.0f : 1.0f);
  return image;
}

}  // namespace

int drawdown_command(const DrawdownOptions& options) {
  const OpenedDesign opened = open_design(options.file);
  if (!opened.ok) return kBadInput;
  BitMatrix cells = drawdown(opened.design.draft);
  if (options.face == Face::kBack) cells = complement(cells);
  if (options.out.empty()) {
    const std::string text = as_text(cells);
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0 ? kDone
                                                                                                       : kNotWritten;
  }
  constexpr int64_t kMaxPixels = int64_t{1} << 27;  // 1.6 GB of float texels
  const bool picture = options.out.ends_with(".png") || options.out.ends_with(".tif") || options.points;
  if (picture && int64_t{cells.rows()} * cells.cols() > kMaxPixels) {
    std::fprintf(stderr, "%s: %d by %d crossings are too many for a picture; write text instead\n", options.out.c_str(),
                 cells.cols(), cells.rows());
    return kNotWritten;
  }
  const std::string error =
      picture ? write_image(options.out, options.points ? as_points(cells) : as_image(cells, opened.design.draft),
                            PixelType::kU8)
              : write_file_atomically(options.out, as_text(cells));
  if (error.empty()) return kDone;
  std::fprintf(stderr, "%s; choose another place\n", error.c_str());
  return kNotWritten;
}

}  // namespace weftlight::commands
