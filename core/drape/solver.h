#pragma once
// Lets a cloth fall on a body until it rests. Deterministic: fixed order, no randomness.

#include <functional>

#include "drape/fabric.h"
#include "drape/names.h"

namespace weftlight::drape {

/// Signed distance to a body in mm, negative inside; only its zero set and its direction need be
/// true, its slope is measured.
using Distance = std::function<float(Vec3)>;

struct Fall {
  double seconds = 4;
  int looks_per_second = 160;  // contacts are found this often
  int substeps = 12;           // between two looks
  int rest_substeps = 0;       // the same once it comes to rest, where threads' last stretch goes; 0: no others
  double skin_mm = 3.5;        // the middle of the cloth stays this far from the body
  double apart_mm = 8;         // and sheets of cloth this far from each other (over half a cell's diagonal)
  double body_friction = 0.4, cloth_friction = 0.3;
  double crease_share = 0.1;    // of what is bent too far stays so from one look to the next
  double air_per_second = 1.5;  // share of the speed that the air takes
  double let_down_s = 0;        // for so long it is let down by hand: in air ten times as thick
  double rest_from = 0.7;       // share of the time after which the air thickens, to bring rest
  /// How far off sheets are looked for: they may come 6 mm nearer between two looks.
  double reach_mm() const { return apart_mm + 6; }
  /// Moves the held particles (sets their velocity) for the time to the next look.
  std::function<void(Cloth&, double time, double until)> lead;
  /// What pushes the particles beside their weight until the next look, mm/s2.
  std::function<void(const Cloth&, double time, std::vector<Vec3d>& push)> push;
  /// Asked before each look, with the share of the time that is over; false: leave it as it is.
  std::function<bool(double share)> go_on;
};

void fall(Cloth& cloth, const Distance& body, const Fall& how);

/// The place on the surface that p slides to along the slope of the distance.
Vec3 settle(const Distance& body, Vec3 p);

/// A place on the body's outside, skin_mm from it, if p is nearer than that; else p.
Vec3 push_out(const Distance& body, Vec3 p, float skin_mm);

}  // namespace weftlight::drape
