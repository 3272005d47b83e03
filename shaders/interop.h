// What C++ and GLSL agree on: texture slots, layers, and the two uniform blocks (std140, made of vec4 and
// mat4 alone so that both sides lay them out alike). Read by C++ and, through the shader loader, by GLSL.
#ifdef __cplusplus
#pragma once
#include <array>
#include <cstddef>
namespace weftlight {
namespace interop {
using vec4 = std::array<float, 4>;
using mat4 = std::array<float, 16>;
#endif

#define SH_COEFFICIENTS 9

// Of the tables of threads (editor/preview/thread_block.h).
#define THREAD_MAP_WIDTH 1024
#define THREAD_TEXELS 6
#define YARN_TEXELS 4
#define CROSSING_BLOCK 4096

struct FrameData {
  mat4 world_to_clip;
  mat4 world_to_shadow;       // to 0..1 in x, y and depth
  vec4 eye;                   // xyz mm; w: sign of the front face (+1: the mesh's front shows the cloth's front)
  vec4 light;                 // xyz towards the light; w: half angle of its disc as a sine
  vec4 light_color;           // rgb irradiance; w: exposure factor
  vec4 sky[SH_COEFFICIENTS];  // rgb radiance, spherical harmonics, real, bands 0..2
  vec4 background;            // rgb linear, display-referred; w: 1 where the background is left out
  vec4 picture;               // width, height in pixels; z: 1 writes scene-linear
  vec4 samples;               // of rung yarn: x: the first one's number; y: how many at the most
  vec4 shadow;                // x: texel of the shadow map; y: radius of its filter in texels;
                              // z: normal offset in mm; w: opacity of the cloth to the key light
  vec4 tile;                  // xy: repeats a millimetre; zw: repeats at the mesh's uv origin
  vec4 ground;                // x: height mm; y: radius mm; zw: centre x, z mm
  vec4 rungs;                 // xyz: edges between the rungs, yarns a pixel; w: 1 shows which rung is where
  vec4 hair;                  // stray fibres: x: pieces that each is drawn with; zw: mean length on the
                              // mesh's front and back, mm
};

// One thread system of one face: index face * 2 + system (0 warp, 1 weft).
struct SystemData {
  vec4 widths;   // along, across (RMS slopes); z: tan of the fibre's angle; w: fuzz width
  vec4 weights;  // specular, body, fuzz, transmission
  vec4 tint;     // rgb of the specular; w: 1 metallic
  vec4 extra;    // x: reflectance at normal incidence; y: mean coverage; z: fuzz depth;
                 // w: mean height over the other system, in mean spacings
  vec4 mean;     // rgb: mean colour; w: share of the cover
  vec4 facets;   // means of the unit normal's x, y and of their squares
};

struct ClothData {
  SystemData systems[4];
  vec4 size;    // width, depth mm; z: mean spacing of yarns mm; w: azimuths of the horizon
  vec4 gaps;    // xy: mean gap along u and v, mm; z: height of the threads at its rim, mm;
                // w: 1 where the cloth has gaps at all
  vec4 relief;  // zw: mean share of the sky that threads leave, front and back
  vec4 even;    // x: yarns a pixel from which on the period's colour is even
};

#ifdef __cplusplus
}  // namespace interop

inline constexpr int kFrameBinding = 0, kClothBinding = 1;

/// Texture units.
enum Sampler : int {
  kColorSlot,
  kReliefSlot,
  kHorizonSlot,
  kThreadShadowSlot,
  kSunShadowSlot,
  kGroundSlot,
  kSunDepthSlot,
  kAlbedoSlot,
  kAlbedoMeanSlot,
  kFuzzSlot,
  kFrontHalfSlot,
  kFrontDifferenceSlot,
  kBackHalfSlot,
  kBackDifferenceSlot,
  kThreadSlot,
  kCrossingSlot,
  kResponseSlot,
  kSlopesSlot,
  kSeenSlot,
  kSamplerCount
};
inline constexpr std::array<const char*, kSamplerCount> kSamplerNames{
    "color_map",           "relief_map",          "horizon_map",    "thread_shadow_map",
    "sun_shadow_map",      "ground_map",          "sun_depth_map",  "albedo_texture",
    "albedo_mean_texture", "fuzz_texture",        "front_half_map", "front_difference_map",
    "back_half_map",       "back_difference_map", "thread_map",     "crossing_map",
    "response_map",        "slopes_map",          "seen_map"};

enum Attribute : unsigned { kPosition, kNormal, kTangent, kUv, kSky, kHair, kAttributeCount };
inline constexpr std::array<const char*, kAttributeCount> kAttributeNames{"in_position", "in_normal", "in_tangent",
                                                                          "in_uv_mm",    "in_sky",    "in_hair"};

static_assert(sizeof(interop::FrameData) == (32 + 4 * (3 + SH_COEFFICIENTS + 8)) * sizeof(float));
static_assert(sizeof(interop::SystemData) == 24 * sizeof(float));
static_assert(offsetof(interop::ClothData, size) == 96 * sizeof(float));
}  // namespace weftlight
#endif
