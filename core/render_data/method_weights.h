#pragma once
// Which methods of `auto` the visible cloth needs, and what fraction of it each draws, from the footprints of the
// triangles. Without OpenGL and without reading pixels back; cloth hidden behind other folds counts, too.

#include <array>

#include "light/lod_table.h"
#include "render_data/ambient.h"
#include "scene/camera.h"

namespace weftlight::render_data {

using light::LodDemand, light::LodTable;
using scene::Camera;

/// A method below this weight changes no colour visibly.
inline constexpr float kNegligibleWeight = 0.05f;

inline constexpr size_t kFootprintBins = 48;  // three an octave, from 1/256 to 256 yarns a pixel

struct MethodWeights {
  std::array<float, 4> of{};     // yarn, cell, repeat, cloth; sum 1, or all 0 without cloth on screen
  float yarns_per_pixel = 0;     // mean of the logarithm
  std::array<bool, 4> needed{};  // for more than a few pixels
  // Fraction of the cloth by footprint: bin k is around footprint_of_bin(k).
  std::array<float, kFootprintBins> footprints{};
  // Bounds of the visible cloth, millimetres of (u, v); empty if none is visible.
  glm::vec2 visible_low{0}, visible_high{0};
};

/// The part of the cloth in a picture, millimetres of (u, v), and its smallest pixel; empty: unknown.
struct VisiblePart {
  float u0 = 0, v0 = 0, u1 = 0, v1 = 0;
  float pixel_mm = 0;
  bool empty() const { return u1 <= u0 || v1 <= v0 || pixel_mm <= 0; }
};
/// Ignores slivers.
VisiblePart visible_part(const MethodWeights& weights, float spacing_mm);

/// Yarns a pixel.
float footprint_of_bin(size_t k);
MethodWeights method_weights(const PreparedMesh& mesh, const Camera& camera, int width, int height, float spacing_mm,
                             const std::array<float, 3>& edges);

/// The tolerance with the least error within a time budget, between kFinestTolerance and kCoarsestTolerance. pixels:
/// of cloth; as_measured: cost on this machine over that of the LOD table.
inline constexpr float kFinestTolerance = 0.02f, kCoarsestTolerance = 0.5f;
float expected_ms(const LodTable& lod_table, const MethodWeights& weights, float pixels, const LodDemand& demand);
float tolerance_within(const LodTable& lod_table, const MethodWeights& weights, float pixels, float as_measured,
                       float budget_ms);

}  // namespace weftlight::render_data
