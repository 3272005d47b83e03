#pragma once
// Maps in GPU formats: packed texels with prefiltered mips, made on the CPU by the worker, so that the thread with the
// GL context only uploads.

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/maps.h"
#include "draft/drawdown.h"
#include "light/thread_error.h"
#include "shaders/interop.h"

namespace weftlight::render_data {

using cloth::Maps, cloth::TexelRect;
using draft::CellRect, draft::Face;
using light::ThreadErrors;

/// Content of a texture, which decides how its mips are averaged.
enum class PackedKind : uint8_t {
  kColor,    // RGBA8 sRGB, layers warp, weft: colour times groove, premultiplied by the system's coverage (alpha)
  kRelief,   // RGBA8 snorm, layers warp, weft: means of the unit normal's x, y and of their squares, times coverage
  kHorizon,  // RG8, a layer an azimuth and one for the sky: mean and twice the spread of the horizon's sine; the
             // last layer holds the occlusion. Half the size of the others.
  kShadow,   // R8, a layer a light direction (method vrst03): 1 lit
};
inline constexpr int kPackedKinds = 4;

/// One texture array: `levels[0]` is the finest; layer by layer, rows tightly packed.
struct PackedTexture {
  PackedKind kind = PackedKind::kColor;
  int width = 0, height = 0, layers = 0, channels = 4;
  std::vector<std::vector<uint8_t>> levels;

  int level_width(int level) const { return std::max(1, width >> level); }
  int level_height(int level) const { return std::max(1, height >> level); }
  uint8_t* texel(int level, int layer, int x, int y) {
    return levels[static_cast<size_t>(level)].data() + offset(level, layer, x, y);
  }
  const uint8_t* texel(int level, int layer, int x, int y) const {
    return levels[static_cast<size_t>(level)].data() + offset(level, layer, x, y);
  }

 private:
  size_t offset(int level, int layer, int x, int y) const {
    const size_t row = static_cast<size_t>(layer) * level_height(level) + y;
    return (row * level_width(level) + x) * static_cast<size_t>(channels);
  }
};

/// Height and slope of the warp, of the weft, as half floats.
using HalfCrossing = std::array<uint16_t, 4>;

struct PackedFace {
  std::array<PackedTexture, kPackedKinds> textures;  // by PackedKind; kShadow is empty unless asked for
  // Method vrst03: the two cube maps of its BRDF, RGB floats, faces in OpenGL's order; empty unless asked for.
  int cube_size = 0;
  std::vector<float> half_cube, difference_cube;
};

/// The far-field response as textures (response_block.h); empty until measured.
struct ResponseTables {
  // [view]: [face * 2 + system][elevation][reflected, gradient][azimuth of the light], then for light from behind
  // [face * 2 + system][elevation][azimuth]
  std::vector<glm::vec4> reflected;
  std::vector<float> slopes;  // [face * 2 + system][y][x]: density of the facets' slope angles
  // [face][table][elevation][azimuth]: visible fraction of the warp, its rise, mean heights of both; reflected light
  // of a uniform sky by system; its mean directions (response_block.cpp)
  std::vector<glm::vec4> views;
  bool empty() const { return reflected.empty(); }
  size_t bytes() const { return (reflected.size() + views.size()) * sizeof(glm::vec4) + slopes.size() * sizeof(float); }
  bool operator==(const ResponseTables&) const = default;
};

/// The data that depends on the yarns' lobes.
struct ClothLobes {
  interop::ClothData data{};
  ResponseTables response;
  // The threads (thread_block.h), whole rows of THREAD_MAP_WIDTH texels.
  std::vector<glm::uvec4> threads;
  ThreadErrors errors;  // fit the LOD table to this cloth
  bool operator==(const ClothLobes&) const = default;
};

/// Everything that the renderer needs of a design except mesh, scene and look.
struct PackedCloth {
  float width_mm = 0, depth_mm = 0;
  float mean_spacing_mm = 0;  // of both systems: the unit of "yarns a pixel"
  PackedFace front, back;
  // Crossings of the front, or, if there are too many of them, its cells (thread_block.h).
  int ends = 0, picks = 0;
  std::vector<HalfCrossing> crossings;
  // How far washing moves the end and the pick of each sideways; empty where it moves none.
  std::vector<HalfCrossing> asides;
  std::vector<uint32_t> strips;
  ClothLobes lobes;

  bool has_threads() const { return !crossings.empty() || !strips.empty(); }
};

/// A rectangle of one level of one texture of one face.
struct PackedPatch {
  Face face = Face::kFront;
  PackedKind kind = PackedKind::kColor;
  int level = 0;
  int x = 0, y = 0, width = 0, height = 0;
  std::vector<uint8_t> texels;  // all layers, layer by layer
};

/// Crossings of a rectangle of cells, a row a pick.
struct CrossingPatch {
  CellRect cells;
  std::vector<HalfCrossing> texels;
  std::vector<HalfCrossing> asides;  // empty where washing moves no thread sideways
};

/// Strips of cells, from `first` on among all.
struct StripPatch {
  size_t first = 0;
  std::vector<uint32_t> strips;
};

struct ClothPatches {
  std::vector<PackedPatch> maps;
  std::vector<CrossingPatch> crossings;
  std::vector<StripPatch> strips;
  bool empty() const { return maps.empty() && crossings.empty() && strips.empty(); }
};

/// Light directions of vrst03's boolean shadow maps: kShadowAzimuths at each of these elevations.
inline constexpr int kShadowAzimuths = 8;
inline constexpr std::array<float, 3> kShadowElevations{0.35f, 0.75f, 1.15f};  // radians

/// Packs one face with all its mips. `shadows`: with the boolean maps of vrst03.
PackedFace pack(const Maps& maps, bool shadows);

/// Updates `face` from the maps changed inside `rects`, in all levels, and returns the changes, ready for upload. The
/// result equals pack(maps) bit for bit.
std::vector<PackedPatch> repack(PackedFace& face, Face which, const Maps& maps, const std::vector<TexelRect>& rects);

}  // namespace weftlight::render_data
