#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <memory>

#include "base/file_names.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "commands/drawdown_picture.h"

namespace weftlight::commands {

using base::arg, base::fill, base::tr, base::write_through;
using draft::Rgb;

namespace {

constexpr int64_t kMaxDrawn = 4'000'000;          // crossings
constexpr double kCellMm = 2, kLongestMm = 1000;  // of a crossing, and of a side
constexpr double kPointsPerMm = 72 / 25.4;

base::Failure too_many_for_drawing(const std::string& path, const BitMatrix& cells) {
  return base::failure(base::ErrorKind::kOutput,
                       fill(tr("{ends} by {picks} crossings are too many for a drawing; write a .png instead"),
                            arg("ends", cells.cols()), arg("picks", cells.rows())),
                       path);
}

/// Neighbours of the same colour in a row become one rectangle.
void draw(cairo_t* pen, const ColoredCells& colors, double cell) {
  const BitMatrix& cells = colors.cells();
  cairo_set_antialias(pen, CAIRO_ANTIALIAS_NONE);  // no gaps between neighbours
  for (int y = 0; y < cells.rows(); ++y) {
    for (int x = 0; x < cells.cols();) {
      const Rgb& color = colors.at(x, y);
      int end = x + 1;
      while (end < cells.cols() && colors.at(end, y) == color) ++end;
      cairo_set_source_rgb(pen, static_cast<double>(color.r), static_cast<double>(color.g),
                           static_cast<double>(color.b));
      cairo_rectangle(pen, x * cell, y * cell, (end - x) * cell, cell);
      cairo_fill(pen);
      x = end;
    }
  }
}

}  // namespace

base::Result<void> write_drawdown_drawing(const std::string& path, const ColoredCells& colors) {
  const BitMatrix& cells = colors.cells();
  if (int64_t{cells.rows()} * cells.cols() > kMaxDrawn) return too_many_for_drawing(path, cells);
  const int longer = std::max({cells.rows(), cells.cols(), 1});
  const double cell = std::min(kCellMm, kLongestMm / longer) * kPointsPerMm;
  return write_through(path, [&](const std::string& beside) {
    const auto create = base::extension_of(beside) == ".svg" ? cairo_svg_surface_create : cairo_pdf_surface_create;
    const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> sheet(
        create(beside.c_str(), cells.cols() * cell, cells.rows() * cell), cairo_surface_destroy);
    const std::unique_ptr<cairo_t, void (*)(cairo_t*)> pen(cairo_create(sheet.get()), cairo_destroy);
    draw(pen.get(), colors, cell);
    cairo_surface_finish(sheet.get());
    const cairo_status_t drawn = cairo_status(pen.get()), whole = cairo_surface_status(sheet.get());
    const cairo_status_t status = drawn != CAIRO_STATUS_SUCCESS ? drawn : whole;
    return base::written_unless(status == CAIRO_STATUS_SUCCESS ? "" : cairo_status_to_string(status));
  });
}

}  // namespace weftlight::commands
