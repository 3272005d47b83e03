#pragma once
// Cloth: one period of threads, laid out in millimetres with their centre lines. Maps, the ray-traced reference and
// the numbers of the lobes are all computed from it.

#include <array>
#include <vector>

#include "design/design.h"
#include "draft/drawdown.h"

namespace weftlight::cloth {

using design::Design, design::Yarn;
using draft::BitMatrix, draft::Face, draft::Rgb, draft::System;

/// Linear-light colour.
struct Linear {
  float r = 0, g = 0, b = 0;
  bool operator==(const Linear&) const = default;
};
Linear linear_from_srgb(Rgb c);
Rgb srgb_from_linear(Linear c);

/// The border between a thread and its neighbour, from the middle between even threads, towards +across.
struct ThreadBorder {
  float aside_mm = 0;  // mean along the thread
  float sway_mm = 0;   // standard deviation along a long thread (thickness.h)
  bool operator==(const ThreadBorder&) const = default;
};

/// One thread of the period.
struct ThreadBody {
  float centre_mm = 0;    // across: x of an end, y of a pick
  float spacing_mm = 0;   // width available to it, >= 0; its neighbours may take some and give some (room_mm)
  float width_mm = 0;     // full width of the flattened cross-section; mean along it
  float height_mm = 0;    // full height of the section; mean along it
  Linear colour;          // linear light; mean along the thread
  int yarn = 0;           // index into Cloth::yarns
  float unevenness = 0;   // standard deviation of its thickness along it, over the mean (thickness.h)
  float diameter_mm = 0;  // of the round thread before it is flattened or jammed: its count goes with this
  float squareness = 0;   // of the section: 0 an ellipse, 1 a rectangle (shaders/thread_section.glsl)
  int place = 0;          // index in the draft, whose threads another order or fewer may stand for
  int dye = -1;           // index into Cloth::dyes; -1: `colour` all along
  int dye_phase = 0;      // where in it the thread starts
  ThreadBorder before = {}, after = {};  // to the thread before it and after it
};

/// Width between a thread's borders, mean along it.
inline float room_mm(const ThreadBody& t) { return t.spacing_mm + t.after.aside_mm - t.before.aside_mm; }

/// One layer of a multi-layer cloth, as ranges of ends and picks.
struct ClothLayer {
  int first_end = 0, ends = 0, first_pick = 0, picks = 0;
  bool operator==(const ClothLayer&) const = default;
};

/// One period of one face. The front has the drawdown, the back its complement in the same order of ends; +z points to
/// the viewer.
struct Cloth {
  float width_mm = 0, depth_mm = 0;  // u period (along the weft), v period (along the warp)
  BitMatrix up;                      // picks x ends; 1: warp on top of this face
  std::vector<ThreadBody> ends, picks;
  std::vector<Yarn> yarns;
  std::vector<std::vector<Linear>> dyes;  // colours along threads, by the place of the thread that is crossed
  // Layers of a multi-layer cloth such as double cloth (layer_plan.h); empty for a single layer, whose threads stand
  // in the draft's order. Otherwise threads are ordered layer by layer, and those of each layer fill the whole period.
  std::vector<ClothLayer> layers;
  // Vertical offset of each thread's centre line at its crossings in its own layer, laid out as `up`; empty where all
  // are 0. Of several layers their levels, of one layer the relief of washing (relief.h).
  std::vector<float> warp_level_mm, weft_level_mm;
  // How far washing has moved each thread sideways at its crossings, towards +across (washed_aside.h); as the levels.
  std::vector<float> warp_aside_mm, weft_aside_mm;
  int first_end = 0, first_pick = 0;  // offset of a single extracted layer in the whole cloth
};

/// The values of a cloth at its crossings; each may be empty.
inline constexpr std::array kCrossingValues{&Cloth::warp_level_mm, &Cloth::weft_level_mm, &Cloth::warp_aside_mm,
                                            &Cloth::weft_aside_mm};

/// Of the colours along a dyed thread, that where it crosses the thread of the other system at `place` in the draft.
template <class Colour>
const Colour& at_place(const std::vector<Colour>& dye, const ThreadBody& thread, int place) {
  return dye[static_cast<size_t>(place + thread.dye_phase) % dye.size()];
}

/// The thread of the other system, in the layer of `thread`, in whose room a position along it lies; mm, which wraps.
const ThreadBody& crossed_at(const Cloth& cloth, System system, int thread, float along_mm);

/// The colour of a thread of the cloth at a position along it.
inline const Linear& colour_along(const Cloth& cloth, System system, int thread, float along_mm) {
  const ThreadBody& body = (system == System::kWarp ? cloth.ends : cloth.picks)[static_cast<size_t>(thread)];
  if (body.dye < 0) return body.colour;
  return at_place(cloth.dyes[static_cast<size_t>(body.dye)], body, crossed_at(cloth, system, thread, along_mm).place);
}

enum class Period { kWholeDraft, kRepeat };

/// Lays a design out; `cells` is its drawdown. A negative thickness (kFromYarn) means the yarn's diameter. A spacing
/// of zero or less means 1.06 of the thread's flattened width: touching, with slight gaps. A thread is never wider
/// than its room; a jammed one becomes narrower, squarer and taller, and an uneven one pushes its neighbours aside.
Cloth lay_out(const Design& design, const BitMatrix& cells, Face face, Period period);

/// Thickness and spacing of a thread in the cloth, from the draft or else from the yarn.
struct ThreadSize {
  float thickness_mm = 0, spacing_mm = 0;
};
ThreadSize thread_size(const Design& design, System system, int thread);

}  // namespace weftlight::cloth
