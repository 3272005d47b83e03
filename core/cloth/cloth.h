#pragma once
// Cloth: one period of threads laid out in millimetres, and their centre lines as bodies.
// Everything that has a shape or meets the light is made from this value: the maps, the
// ray-traced reference and the numbers of the lobes.

#include <vector>

#include "cloth/names.h"
#include "draft/design.h"
#include "draft/drawdown.h"

namespace weftlight::cloth {

/// Linear-light colour.
struct Linear {
  float r = 0, g = 0, b = 0;
};
Linear linear_from_srgb(Rgb c);
Rgb srgb_from_linear(Linear c);

/// One thread of the period.
struct ThreadBody {
  float centre_mm = 0;   // across: x of an end, y of a pick
  float spacing_mm = 0;  // room it has, >= 0
  float width_mm = 0;    // full width of the flattened cross-section
  float height_mm = 0;   // full height of it
  Linear colour;         // linear light
  int yarn = 0;          // index into Cloth::yarns
  float swell = 0;       // spread of its thickness along it, over the mean (thickness.h)
};

/// Threads that lie side by side, in a cloth of several layers: runs of its ends and picks.
struct Layer {
  int first_end = 0, ends = 0, first_pick = 0, picks = 0;
  bool operator==(const Layer&) const = default;
};

/// One period of one face. Front: up = drawdown; back: its complement, same end order, seen with +z
/// towards the viewer.
struct Cloth {
  float width_mm = 0, depth_mm = 0;  // u period (along the weft), v period (along the warp)
  BitMatrix up;                      // picks x ends; 1: warp on top of this face
  std::vector<ThreadBody> ends, picks;
  std::vector<Yarn> yarns;
  // Double cloth and its like (layers.h); empty: one layer, threads in the draft's order. Else threads stand layer by
  // layer; those of each layer fill the whole period.
  std::vector<Layer> layers;
  // Then, as `up`: how far each thread's centre line is moved where it crosses one of its own layer.
  std::vector<float> warp_level_mm, weft_level_mm;
  int first_end = 0, first_pick = 0;  // of one layer alone: where its threads stand in the cloth
};

enum class Period { kWholeDraft, kRepeat };

/// Lays the design out. `cells` is its drawdown. A thickness below zero (kFromYarn) is the yarn's diameter;
/// a spacing of zero or below is 1.06 of the thread's own flattened width: touching, with slight gaps. A
/// thread is never wider than its room: jammed, it is narrower and taller.
Cloth lay_out(const Design& design, const BitMatrix& cells, Face face, Period period);

/// What a thread measures in the cloth, whether the draft gives it or leaves it to the yarn.
struct ThreadSize {
  float thickness_mm = 0, spacing_mm = 0;
};
ThreadSize thread_size(const Design& design, System system, int thread);

}  // namespace weftlight::cloth
