#pragma once
// Internal to printing: the lines of the lists, and the lists of a planned cloth.

#include <string>
#include <vector>

#include "analysis/measures.h"
#include "analysis/units.h"
#include "design/design.h"

namespace weftlight::print {

using analysis::ClothMeasures, analysis::Units;
using design::Design;

/// One entry of a line, with a colour chip if it has a colour.
struct Word {
  std::string text;
  int color = -1;  // in the palette; -1: none
};
struct ListLine {
  std::string head;  // at the left; a heading if there are no words
  std::vector<Word> words;
  double pitch_mm = 0;  // from word to word in the columns of a table; 0: one after the other
  bool heading() const { return words.empty() && !head.empty(); }
};

/// A planned cloth, with its measures.
struct PlannedCloth {
  const Design& design;
  ClothMeasures measures;
  Units units = Units::kMetric;
};

/// Size, sett, reed, ends, warping.
void list_plan(std::vector<ListLine>& out, const PlannedCloth& cloth);
/// Colours of the warp in the order of winding.
void list_warp_order(std::vector<ListLine>& out, const PlannedCloth& cloth);
/// A table of sleyings and reeds: the setts that are near the planned one.
void list_sleyings(std::vector<ListLine>& out, const PlannedCloth& cloth);
void list_heddles(std::vector<ListLine>& out, const PlannedCloth& cloth);
void list_yarn(std::vector<ListLine>& out, const PlannedCloth& cloth);

}  // namespace weftlight::print
