#pragma once
// What is printed of a draft, and how: paper, scale, orientation and parts.

#include <string>

#include "analysis/units.h"
#include "base/mark.h"
#include "draft/heavy_lines.h"

namespace weftlight::print {

using analysis::Units;

struct Paper {
  double width_mm = 210, height_mm = 297;
  bool operator==(const Paper&) const = default;
};
inline constexpr Paper kA4{210, 297}, kLetter{215.9, 279.4};
struct NamedPaper {
  const char* name;
  Paper paper;  // portrait
};
inline constexpr NamedPaper kPapers[] = {
    {"A4", kA4}, {"A3", {297, 420}}, {"A5", {148, 210}}, {"Letter", kLetter}, {"Legal", {215.9, 355.6}}};

enum class PrintFormat { kPdf, kSvg, kPng };

/// The parts that are printed.
struct PrintParts {
  bool grids = true;    // threading, tie-up, treadling or liftplan, drawdown
  bool lists = true;    // threading, treadling and colours as numbers
  bool heddles = true;  // per shaft
  bool yarn = true;     // lengths, weights, sett
  bool swatch = true;   // at actual size
  bool plan = true;     // size, sett, reed, warping, sleying table
  bool operator==(const PrintParts&) const = default;
};

/// Each with its name for commands and its label; show tr(label).
struct NamedPart {
  const char *name, *label;
  bool PrintParts::*on;
};
inline constexpr NamedPart kParts[] = {{"draft", base::mark("Draft and drawdown"), &PrintParts::grids},
                                       {"lists", base::mark("Threading and treadling lists"), &PrintParts::lists},
                                       {"heddles", base::mark("Heddles on each shaft"), &PrintParts::heddles},
                                       {"yarn", base::mark("Yarn: lengths, weights, sett"), &PrintParts::yarn},
                                       {"swatch", base::mark("Swatch, actual size"), &PrintParts::swatch},
                                       {"plan", base::mark("Plan: size, sett, reed, warping"), &PrintParts::plan}};

struct PrintOptions {
  Paper paper = kA4;
  double cell_mm = 0;                    // side of a cell, 0.5..20; 0: fitted to the sheet, at least kMinCell_mm
  int heavy_lines = draft::kHeavyLines;  // a heavier line every n threads; 0: none
  bool end1_right = true;                // end 1 on the right
  bool pick1_bottom = false;             // pick 1 at the bottom
  bool threading_below = false;          // below the drawdown
  double png_dpi = 150;
  PrintParts parts{};
  bool one_repeat = false;              // grids and lists of one repeat; all else is of the whole cloth
  int first_sheet = 1, last_sheet = 0;  // what printed() makes of all sheets; 0: to the last
  Units units = Units::kMetric;
  std::string name{};  // title of a draft without one; empty: "Draft"
  bool operator==(const PrintOptions&) const = default;
};
inline constexpr double kMinCell_mm = 1.6;  // of a fitted scale
inline constexpr int kMaxSheets = 400;

}  // namespace weftlight::print
