// The sheets onto paper: PDF, SVG or PNG through Cairo, into memory.

#include "print/print.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "print/page.h"

namespace weftlight::print {
namespace {

constexpr double kPointsPerMm = 72 / 25.4;

struct Surface {
  explicit Surface(cairo_surface_t* s) : surface(s), context(cairo_create(s)) {}
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;
  ~Surface() {
    cairo_destroy(context);
    cairo_surface_destroy(surface);
  }
  cairo_surface_t* surface;
  cairo_t* context;
};

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void draw(const Sheet& sheet, cairo_t* context, double units_per_mm) {
  cairo_save(context);
  cairo_scale(context, units_per_mm, units_per_mm);
  sheet(Pen(context));
  cairo_restore(context);
}

std::string pdf_of(const std::vector<Sheet>& sheets, const PrintOptions& o) {
  std::string bytes;
  {
    Surface to(cairo_pdf_surface_create_for_stream(append, &bytes, o.paper.width_mm * kPointsPerMm,
                                                   o.paper.height_mm * kPointsPerMm));
    cairo_pdf_surface_set_metadata(to.surface, CAIRO_PDF_METADATA_CREATOR, "Weftlight");
    for (const Sheet& sheet : sheets) {
      draw(sheet, to.context, kPointsPerMm);
      cairo_show_page(to.context);
    }
    cairo_surface_finish(to.surface);
    if (cairo_surface_status(to.surface) != CAIRO_STATUS_SUCCESS) return {};
  }
  return bytes;
}

std::string svg_of(const Sheet& sheet, const PrintOptions& o) {
  std::string bytes;
  {
    Surface to(cairo_svg_surface_create_for_stream(append, &bytes, o.paper.width_mm, o.paper.height_mm));
    cairo_svg_surface_set_document_unit(to.surface, CAIRO_SVG_UNIT_MM);
    draw(sheet, to.context, 1);
    cairo_surface_finish(to.surface);
    if (cairo_surface_status(to.surface) != CAIRO_STATUS_SUCCESS) return {};
  }
  return bytes;
}

std::string png_of(const Sheet& sheet, const PrintOptions& o) {
  const double pixels_per_mm = std::clamp(o.png_dpi, 30.0, 1200.0) / 25.4;
  Surface to(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                        static_cast<int>(std::lround(o.paper.width_mm * pixels_per_mm)),
                                        static_cast<int>(std::lround(o.paper.height_mm * pixels_per_mm))));
  cairo_set_source_rgb(to.context, 1, 1, 1);
  cairo_paint(to.context);
  draw(sheet, to.context, pixels_per_mm);
  std::string bytes;
  return cairo_surface_write_to_png_stream(to.surface, append, &bytes) == CAIRO_STATUS_SUCCESS ? bytes : std::string();
}

}  // namespace

Printed printed(const Design& design, PrintFormat format, const PrintOptions& options) {
  Printed out;
  std::vector<Sheet> sheets = draft_sheets(design, options, out.why);
  if (!out.why.empty()) return out;
  for (Sheet& sheet : list_sheets(design, options)) sheets.push_back(std::move(sheet));
  out.sheets = static_cast<int>(sheets.size());
  if (format == PrintFormat::kPdf) {
    out.files.push_back(pdf_of(sheets, options));
  } else {
    for (const Sheet& sheet : sheets)
      out.files.push_back(format == PrintFormat::kSvg ? svg_of(sheet, options) : png_of(sheet, options));
  }
  if (std::ranges::any_of(out.files, [](const std::string& file) { return file.empty(); })) {
    out.files.clear();
    out.why = "the drawing library refused; there may be too little memory";
  }
  return out;
}

}  // namespace weftlight::print
