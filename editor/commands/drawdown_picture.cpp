#include "commands/drawdown_picture.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <memory>

#include "base/files.h"
#include "base/text.h"
#include "files/files.h"

namespace weftlight::commands {

using base::arg, base::fill, base::tr, base::write_through;
using draft::Rgb;
using files::Image, files::PixelType, files::write_image;

namespace {

constexpr int64_t kMaxPixels = int64_t{1} << 27;  // 1.6 GB of float texels
constexpr int64_t kMaxDrawn = 4'000'000;          // crossings in a vector drawing
constexpr double kCellMm = 2, kLongestMm = 1000;  // in a vector drawing
constexpr double kPointsPerMm = 72 / 25.4;

const Rgb& color_at(const BitMatrix& cells, const Draft& draft, DrawdownOrigin origin, int x, int y) {
  const int end = origin.end1_left ? x : cells.cols() - 1 - x, pick = origin.pick1_bottom ? cells.rows() - 1 - y : y;
  const int color =
      cells.get(pick, end) ? draft.warp.color[static_cast<size_t>(end)] : draft.weft.color[static_cast<size_t>(pick)];
  return draft.palette[static_cast<size_t>(color)];
}

/// Pixels per crossing, 1 to 16, so that the longer side is about 1,024.
int cell_size(const BitMatrix& cells) {
  constexpr int kWanted = 1024, kLargest = 16;
  return std::clamp(kWanted / std::max({cells.rows(), cells.cols(), 1}), 1, kLargest);
}

base::Failure too_many_for_image(const std::string& path, const BitMatrix& cells) {
  return base::failure(base::ErrorKind::kOutput,
                       fill(tr("{ends} by {picks} crossings are too many for a picture; write text instead"),
                            arg("ends", cells.cols()), arg("picks", cells.rows())),
                       path);
}

base::Failure too_many_for_drawing(const std::string& path, const BitMatrix& cells) {
  return base::failure(base::ErrorKind::kOutput,
                       fill(tr("{ends} by {picks} crossings are too many for a drawing; write a .png instead"),
                            arg("ends", cells.cols()), arg("picks", cells.rows())),
                       path);
}

/// Neighbours of the same colour in a row become one rectangle.
void draw(cairo_t* pen, const BitMatrix& cells, const Draft& draft, DrawdownOrigin origin, double cell) {
  cairo_set_antialias(pen, CAIRO_ANTIALIAS_NONE);  // no gaps between neighbours
  for (int y = 0; y < cells.rows(); ++y) {
    for (int x = 0; x < cells.cols();) {
      const Rgb& color = color_at(cells, draft, origin, x, y);
      int end = x + 1;
      while (end < cells.cols() && color_at(cells, draft, origin, end, y) == color) ++end;
      cairo_set_source_rgb(pen, static_cast<double>(color.r), static_cast<double>(color.g),
                           static_cast<double>(color.b));
      cairo_rectangle(pen, x * cell, y * cell, (end - x) * cell, cell);
      cairo_fill(pen);
      x = end;
    }
  }
}

}  // namespace

base::Result<void> write_drawdown_image(const std::string& path, const BitMatrix& cells, const Draft& draft,
                                        DrawdownOrigin origin) {
  if (int64_t{cells.rows()} * cells.cols() > kMaxPixels) return too_many_for_image(path, cells);
  const int size = cell_size(cells);
  Image image{cells.cols() * size, cells.rows() * size, 3, {}};
  image.texels.reserve(static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * 3);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Rgb& c = color_at(cells, draft, origin, x / size, y / size);
      image.texels.insert(image.texels.end(), {c.r, c.g, c.b});
    }
  }
  return write_image(path, image, PixelType::kU8);
}

base::Result<void> write_drawdown_points(const std::string& path, const BitMatrix& cells) {
  if (int64_t{cells.rows()} * cells.cols() > kMaxPixels) return too_many_for_image(path, cells);
  Image image{cells.cols(), cells.rows(), 3, {}};
  image.texels.reserve(static_cast<size_t>(cells.cols()) * static_cast<size_t>(cells.rows()) * 3);
  for (int pick = 0; pick < cells.rows(); ++pick)
    for (int end = cells.cols() - 1; end >= 0; --end)
      image.texels.insert(image.texels.end(), 3, cells.get(pick, end) ? 0.0f : 1.0f);
  return write_image(path, image, PixelType::kU8);
}

base::Result<void> write_drawdown_drawing(const std::string& path, const BitMatrix& cells, const Draft& draft,
                                          DrawdownOrigin origin) {
  if (int64_t{cells.rows()} * cells.cols() > kMaxDrawn) return too_many_for_drawing(path, cells);
  const int longer = std::max({cells.rows(), cells.cols(), 1});
  const double cell = std::min(kCellMm, kLongestMm / longer) * kPointsPerMm;
  return write_through(path, [&](const std::string& beside) {
    const auto create =
        beside.ends_with(".svg") || beside.ends_with(".SVG") ? cairo_svg_surface_create : cairo_pdf_surface_create;
    const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> sheet(
        create(beside.c_str(), cells.cols() * cell, cells.rows() * cell), cairo_surface_destroy);
    const std::unique_ptr<cairo_t, void (*)(cairo_t*)> pen(cairo_create(sheet.get()), cairo_destroy);
    draw(pen.get(), cells, draft, origin, cell);
    cairo_surface_finish(sheet.get());
    const cairo_status_t drawn = cairo_status(pen.get()), whole = cairo_surface_status(sheet.get());
    const cairo_status_t status = drawn != CAIRO_STATUS_SUCCESS ? drawn : whole;
    return base::written_unless(status == CAIRO_STATUS_SUCCESS ? "" : cairo_status_to_string(status));
  });
}

}  // namespace weftlight::commands
