#pragma once
// A draft on paper: title, threading, tie-up, treadling and drawdown over as many sheets as the scale takes, then
// lists for the loom (ends, picks, heddles), yarn, and a swatch true to size.

#include <string>
#include <vector>

#include "draft/design.h"
#include "print/names.h"

namespace weftlight::print {

struct Paper {
  double width_mm = 210, height_mm = 297;
};
inline constexpr Paper kA4{210, 297}, kLetter{215.9, 279.4};

enum class PrintFormat { kPdf, kSvg, kPng };

struct PrintOptions {
  Paper paper = kA4;
  double cell_mm = 0;       // side of a cell, 0.5..20; 0: what fits, at least kSmallestCell
  int heavy_lines = 4;      // a heavier line every so many threads; 0: none
  bool end1_right = false;  // which side end 1 is drawn on
  double png_dpi = 150;
};
inline constexpr double kSmallestCell = 1.6;  // mm, where the scale is not said
inline constexpr int kMostSheets = 400;

struct Printed {
  std::vector<std::string> files;  // PDF: one; SVG and PNG: one a sheet
  int sheets = 0;
  std::string why;  // why there are none
};
Printed printed(const Design& design, PrintFormat format, const PrintOptions& options);

}  // namespace weftlight::print
