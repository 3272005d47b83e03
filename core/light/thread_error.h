#pragma once
// How far few samples a pixel are off near the threads of one cloth: footprints alone do not know a weave.
// SampledMethod `yarn` (shaders/method_yarn.glsl) is run at some pixels, by its lattices and by a much finer one.

#include <array>

#include "cloth/cloth.h"
#include "light/lod_table.h"
#include "light/names.h"

namespace weftlight::light {

/// Yarns a pixel, as the root of its area.
inline constexpr std::array<float, 5> kErrorFootprints{0.0625f, 0.125f, 0.25f, 0.5f, 1};
/// Of formulas::lattice_of(): of 2 to 21 points.
inline constexpr size_t kFirstErrorLattice = 1, kErrorLattices = 6;

/// Relative RMSE under the chart's light, straight on or at a slant, where it is more; neither more samples nor a finer
/// footprint has more.
struct ThreadErrors {
  std::array<std::array<float, kErrorLattices>, kErrorFootprints.size()> rel_rmse{};
  bool measured = false;
  bool operator==(const ThreadErrors&) const = default;
};

/// Of the front. Of a cloth of very many crossings: of a window in its middle. Not measured where there are no threads,
/// or several layers of very many.
ThreadErrors thread_errors(const Cloth& cloth);

/// The ladder for that cloth: rows of rung `yarn` with what was measured where that is less. As it is where nothing
/// was.
LodTable fitted(LodTable lod_table, const ThreadErrors& errors);

}  // namespace weftlight::light
