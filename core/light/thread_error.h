#pragma once
// Sampling error of method `yarn` on one cloth, since footprints alone do not know a weave: the method
// (shaders/method_yarn.glsl) is evaluated at some pixels with its own lattices and with a much finer one.

#include <array>

#include "cloth/cloth.h"
#include "light/lod_table.h"

namespace weftlight::light {

using cloth::Cloth;

/// Yarns a pixel (square root of its area).
inline constexpr std::array<float, 5> kErrorFootprints{0.0625f, 0.125f, 0.25f, 0.5f, 1};
/// Indices of formulas::lattice_of(): 2 to 21 points.
inline constexpr size_t kFirstErrorLattice = 1, kErrorLattices = 6;

/// Relative RMSE under the chart's light, the larger of a straight and a slanted view; it does not grow with samples
/// nor with a finer footprint.
struct ThreadErrors {
  std::array<std::array<float, kErrorLattices>, kErrorFootprints.size()> rel_rmse{};
  bool measured = false;
  bool operator==(const ThreadErrors&) const = default;
};

/// Errors of the front; for a cloth of very many crossings, of a window in its centre. Not measured without threads,
/// or for several layers of very many crossings.
ThreadErrors thread_errors(const Cloth& cloth);

/// The LOD table fitted to a cloth: rows of method `yarn` take the measured errors where these are smaller. Unchanged
/// if nothing was measured.
LodTable fitted(LodTable lod_table, const ThreadErrors& errors);

}  // namespace weftlight::light
