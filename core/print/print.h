#pragma once
// A draft on paper: title, threading, tie-up, treadling and drawdown over as many sheets as the scale takes, then
// lists for the loom (plan, threading, treadling, heddles), yarn, and a swatch at actual size.

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "design/design.h"
#include "print/print_options.h"

namespace weftlight::print {

using design::Design;

struct Printed {
  std::vector<std::string> files;  // PDF: one; SVG and PNG: one per sheet
  int sheets = 0;
};
/// An error if there are too many sheets, none, or none of those numbers.
base::Result<Printed> printed(const Design& design, PrintFormat format, const PrintOptions& options);

/// Print preview of one sheet.
struct SheetPicture {
  int width = 0, height = 0;
  std::vector<uint32_t> pixels;  // bytes R, G, B, 255; row 0 on top
  int sheet = 0, sheets = 0;     // clamped to the number of sheets
};
base::Result<SheetPicture> picture_of_sheet(const Design& design, const PrintOptions& options, int sheet,
                                            double pixels_per_mm);

/// File name of a sheet: OUT.svg if there is only one, otherwise OUT-1.svg, OUT-2.svg ...; `sheet` counts from 0.
std::string sheet_file(const std::string& out, size_t sheet, size_t sheets);

}  // namespace weftlight::print
