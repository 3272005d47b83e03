#include "session/jobs/export_preview.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "design/srgb.h"
#include "texture_set/set_preview.h"

namespace weftlight::session {

using files::Image;
using texture_set::PreviewImage, texture_set::SetPreview, texture_set::key_of, texture_set::preview_set;

namespace {

constexpr int kMaxSide = 256;  // texels, of the images that the thumbnails show
constexpr int kColumns = 8;    // of thumbnails in the atlas
constexpr double kSheetBytes = 6e5;
constexpr double kGrowth = 0.7;  // exponent of file size over texel count: finer images are smoother

uint32_t packed(float r, float g, float b) {
  const auto byte = [](float v) { return static_cast<uint32_t>(std::lround(255 * std::clamp(v, 0.0f, 1.0f))); };
  return 0xFF000000u | byte(r) | byte(g) << 8 | byte(b) << 16;
}

/// The atlas, filled row by row from the top.
class Sheet {
 public:
  explicit Sheet(int width) { made_.width = width; }
  ExportPreview& made() { return made_; }
  PictureRect room(int width, int height) {
    if (x_ + width > made_.width) x_ = 0, y_ += row_, row_ = 0;
    const PictureRect at{x_, y_, width, height};
    x_ += width, row_ = std::max(row_, height);
    made_.height = std::max(made_.height, y_ + height);
    made_.pixels.resize(static_cast<size_t>(made_.width) * static_cast<size_t>(made_.height), 0xFF000000u);
    return at;
  }
  /// colour(x, y) returns the colour of a pixel of the rectangle.
  template <class Colour>
  void fill(const PictureRect& at, const Colour& colour) {
    for (int y = 0; y < at.height; ++y)
      for (int x = 0; x < at.width; ++x)
        made_.pixels[static_cast<size_t>(at.y + y) * static_cast<size_t>(made_.width) + static_cast<size_t>(at.x + x)] =
            colour(x, y);
  }

