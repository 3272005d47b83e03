#pragma once
// The images that each engine reads: one table of their channels, encoding and file names. A new engine is new rows.

#include <array>
#include <optional>
#include <span>
#include <string>

#include "files/files.h"
#include "light/engine_fit.h"
#include "texture_set/names.h"
#include "texture_set/surface_texels.h"

namespace weftlight::texture_set {

enum class ExportTarget { kRaw, kGltf, kUnreal, kUnityHdrp, kUnityUrp, kGodot, kBlender, kU3m, kMaterialX };
inline constexpr int kTargetCount = 9;

/// Alpha mode of the gaps between threads.
enum class Alpha { kAuto, kOpaque, kMask, kHashed, kBlend };
/// Resolves kAuto: opaque if gaps are only pinholes, else the best mode of the target. `coverage`: mean, 0..1. A target
/// without hashed alpha gets blending.
Alpha alpha_for(ExportTarget target, Alpha requested, float coverage);
std::optional<Alpha> alpha_named(const std::string& name);
const char* alpha_name(Alpha alpha);

/// The content of a channel of an image; 0..1 unless noted.
enum class Channel {
  kNone,  // ends the list of channels
  kOne,
  kOneHalf,
  kBaseR,
  kBaseG,
  kBaseB,  // linear light; encoded where the image is sRGB
  kCoverage,
  kOcclusion,
  kMetal,
  kRoughness,        // sqrt of the alpha of an isotropic lobe of the same area
  kSmoothness,       // 1 - kRoughness
  kRoughnessNarrow,  // of the narrow axis: glTF's base roughness
  kRoughnessAlong,
  kRoughnessAcross,  // along and across the fibre
  kNormalX,
  kNormalY,
  kNormalZ,      // -1..1 mapped to 0..1; x right, y up in the image
  kNormalYDown,  // the same, for engines with y down
  kFibreX,
  kFibreY,
  kFibreZ,  // direction of the fibre, likewise
  kWideX,
  kWideY,              // direction of the wider axis, likewise
  kGltfAnisotropy,     // strength s of KHR_materials_anisotropy: alpha_t = mix(alpha, 1, s^2)
  kAspectAnisotropy,   // of Godot, Blender and U3M: narrow / wide = 1 - 0.9 a
  kOpenPbrRoughness,   // wide^2 + narrow^2 = 2 r^4
  kOpenPbrAnisotropy,  // narrow / wide = 1 - a
  kWideAngle,          // angle of the wider axis from right to up, in turns, 0..0.5
  kSheenR,
  kSheenG,
  kSheenB,  // linear light
  kSheenRoughness,
  kSheenHueR,
  kSheenHueG,
  kSheenHueB,    // linear light; the sheen's colour divided by kSheenWeight
  kSheenWeight,  // largest channel of the sheen's colour
  kTransmittedR,
  kTransmittedG,
  kTransmittedB,      // linear light
  kHeightMm,          // millimetres, signed
  kHeightNormalized,  // fraction of the cloth's thickness
  kDetailNormalX,
  kDetailNormalY,     // of HDRP's ThreadMap: up and right mapped to 0..1; 0.5 is flat
  kDetailSmoothness,  // of the ThreadMap; 0.5 adds nothing
  kDetailOcclusion,
  kThreadLow,
  kThreadHigh,  // index of the thread in its system, low and high 16 bits
  kSystem,      // 0 warp, 1 weft
};

struct ImageRow {
  ExportTarget target;
  const char* prefix;  // file: prefix + name + suffix + extension
  const char* suffix;
  const char* extension;
  PixelType type;
  bool srgb;
  std::array<Channel, 4> channels;
};

/// The material model of the target, to which a set is fitted (core/light/engine_fit.h). metal: there are metal yarns.
EngineModel engine_model(ExportTarget target, bool metal);
/// The model of older versions of the target, if it needs other numbers.
std::optional<EngineModel> older_model(ExportTarget target);

/// The rows of a target, in the order of the contact sheet.
std::span<const ImageRow> image_rows(ExportTarget target);

int channels_of(const ImageRow& row);

std::optional<ExportTarget> target_named(const std::string& name);
const char* target_name(ExportTarget target);
/// The product name, as in "Unreal Engine".
const char* target_title(ExportTarget target);
/// Sign of the green channel of the target's normal map: "+Y" or "-Y".
const char* normal_convention(ExportTarget target);
/// English text for texture_set.json; tr() of it for the window.
const char* channel_description(Channel channel);
/// Name of the channel in an .exr.
const char* exr_name(Channel channel);

/// The image of a row, oriented as the editor shows the cloth: u to the left, v down (core/draft/draft.h). Directions
/// in it are those of the image: x right, y up. threads: number of threads to use; 0: one per core.
Image pack(const ImageRow& row, const SurfaceTexels& surface, int threads = 0);
/// Mean or spread of the horizon, likewise; one channel for each azimuth, of which there is an even number.
Image pack_planes(const std::vector<Plane<float>>& planes);

}  // namespace weftlight::texture_set
