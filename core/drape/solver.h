#pragma once
// Simulates a cloth that falls on a body until it rests. Deterministic: fixed order, no randomness.

#include <functional>

#include "drape/fabric.h"

namespace weftlight::drape {

/// Signed distance to a body in mm, negative inside. Only its zero set and its sign must be exact; its gradient is
/// measured.
using Distance = std::function<float(Vec3)>;

struct Fall {
  double seconds = 4;
  int contact_updates_per_second = 160;  // how often contacts are searched
  int substeps = 12;                     // between two searches for contacts
  int rest_substeps = 0;                 // the same near rest, to remove the last stretch of the threads; 0: `substeps`
  double body_gap_mm = 3.5;              // distance of the middle of the cloth from the body
  double cloth_gap_mm = 8;               // distance of sheets of cloth; above half the diagonal of a cell
  double body_friction = 0.4, cloth_friction = 0.3;
  double crease_fraction = 0.1;  // fraction of bending that becomes permanent between two searches
  double drag_per_second = 1.5;  // drag: fraction of the speed lost per second
  double slow_start_s = 0;       // time at the start with ten times the drag, as if lowered by hand
  double rest_from = 0.7;        // fraction of the time after which the drag grows, to bring rest
  /// Distance at which sheets of cloth are searched: they may come 6 mm closer between two searches.
  double reach_mm() const { return cloth_gap_mm + 6; }
  /// Sets the velocities of the held particles until the next search.
  std::function<void(SimulatedCloth&, double time, double until)> move_held;
  /// Accelerations of the particles beside gravity until the next search, mm/s2.
  std::function<void(const SimulatedCloth&, double time, std::vector<Vec3d>& acceleration)> accelerate;
  /// Called before each search for contacts; false stops the simulation.
  std::function<bool(double progress)> keep_going;
};

void simulate(SimulatedCloth& cloth, const Distance& body, const Fall& settings);

/// The point of the surface that is reached from p along the gradient of the distance.
Vec3 project_to_surface(const Distance& body, Vec3 p);

}  // namespace weftlight::drape
