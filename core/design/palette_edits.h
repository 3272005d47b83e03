#pragma once
// Edits of the lists of colours and yarns: one is deleted, equal ones are merged, unused ones removed, all sorted. The
// cloth stays as it is, but for threads of a deleted colour or yarn, which get the one that takes its place. Threads of
// the sections (design.h) count as threads. Versions have lists of their own, which stay.

#include <vector>

#include "design/design.h"

namespace weftlight::design {

/// Colours in the order of the hues (greys first, light to dark), or from light to dark.
enum class ColorOrder { kHue, kLightness };

/// The colour of the palette that is closest to it to the eye, and another one; -1 in a palette of one colour.
int closest_color(const Design& design, int color);
/// Another yarn, of the same fibre if there is one, of the nearest count; -1 if it is the only one.
int closest_yarn(const Design& design, int yarn);

/// How many threads of the draft and of its sections have each colour of the palette, or each yarn.
std::vector<int> uses_of_colors(const Design& design);
std::vector<int> uses_of_yarns(const Design& design);

/// Threads of that colour get the colour `heir`. Unchanged if they are the same, or out of range.
Design without_color(Design design, int color, int heir);
Design without_yarn(Design design, int yarn, int heir);
/// Keeps the first of each colour, to within the 8 bits of a screen; of yarns that are equal in all, the name too.
Design with_merged_colors(Design design);
Design with_merged_yarns(Design design);
/// Without those that no thread has; one stays in any case.
Design without_unused_colors(Design design);
Design without_unused_yarns(Design design);
Design with_sorted_colors(Design design, ColorOrder order);
/// By name.
Design with_sorted_yarns(Design design);

/// Warp and weft exchange their colours, whose stripes go on as far as they are needed.
Design with_swapped_systems(Design design);
/// The lightest colour that threads of the draft have, their dyes included, takes the place of the darkest one, the
/// second lightest of the second darkest, and so on.
Design with_swapped_lightness(Design design);

/// `steps` colours from one to the other, both included, at equal distances to the eye; 2 at least.
std::vector<Rgb> gradient(Rgb from, Rgb to, int steps);
/// The threads in as many colours from one to the other as there are steps, but no more than threads. In equal stripes,
/// or, `blended`, with neighbouring colours in alternation, so that two yarns are enough to go over from one to the
/// other. The palette gets the colours that it lacks. Unchanged if it has no room for them.
struct Gradient {
  Rgb from, to;
  int steps = 5;
  bool blended = false;
  bool operator==(const Gradient&) const = default;
};
Design with_gradient(Design design, System system, const std::vector<int>& threads, const Gradient& gradient);

}  // namespace weftlight::design
