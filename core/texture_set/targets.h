#pragma once
// What each engine reads: one table of images, their channels, encoding and names. A further engine is
// further rows.

#include <array>
#include <optional>
#include <span>
#include <string>

#include "files/files.h"
#include "light/engine_fit.h"
#include "texture_set/names.h"
#include "texture_set/surface_texels.h"

namespace weftlight::texture_set {

enum class Target { kRaw, kGltf, kUnreal, kUnityHdrp, kUnityUrp, kGodot, kBlender, kU3m, kMaterialX };
inline constexpr int kTargetCount = 9;

/// How the gaps of a cloth are shown.
enum class Alpha { kAuto, kOpaque, kMask, kHashed, kBlend };
/// kAuto: opaque where gaps are but pinholes, else the target's best for `coverage` (mean, 0..1). A target without
/// hashed alpha blends.
Alpha alpha_for(Target target, Alpha wanted, float coverage);
std::optional<Alpha> alpha_named(const std::string& name);
const char* alpha_name(Alpha alpha);

/// What a channel of an image holds; all 0..1 unless said.
enum class Channel {
  kNone,  // ends the list of channels
  kOne,
  kMiddle,  // one half
  kBaseR,
  kBaseG,
  kBaseB,  // linear light; encoded where the image is sRGB
  kCoverage,
  kOcclusion,
  kMetal,
  kRoughness,        // sqrt of the alpha of a round lobe as large as this one
  kSmoothness,       // 1 - kRoughness
  kRoughnessNarrow,  // of the narrow axis: glTF's base roughness
  kRoughnessAlong,
  kRoughnessAcross,  // of the fibre
  kNormalX,
  kNormalY,
  kNormalZ,      // -1..1 as 0..1; x right, y up the image
  kNormalYDown,  // the same for engines whose green runs down
  kFibreX,
  kFibreY,
  kFibreZ,  // likewise
  kWideX,
  kWideY,              // direction of the wider axis, likewise
  kGltfAnisotropy,     // strength s of KHR_materials_anisotropy: alpha_t = mix(alpha, 1, s^2)
  kAspectAnisotropy,   // of Godot, Blender and U3M: narrow / wide = 1 - 0.9 a
  kOpenPbrRoughness,   // wide^2 + narrow^2 = 2 r^4
  kOpenPbrAnisotropy,  // narrow / wide = 1 - a
  kTurn,               // of the wider axis from right to up, in whole turns, 0..1/2
  kSheenR,
  kSheenG,
  kSheenB,  // linear light
  kSheenRoughness,
  kSheenHueR,
  kSheenHueG,
  kSheenHueB,    // linear light; the sheen's colour over kSheenWeight
  kSheenWeight,  // largest of the sheen's colour
  kThroughR,
  kThroughG,
  kThroughB,     // linear light
  kHeightMm,     // millimetres, signed
  kHeightShare,  // of the cloth's thickness, 0..1
  kDetailNormalX,
  kDetailNormalY,     // of HDRP's ThreadMap: up and right as 0..1, flat is 0.5
  kDetailSmoothness,  // of it: 0.5 adds nothing
  kDetailOcclusion,
  kThreadLow,
  kThreadHigh,  // index of the thread in its system, modulo and over 65536, as 16 bits
  kSystem,      // 0 warp, 1 weft
};

struct ImageRow {
  Target target;
  const char* prefix;  // file: prefix + name + suffix + extension
  const char* suffix;
  const char* extension;
  PixelType type;
  bool srgb;
  std::array<Channel, 4> channels;
};

/// What the target's material has, that a set is fitted to (core/light/engine_fit.h). metal: there are metal yarns.
EngineModel engine_model(Target target, bool metal);
/// What versions before the present one have in its place, where the material's own numbers differ for them.
std::optional<EngineModel> older_model(Target target);

/// The rows of a target, in the order of the contact sheet.
std::span<const ImageRow> image_rows(Target target);

int channels_of(const ImageRow& row);

std::optional<Target> target_named(const std::string& name);
const char* target_name(Target target);
/// As its makers call it: "Unreal Engine".
const char* target_title(Target target);
/// Which way green runs in the target's normal map: "+Y" or "-Y".
const char* normal_convention(Target target);
/// Words for texture_set.json.
const char* channel_words(Channel channel);
/// Name of the channel in an .exr.
const char* exr_name(Channel channel);

/// The row's image of a surface, as the editor shows the cloth: u runs to the left, v down (core/draft/draft.h).
/// Directions in it are those of the image: x right, y up. threads: to pack with; 0: one a core.
Image pack(const ImageRow& row, const Surface& surface, int threads = 0);
/// Mean or spread of the horizon, a channel an azimuth (of an even number of them); likewise.
Image pack_planes(const std::vector<Plane<float>>& planes);

}  // namespace weftlight::texture_set
