#pragma once
// The marks of a ruler in centimetres or inches, as close together as its scale leaves them legible.

#include <string>
#include <vector>

namespace weftlight::ui {

struct RulerMark {
  double mm = 0;
  std::string text;  // empty: a short mark between two numbers
};

/// A stretch of a ruler on the screen.
struct RulerStretch {
  double first_mm = 0, last_mm = 0;
  double px_a_mm = 1;
  double label_px = 40, mark_px = 5;  // least distance of two numbers, and of two marks
  bool imperial = false;
};

/// In order, those of the stretch alone. Empty without a length, or where numbers would lie further apart than a
/// hundred kilometres.
std::vector<RulerMark> ruler_marks(const RulerStretch& stretch);

/// "cm" or "in".
const char* ruler_unit(bool imperial);

}  // namespace weftlight::ui
