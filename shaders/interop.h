// Shared by C++ and GLSL: sizes, texture slots, and the two uniform blocks. The blocks are std140, made only of vec4,
// mat4 and groups of four floats, so that both sides lay them out alike; the end of the file asserts it.
#ifdef __cplusplus
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
namespace weftlight {
namespace interop {
using glm::mat4;
using glm::vec4;
#endif

#define SH_COEFFICIENTS 9

// Reflectance of the form under a drape: matt plaster, unobtrusive beside any cloth.
#define FORM_REFLECTANCE vec3(0.46f, 0.44f, 0.415f)

// Lights of an environment beside the key light.
#define MORE_LIGHTS 3

// Sizes in texels of the map of threads (thread_records.glsl): its width, its head, a thread, a yarn. Offsets of body,
// colour and pattern within a thread. Crossings are stored in square blocks of this many texels.
#define THREAD_MAP_WIDTH 1024
#define THREAD_HEAD_TEXELS 5
#define THREAD_TEXELS 8
#define THREAD_BODY 0
#define THREAD_COLOR 1
#define THREAD_PATTERN 2
#define THREAD_DYE 7
#define YARN_TEXELS 4
#define CROSSING_BLOCK 4096

// Cells along a thread in one texel of the drawdown that crossings are computed from (crossings.glsl): this many of its
// own between margins on either side, 32 in all. Size of a layer of that map in texels, powers of two.
#define STRIP_CELLS 22
#define STRIP_MARGIN 5
#define STRIP_MAP_WIDTH 1024
#define STRIP_MAP_HEIGHT 4096

// Nodes of the far-field response (core/light/cloth_response.h): elevations, azimuths of views and of lights, of
// lights from behind the cloth; bins of slope angles. View tables: for each face the visible fractions, the reflected
// sky by warp and by weft, its directions, the correction of method `yarn`, and what its threads send to each other.
#define RESPONSE_ELEVATIONS 8
#define RESPONSE_VIEWS_AROUND 32
#define RESPONSE_LIGHTS_AROUND 16
#define TRANSMISSION_ELEVATIONS 12
#define TRANSMISSION_LIGHTS_AROUND 32
// Texels of the response for one view: reflected light and gradient, and below them those of light from behind.
#define RESPONSE_WIDTH 34
#define RESPONSE_HEIGHT 128
#define RESPONSE_SLOPES 64
#define VIEW_TABLES 12

struct FrameData {
  mat4 world_to_clip;
  mat4 world_to_shadow;       // to 0..1 in x, y and depth
  vec4 eye;                   // xyz mm; w: sign of the front face (+1: the mesh's front shows the cloth's front)
  vec4 light;                 // xyz towards the light; w: half angle of its disc as a sine
  vec4 light_color;           // rgb irradiance; w: exposure factor
  vec4 sky[SH_COEFFICIENTS];  // rgb radiance, spherical harmonics, real, bands 0..2
  vec4 background;            // rgb linear, display-referred; w: 1 for no background
  vec4 picture;               // width, height in pixels; z: 1 writes scene-linear; w: lights beside the key light
  vec4 samples;               // of method yarn: x: index of the pass; y: largest number of samples
  vec4 shadow;                // x: texel of the shadow map; y: radius of its filter in texels;
                              // z: normal offset in mm; w: opacity of the cloth to the key light
  vec4 tile;                  // xy: repeats a millimetre; zw: repeats at the mesh's uv origin
  vec4 ground;                // x: height mm; y: radius mm; zw: centre x, z mm
  vec4 methods;               // xyz: edges between the methods, yarns a pixel; w: 1 for false colours
  vec4 flyaway;               // flyaway fibres: x: pieces that each is drawn with; zw: mean length on the
                              // mesh's front and back, mm
  vec4 lattices[2];           // of method yarn: footprints from which on each finer lattice is needed (lattice.glsl)
  mat4 world_to_more[MORE_LIGHTS];  // as world_to_shadow, light and light_color, of the lights beside the key light
  vec4 more_light[MORE_LIGHTS];
  vec4 more_color[MORE_LIGHTS];  // rgb irradiance; w: texel of its shadow map in mm
  vec4 camera_rays[3];  // xyz: right, up and middle of the picture as directions of its rays; w: cosine and sine
                        // by which the environment's picture is turned, and 1 where it shows
};

// Lobes of a yarn (yarn_of() of methods.glsl), or the mean of several yarns.
struct YarnData {
  float along_width;  // RMS slopes
  float across_width;
  float specular;
  float body;  // 0 for a metal
  float fuzz;
  float fuzz_width;
  float fuzz_depth;  // optical depth
  float transmission;
  vec4 tint;             // rgb of the specular, linear; w: fraction of it in the thread's colour (metal: all)
  float reflectance;     // of the clear fibres at normal incidence
  float fibre_layers;    // that over one layer's
  float inner_halvings;  // how often the path of the dyed part through the dye is halved, -1..2
  float spare_c;         // for further parameters; 0
};

// One thread system of one face: index face * 2 + system (0 warp, 1 weft).
struct SystemData {
  YarnData yarn;    // mean over its threads
  float fibre_tan;  // tangent of the mean angle between fibre and thread
  float coverage;   // mean over the maps
  float fraction;   // of the coverage, by rays
  float spare;
  vec4 color;   // rgb: mean
  vec4 facets;  // means of the unit normal's x, y and of their squares
};

// Material of an exported set of one face (core/light/engine_fit.h).
struct EngineData {
  vec4 base;   // rgb factors of base colour; w: reflectance of dielectrics at grazing incidence
  vec4 gloss;  // rgb: the same at normal incidence
  vec4 sheen;  // rgb factors of the sheen's colour; w: its roughness
  vec4 lean;   // xy: mean slope of the normals, which the images are without
  // Warp, weft.
  vec4 lobes[2];  // direction of the wider axis, roughness of the narrow one, strength of the anisotropy
  vec4 body[2];   // rgb: base colour over the thread's; metal
};

struct ClothData {
  SystemData systems[4];
  float width_mm;
  float depth_mm;
  float spacing_mm;  // mean, of yarns
  float azimuths;    // of the horizon
  float gap_u_mm;    // mean gaps along u and v
  float gap_v_mm;
  float rim_mm;     // height of the threads at a gap's edge
  float open;       // 1 if the cloth has gaps
  float front_sky;  // mean sky visibility among the threads
  float back_sky;
  float even_yarns;      // yarns a pixel from which on the period's colour is uniform
  float half_period;     // of the weave and its colours, in yarns: 1 in plain weave; 16 if it is longer
  EngineData engine[2];  // front, back
};

#ifdef __cplusplus
inline bool operator==(const ClothData& a, const ClothData& b) {
  using Numbers = std::array<float, sizeof(ClothData) / sizeof(float)>;
  return std::bit_cast<Numbers>(a) == std::bit_cast<Numbers>(b);
}
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
  kViewSlot,
  kMoreShadowSlot,
  kEnvironmentSlot,
  kSamplerCount
};
inline constexpr std::array<const char*, kSamplerCount> kSamplerNames{
    "color_map",           "relief_map",          "horizon_map",    "thread_shadow_map",
    "sun_shadow_map",      "ground_map",          "sun_depth_map",  "albedo_texture",
    "albedo_mean_texture", "fuzz_texture",        "front_half_map", "front_difference_map",
    "back_half_map",       "back_difference_map", "thread_map",     "crossing_map",
    "response_map",        "slopes_map",          "view_map",       "more_shadow_map",
    "environment_map"};

enum Attribute : unsigned { kPosition, kNormal, kTangent, kUv, kSky, kFlyaway, kAttributeCount };
inline constexpr std::array<const char*, kAttributeCount> kAttributeNames{"in_position", "in_normal", "in_tangent",
                                                                          "in_uv_mm",    "in_sky",    "in_flyaway"};

static_assert(sizeof(interop::FrameData) ==
              (32 + 4 * (3 + SH_COEFFICIENTS + 10) + MORE_LIGHTS * 24 + 12) * sizeof(float));
static_assert(offsetof(interop::FrameData, background) == (32 + 4 * (3 + SH_COEFFICIENTS)) * sizeof(float));
static_assert(sizeof(interop::YarnData) == YARN_TEXELS * sizeof(glm::vec4));
static_assert(offsetof(interop::YarnData, tint) == 2 * sizeof(glm::vec4));
static_assert(offsetof(interop::SystemData, fibre_tan) == sizeof(interop::YarnData));
static_assert(offsetof(interop::SystemData, color) == sizeof(interop::YarnData) + sizeof(glm::vec4));
static_assert(sizeof(interop::SystemData) == sizeof(interop::YarnData) + 3 * sizeof(glm::vec4));
static_assert(offsetof(interop::ClothData, width_mm) == 4 * sizeof(interop::SystemData));
static_assert(sizeof(interop::ClothData) == 4 * sizeof(interop::SystemData) + 19 * sizeof(glm::vec4));
}  // namespace weftlight
#endif
