#pragma once
// Which rungs of `auto` the cloth on screen needs, and which share of it each draws, from the triangles' footprints.
// Knows no OpenGL and does not read pixels back; what hides behind other folds counts too.

#include <array>

#include "light/lod_table.h"
#include "render_data/ambient.h"
#include "render_data/camera.h"
#include "render_data/names.h"

namespace weftlight::render_data {

/// So little of a rung changes no colour by what an eye could tell.
inline constexpr float kUnseenWeight = 0.05f;

inline constexpr size_t kFootprintBins = 48;  // three an octave, from 1/256 to 256 yarns a pixel

struct MethodWeights {
  std::array<float, 4> of{};     // yarn, cell, repeat, cloth; sum 1, or all 0 without cloth on screen
  float yarns_per_pixel = 0;     // mean of the logarithm
  std::array<bool, 4> needed{};  // by more than a few pixels
  // Shares of the cloth by its pixels' size: bin k about footprint_of_bin(k).
  std::array<float, kFootprintBins> footprints{};
  // What is on screen of the cloth, millimetres of (u, v); empty where none is.
  glm::vec2 seen_low{0}, seen_high{0};
};

/// The part of the cloth that a picture shows, millimetres of (u, v), and its smallest pixel there; empty: not known.
struct SeenPart {
  float u0 = 0, v0 = 0, u1 = 0, v1 = 0;
  float pixel_mm = 0;
  bool empty() const { return u1 <= u0 || v1 <= v0 || pixel_mm <= 0; }
};
/// But for slivers.
SeenPart seen_part(const MethodWeights& shares, float spacing_mm);

/// Yarns a pixel.
float footprint_of_bin(size_t k);
MethodWeights method_weights(const PreparedMesh& mesh, const Camera& camera, int width, int height, float spacing_mm,
                             const std::array<float, 3>& edges);

/// The least error within a budget: the tolerance to ask for. pixels: of cloth; as_measured: what this machine takes
/// over what the ladder's took. Between kFinestTolerance and kCoarsestTolerance, whatever the budget.
inline constexpr float kFinestTolerance = 0.02f, kCoarsestTolerance = 0.5f;
float expected_ms(const LodTable& lod_table, const MethodWeights& shares, float pixels, const LodDemand& demand);
float tolerance_within(const LodTable& lod_table, const MethodWeights& shares, float pixels, float as_measured,
                       float budget_ms);

}  // namespace weftlight::render_data
