#pragma once
// A draft on paper: title, threading, tie-up, treadling and drawdown over as many sheets as the scale takes, then
// lists for the loom (ends, picks, heddles), yarn, and a swatch true to size.

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/threads.h"
#include "draft/design.h"
#include "print/names.h"

namespace weftlight::print {

struct Paper {
  double width_mm = 210, height_mm = 297;
  bool operator==(const Paper&) const = default;
};
inline constexpr Paper kA4{210, 297}, kLetter{215.9, 279.4};
struct NamedPaper {
  const char* name;
  Paper paper;  // upright
};
inline constexpr NamedPaper kPapers[] = {
    {"A4", kA4}, {"A3", {297, 420}}, {"A5", {148, 210}}, {"Letter", kLetter}, {"Legal", {215.9, 355.6}}};

enum class PrintFormat { kPdf, kSvg, kPng };

/// What is printed.
struct PrintParts {
  bool grids = true;    // threading, tie-up, treadling or liftplan, drawdown
  bool lists = true;    // what to thread and to tread, and in which colours
  bool heddles = true;  // on each shaft
  bool yarn = true;     // lengths, weights, sett
  bool swatch = true;   // true to size
  bool operator==(const PrintParts&) const = default;
};

/// Each under the name that a command gives it, with the words of the window.
struct NamedPart {
  const char *name, *words;
  bool PrintParts::*on;
};
inline constexpr NamedPart kParts[] = {{"draft", "Draft and drawdown", &PrintParts::grids},
                                       {"lists", "Threading and treadling lists", &PrintParts::lists},
                                       {"heddles", "Heddles on each shaft", &PrintParts::heddles},
                                       {"yarn", "Yarn: lengths, weights, sett", &PrintParts::yarn},
                                       {"swatch", "Swatch, true to size", &PrintParts::swatch}};

struct PrintOptions {
  Paper paper = kA4;
  double cell_mm = 0;            // side of a cell, 0.5..20; 0: what fits, at least kSmallestCell
  int heavy_lines = 4;           // a heavier line every so many threads; 0: none
  bool end1_right = true;        // which side end 1 is drawn on
  bool pick1_bottom = false;     // picks are read upwards
  bool threading_below = false;  // the drawdown
  double png_dpi = 150;
  PrintParts parts{};
  ClothPlan plan{};    // of the cloth that the yarn is for
  std::string name{};  // stands over a draft without a title; empty: "Draft"
  bool operator==(const PrintOptions&) const = default;
};
inline constexpr double kSmallestCell = 1.6;  // mm, where the scale is not said
inline constexpr int kMaxSheets = 400;

struct Printed {
  std::vector<std::string> files;  // PDF: one; SVG and PNG: one a sheet
  int sheets = 0;
  std::string why;  // why there are none
};
Printed printed(const Design& design, PrintFormat format, const PrintOptions& options);

/// One sheet as it will be, for looking at before it is printed.
struct SheetPicture {
  int width = 0, height = 0;
  std::vector<uint32_t> pixels;  // bytes R, G, B, 255; row 0 on top
  int sheet = 0, sheets = 0;     // which of how many; the last where there are fewer than were asked for
  std::string why;               // why there is none
};
SheetPicture picture_of_sheet(const Design& design, const PrintOptions& options, int sheet, double pixels_per_mm);

/// OUT.svg of one sheet; of several OUT-1.svg, OUT-2.svg ...; `sheet` from 0.
std::string sheet_file(const std::string& out, size_t sheet, size_t sheets);

}  // namespace weftlight::print