 private:
  ExportPreview made_;
  int x_ = 0, y_ = 0, row_ = 0;
};

/// Mean of a channel over the footprint of a pixel of the rectangle.
float mean_at(const Image& image, const PictureRect& at, int x, int y, int channel) {
  const int x0 = x * image.width / at.width, x1 = std::max((x + 1) * image.width / at.width, x0 + 1);
  const int y0 = y * image.height / at.height, y1 = std::max((y + 1) * image.height / at.height, y0 + 1);
  float sum = 0;
  for (int j = y0; j < y1; ++j)
    for (int i = x0; i < x1; ++i)
      sum += image.texels[static_cast<size_t>((j * image.width + i) * image.channels + channel)];
  return sum / static_cast<float>((x1 - x0) * (y1 - y0));
}

/// Maps values outside 0..1, such as heights in millimetres, to 0..1.
struct Range {
  float low = 0, scale = 1;
  float of(float v) const { return (v - low) * scale; }
};
Range range_of(const Image& image) {
  const auto [least, most] = std::minmax_element(image.texels.begin(), image.texels.end());
  if (image.texels.empty() || (*least >= 0 && *most <= 1)) return {};
  return {*least, 1 / std::max(*most - *least, 1e-6f)};
}

/// Linear colours are encoded as sRGB; all other values are shown as stored.
float shown(const PreviewImage& image, const Range& range, float value) {
  const bool colour = image.channels.front().starts_with("base colour");
  return colour && !image.srgb ? design::srgb_encoded(std::clamp(value, 0.0f, 1.0f)) : range.of(value);
}

ShownImage lay(Sheet& sheet, const PreviewImage& image, int side) {
  const int longer = std::max(image.image.width, image.image.height);
  const int width = std::max(image.image.width * side / longer, 1),
            height = std::max(image.image.height * side / longer, 1);
  const Range range = range_of(image.image);
  ShownImage out{image.file, image.srgb ? "sRGB" : "linear", sheet.room(width, height), {}};
  const auto value = [&](const PictureRect& at, int x, int y, int channel) {
    return shown(image, range, mean_at(image.image, at, x, y, channel));
  };
  const int last = image.image.channels - 1;
  sheet.fill(out.at, [&](int x, int y) {
    const float r = value(out.at, x, y, 0);
    if (last < 2) return packed(r, r, r);
    return packed(r, value(out.at, x, y, 1), value(out.at, x, y, 2));
  });
  for (int c = 0; c <= last; ++c) {
    const PictureRect at = last == 0 ? out.at : sheet.room(width, height);
    if (last > 0) {
      sheet.fill(at, [&](int x, int y) {
        const float v = value(at, x, y, c);
        return packed(v, v, v);
      });
    }
    out.channels.push_back({image.channels[static_cast<size_t>(c)], at});
  }
  return out;
}

}  // namespace

ExportPreview export_preview(const Design& design, Face face, const TextureSetOptions& options,
                             const PreviewSizes& sizes, const std::stop_token& stop) {
  const SetPreview made =
      preview_set(design, face, options, kMaxSide, sizes.swatch_width, sizes.swatch_height, sizes.swatch_mm, stop);
  Sheet sheet(std::max(sizes.swatch_width, kColumns * sizes.side));
  if (!made.images.empty() && !stop.stop_requested()) {
    const PictureRect at = sheet.room(sheet.made().width, sizes.swatch_height);
    sheet.made().swatch = {at.x, at.y, sizes.swatch_width, sizes.swatch_height};
    sheet.fill(sheet.made().swatch, [&](int x, int y) {
      const float* c = &made.swatch.texels[static_cast<size_t>(y * made.swatch.width + x) * 3];
      return packed(c[0], c[1], c[2]);
    });
    for (const PreviewImage& image : made.images) {
      ShownImage shown = lay(sheet, image, sizes.side);
      sheet.made().images.push_back(std::move(shown));
    }
  }
  ExportPreview& out = sheet.made();
  out.alpha = made.alpha, out.coverage = made.coverage, out.bytes_per_texel = made.bytes_per_texel;
  if (!made.images.empty()) out.texels = int64_t{made.images[0].image.width} * made.images[0].image.height;
  return std::move(out);
}

int64_t bytes_on_disk(const ExportPreview& preview, const TextureSize& size) {
  const double wanted = static_cast<double>(size.width) * static_cast<double>(size.height);
  const double made = static_cast<double>(std::max<int64_t>(preview.texels, 1));
  return static_cast<int64_t>(
      2 * static_cast<double>(preview.bytes_per_texel) * made * std::pow(wanted / made, kGrowth) + kSheetBytes);
}

ExportPreviewer::ExportPreviewer(std::shared_ptr<const Design> design, std::function<void()> wake)
    : design_(std::move(design)), runner_(std::move(wake)) {}

void ExportPreviewer::ask(Face face, const TextureSetOptions& options, const PreviewSizes& sizes) {
  TextureSetOptions small = options;
  small.size = std::min(options.size, kMaxSide);
  std::string now = key_of(small) + (face == Face::kFront ? " front" : " back");
  for (const int n : {sizes.swatch_width, sizes.swatch_height, sizes.side}) now.append(" ").append(std::to_string(n));
  if (now == asked_) return;
  asked_ = std::move(now);
  busy_ = true;
  runner_.start(base::task_with_result(
      [design = design_, face, small, sizes](const base::RunningTask& running) {
        return export_preview(*design, face, small, sizes, running.stop());
      },
      [this](base::Result<ExportPreview> made) {
        made_.emplace(std::move(made));
        busy_ = false;
      }));
}

std::optional<base::Result<ExportPreview>> ExportPreviewer::take() {
  runner_.take();
  return std::exchange(made_, std::nullopt);
}

}  // namespace weftlight::session
