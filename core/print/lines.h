#pragma once
// Internal to printing: the lines of the lists, and the lists of a planned cloth.

#include <string>
#include <vector>

#include "analysis/measures.h"
#include "analysis/units.h"
#include "design/design.h"
#include "print/print_options.h"

namespace weftlight::print {

using analysis::ClothMeasures, analysis::Units;
using design::Design;
using draft::Draft;

inline constexpr double kTextSize = 3, kTableSize = 2.55;  // font sizes of lists and of tables, mm
inline constexpr double kHeadWidth = 20;                   // of a line, mm

/// One entry of a line, with a chip of its colour, which holds the colour's number, if it has one.
struct Word {
  std::string text;
  int color = -1;  // in the palette; -1: none
};
struct ListLine {
  std::string head;  // at the left; a heading if there are no words
  std::vector<Word> words;
  double pitch_mm = 0;  // from word to word in the columns of a table; 0: one after the other
  bool table_head = false;
  bool heading() const { return words.empty() && !head.empty(); }
};

/// A planned cloth, with its measures.
struct PlannedCloth {
  const Design& design;
  ClothMeasures measures;
  Units units = Units::kMetric;
  double room_mm = 67;  // for the words of a line
};

/// What the window calls the colour; squares alone are alike on a printer without colours.
inline std::string number_of_color(int color) { return std::to_string(color + 1); }
/// Room for a short word in a line of a wide font, mm.
double room_for(const Word& word);

/// All lines of the options' parts, those of threads and picks of `listed`: the design or a part of it.
std::vector<ListLine> list_lines(const Design& design, const Draft& listed, const PrintOptions& options);
/// The lines from `next` on that a column of this height holds; it moves `next` to the first of the next column.
std::vector<ListLine> lines_of_column(const std::vector<ListLine>& lines, size_t& next, double height_mm);

/// "repeat all 12 times".
ListLine line_of_times(int64_t times);

/// Each colour of the threads with its number, its hexadecimal value and its yarns; the list of yarn names them, too.
void list_palette(std::vector<ListLine>& out, const PlannedCloth& cloth);
/// Size, sett, reed, ends, warping.
void list_plan(std::vector<ListLine>& out, const PlannedCloth& cloth);
/// Colours of the warp in the order of winding.
void list_warp_order(std::vector<ListLine>& out, const PlannedCloth& cloth);
/// A table of sleyings and reeds: the setts that are near the planned one.
void list_sleyings(std::vector<ListLine>& out, const PlannedCloth& cloth);
void list_heddles(std::vector<ListLine>& out, const PlannedCloth& cloth);
void list_yarn(std::vector<ListLine>& out, const PlannedCloth& cloth);

}  // namespace weftlight::print
