#pragma once
// What an image of a texture set can hold in a channel, and how the texels of a cloth are packed into such images.

#include <array>
#include <vector>

#include "files/files.h"
#include "texture_set/surface_texels.h"

namespace weftlight::texture_set {

using cloth::Plane;
using files::Image, files::PixelType;

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
  kAspectAnisotropy,   // of Blender and U3M: narrow / wide = 1 - 0.9 a
  kOpenPbrRoughness,   // wide^2 + narrow^2 = 2 r^4
  kOpenPbrAnisotropy,  // narrow / wide = 1 - a
  kLean,               // sqrt(wide^2 - narrow^2): slopes by which round lobes lean along the wider axis
  kWideAngle,          // angle of the wider axis from right to up, in turns from the face's axis_cut()
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

/// Lists of channels that several targets share.
inline constexpr std::array<Channel, 4> kBaseColor{Channel::kBaseR, Channel::kBaseG, Channel::kBaseB, Channel::kNone};
inline constexpr std::array<Channel, 4> kBaseCoverage{Channel::kBaseR, Channel::kBaseG, Channel::kBaseB,
                                                      Channel::kCoverage};
inline constexpr std::array<Channel, 4> kNormalUp{Channel::kNormalX, Channel::kNormalY, Channel::kNormalZ,
                                                  Channel::kNone};
inline constexpr std::array<Channel, 4> kOcclusionRoughnessMetal{Channel::kOcclusion, Channel::kRoughness,
                                                                 Channel::kMetal, Channel::kNone};
constexpr std::array<Channel, 4> only(Channel c) { return {c, Channel::kNone, Channel::kNone, Channel::kNone}; }

/// An image of a set: its file name, encoding and channels.
struct ImageRow {
  const char* prefix;  // file: prefix + name + suffix + extension
  const char* suffix;
  const char* extension;
  PixelType type;
  bool srgb;
  std::array<Channel, 4> channels;
  bool factor = false;  // the material has factors for a constant image; otherwise that is written in few texels
};

int channels_of(const ImageRow& row);
/// Whether it holds directions: normals, fibres, axes, or their angle.
bool holds_directions(const ImageRow& row);

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
