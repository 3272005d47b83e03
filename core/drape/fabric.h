#pragma once
// A pattern made into cloth: particles with mass, threads that hardly stretch, a bias that gives,
// and stiffness against bending. Units: mm, kg, s (so stiffness in N/m is kg/s2 as it stands).

#include "drape/names.h"
#include "drape/pattern.h"
#include "drape/vec.h"

namespace weftlight::drape {

/// A heavy cotton: 260 g/m2; its bending length, cube root of stiffness over weight, is 22 mm.
struct Fabric {
  double kg_per_m2 = 0.26;
  double thread_n_per_m = 2500;  // stretch along warp and weft
  double bias_n_per_m = 70;      // stretch at 45 degrees to them
  double bending_n_m = 2.8e-5;
  double crease_per_mm = 0;  // curvature from which on a fold stays in the cloth; 0: none does
  double pucker = 0;         // share by which the seams' thread draws them in
};

/// Keeps two particles apart by rest_mm.
struct Stretch {
  uint32_t a, b;
  double rest_mm, compliance;  // s2/kg
};

/// Keeps two triangles in a plane, or as they are creased: sum of weight * position is then `rest`, which is zero or
/// along their normal.
struct Bend {
  std::array<uint32_t, 4> particle;  // the shared edge, then the two far corners
  std::array<double, 4> weight;
  double compliance;
  double yield_mm = 0, set_mm = 0;  // of the sum's length: how far it springs back (0: all the way); what is creased
  Vec3d rest{};
};

struct Cloth {
  std::vector<Vec3d> position, velocity;  // mm, mm/s
  std::vector<double> inverse_mass;       // 1/kg; 0: held, goes where its velocity says
  std::vector<Stretch> stretches;
  std::vector<Bend> bends;
  // Particles near i along the cloth: near[near_first[i]] .. near[near_first[i + 1]], ascending.
  std::vector<uint32_t> near_first, near;
};

/// `near_mm`: how far along the cloth two particles count as near (they never collide).
Cloth weave(const Pattern& pattern, const Fabric& fabric, double near_mm);

/// Lets what is bent beyond its spring stay so, by that share of what is beyond; turns the creases with the cloth.
void set_creases(Cloth& cloth, double share);

}  // namespace weftlight::drape
