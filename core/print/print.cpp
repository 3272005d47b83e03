// Writes the sheets as PDF, SVG or PNG into memory, with Cairo.

#include "print/print.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/text.h"
#include "design/edits.h"
#include "design/repeat.h"
#include "print/sheets.h"

namespace weftlight::print {

using base::ErrorKind, base::Result, base::arg, base::failed, base::failure, base::fill, base::mark, base::tr,
    base::tr_n;

namespace {

constexpr double kPointsPerMm = 72 / 25.4;

struct CairoSurface {
  explicit CairoSurface(cairo_surface_t* s) : surface(s), context(cairo_create(s)) {}
  CairoSurface(const CairoSurface&) = delete;
  CairoSurface& operator=(const CairoSurface&) = delete;
  ~CairoSurface() {
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
    CairoSurface to(cairo_pdf_surface_create_for_stream(append, &bytes, o.paper.width_mm * kPointsPerMm,
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
    CairoSurface to(cairo_svg_surface_create_for_stream(append, &bytes, o.paper.width_mm, o.paper.height_mm));
    cairo_svg_surface_set_document_unit(to.surface, CAIRO_SVG_UNIT_MM);
    draw(sheet, to.context, 1);
    cairo_surface_finish(to.surface);
    if (cairo_surface_status(to.surface) != CAIRO_STATUS_SUCCESS) return {};
  }
  return bytes;
}

/// White paper.
cairo_surface_t* blank_picture(const Paper& paper, double pixels_per_mm) {
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(paper.width_mm * pixels_per_mm)),
                                    static_cast<int>(std::lround(paper.height_mm * pixels_per_mm)));
}

void paint_picture(const Sheet& sheet, cairo_t* context, double pixels_per_mm) {
  cairo_set_source_rgb(context, 1, 1, 1);
  cairo_paint(context);
  draw(sheet, context, pixels_per_mm);
}

std::string png_of(const Sheet& sheet, const PrintOptions& o) {
  const double pixels_per_mm = std::clamp(o.png_dpi, 30.0, 1200.0) / 25.4;
  CairoSurface to(blank_picture(o.paper, pixels_per_mm));
  paint_picture(sheet, to.context, pixels_per_mm);
  std::string bytes;
  return cairo_surface_write_to_png_stream(to.surface, append, &bytes) == CAIRO_STATUS_SUCCESS ? bytes : std::string();
}

constexpr const char* kDrawingFailed = mark("the drawing library failed; there may be too little memory");

/// The first repeat of the design, if that is to be printed.
std::optional<Design> part_of(const Design& design, const PrintOptions& options) {
  if (!options.one_repeat) return {};
  const design::Repeat repeat = design_repeat(design, drawdown(design.draft));
  return with_size(design, repeat.ends, repeat.picks, design.draft.shafts, design.draft.treadles);
}

/// All sheets, at least one. They refer to both designs; `part`: what the grids and lists show.
Result<std::vector<Sheet>> all_sheets(const Design& design, const Design& part, const PrintOptions& options) {
  Result<std::vector<Sheet>> sheets;
  if (options.parts.grids) sheets = draft_sheets(part, options);
  if (!sheets) return sheets;
  for (Sheet& sheet : list_sheets(design, part, options)) sheets->push_back(std::move(sheet));
  if (sheets->empty()) return failure(ErrorKind::kInput, tr("nothing was selected for printing"));
  return sheets;
}

/// Keeps the sheets first_sheet to last_sheet.
Result<void> keep_range(std::vector<Sheet>& sheets, const PrintOptions& options) {
  const auto count = static_cast<int>(sheets.size());
  const int first = std::max(1, options.first_sheet), last = options.last_sheet > 0 ? options.last_sheet : count;
  if (first > count)
    return failure(ErrorKind::kUsage, fill(tr_n("there is no sheet {first}; there is {count} sheet",
                                                "there is no sheet {first}; there are {count} sheets", count),
                                           arg("first", first), arg("count", count)));
  if (first > last)
    return failure(ErrorKind::kUsage, fill(tr("the first sheet, {first}, comes after the last one, {last}"),
                                           arg("first", first), arg("last", last)));
  sheets.erase(sheets.begin() + std::min(last, count), sheets.end());
  sheets.erase(sheets.begin(), sheets.begin() + (first - 1));
  return {};
}

}  // namespace

Result<SheetPicture> picture_of_sheet(const Design& design, const PrintOptions& options, int sheet,
                                      double pixels_per_mm) {
  const std::optional<Design> part = part_of(design, options);
  const Result<std::vector<Sheet>> sheets = all_sheets(design, part ? *part : design, options);
  if (!sheets) return failed(sheets);
  SheetPicture out;
  out.sheets = static_cast<int>(sheets->size());
  out.sheet = std::clamp(sheet, 0, out.sheets - 1);
  CairoSurface to(blank_picture(options.paper, std::clamp(pixels_per_mm, 0.1, 50.0)));
  paint_picture((*sheets)[static_cast<size_t>(out.sheet)], to.context, pixels_per_mm);
  cairo_surface_flush(to.surface);
  const unsigned char* bytes = cairo_image_surface_get_data(to.surface);
  if (bytes == nullptr) return failure(ErrorKind::kMemory, tr(kDrawingFailed));
  out.width = cairo_image_surface_get_width(to.surface);
  out.height = cairo_image_surface_get_height(to.surface);
  const int stride = cairo_image_surface_get_stride(to.surface);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      uint32_t rgb;
      std::memcpy(&rgb, bytes + static_cast<ptrdiff_t>(y) * stride + ptrdiff_t{4} * x, sizeof rgb);
      out.pixels.push_back(0xff000000u | (rgb & 0xff00u) | (rgb >> 16 & 0xffu) | (rgb & 0xffu) << 16);
    }
  return out;
}

std::string sheet_file(const std::string& out, size_t sheet, size_t sheets) {
  if (sheets == 1) return out;
  std::filesystem::path path(out);
  path.replace_filename(path.stem().string() + "-" + std::to_string(sheet + 1) + path.extension().string());
  return path.string();
}

Result<Printed> printed(const Design& design, PrintFormat format, const PrintOptions& options) {
  const std::optional<Design> part = part_of(design, options);
  Result<std::vector<Sheet>> sheets = all_sheets(design, part ? *part : design, options);
  if (!sheets) return failed(sheets);
  if (const auto kept = keep_range(*sheets, options); !kept) return failed(kept);
  Printed out;
  out.sheets = static_cast<int>(sheets->size());
  if (format == PrintFormat::kPdf) {
    out.files.push_back(pdf_of(*sheets, options));
  } else {
    for (const Sheet& sheet : *sheets)
      out.files.push_back(format == PrintFormat::kSvg ? svg_of(sheet, options) : png_of(sheet, options));
  }
  if (std::ranges::any_of(out.files, [](const std::string& file) { return file.empty(); }))
    return failure(ErrorKind::kMemory, tr(kDrawingFailed));
  return out;
}

}  // namespace weftlight::print
