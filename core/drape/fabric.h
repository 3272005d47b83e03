#pragma once
// A pattern as simulated cloth: particles with mass, stiff springs along the threads, soft ones along the bias, and
// stiffness against bending. Units: mm, kg, s; a stiffness of 1 N/m is 1 kg/s2.

#include "drape/pattern.h"
#include "drape/vec.h"

namespace weftlight::drape {

/// By default a heavy cotton: 260 g/m2, bending length (cube root of stiffness over weight) 22 mm.
struct Fabric {
  double kg_per_m2 = 0.26;
  double thread_n_per_m = 2500;  // stretch along warp and weft
  double bias_n_per_m = 70;      // stretch at 45 degrees to them
  double bending_n_m = 2.8e-5;
  double crease_per_mm = 0;  // curvature above which a fold stays in the cloth; 0: none stays
  double pucker = 0;         // fraction by which the sewing thread shortens the seams
};

/// Keeps two particles at the distance rest_mm.
struct Stretch {
  uint32_t a, b;
  double rest_mm, compliance;  // s2/kg
};

/// Keeps two triangles in one plane, or at the angle of their crease: the sum of weight * position is then `rest`,
/// which is zero or along their normal.
struct Bend {
  std::array<uint32_t, 4> particle;  // the shared edge, then the two far corners
  std::array<double, 4> weight;
  double compliance;
  double yield_mm = 0, set_mm = 0;  // of the sum's length: elastic limit (0: no limit); permanent part
  Vec3d rest{};
};

struct SimulatedCloth {
  std::vector<Vec3d> position, velocity;  // mm, mm/s
  std::vector<double> inverse_mass;       // 1/kg; 0: held, moves with its velocity only
  std::vector<Stretch> stretches;
  std::vector<Bend> bends;
  // Neighbours of particle i along the cloth: near[near_first[i]] .. near[near_first[i + 1]], ascending.
  std::vector<uint32_t> near_first, near;
};

/// `near_mm`: distance along the cloth up to which two particles are neighbours, which never collide.
SimulatedCloth make_cloth(const Pattern& pattern, const Fabric& fabric, double near_mm);

/// Makes the given fraction of the bending beyond the elastic limit permanent, and rotates the creases with the cloth.
void set_creases(SimulatedCloth& cloth, double fraction);

}  // namespace weftlight::drape
