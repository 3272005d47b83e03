// Based on: the glTF 2.0 specification and its KHR_materials_anisotropy and KHR_materials_sheen; Unreal,
//   Unity, Godot and Blender as their manuals describe the inputs of their standard and fabric materials.

#include "texture_set/targets.h"

#include <algorithm>
#include <cmath>

#include "base/loops.h"
#include "cloth/srgb.h"

namespace weftlight::texture_set {
namespace {

using enum Channel;
using enum PixelType;

constexpr std::array<Channel, 4> kBase{kBaseR, kBaseG, kBaseB, kNone};
constexpr std::array<Channel, 4> kBaseCoverage{kBaseR, kBaseG, kBaseB, kCoverage};
constexpr std::array<Channel, 4> kNormalUp{kNormalX, kNormalY, kNormalZ, kNone};
constexpr std::array<Channel, 4> kOrm{kOcclusion, kRoughness, kMetal, kNone};
constexpr std::array<Channel, 4> kThrough{kThroughR, kThroughG, kThroughB, kNone};
constexpr std::array<Channel, 4> kSheen{kSheenR, kSheenG, kSheenB, kSheenRoughness};

constexpr std::array<Channel, 4> only(Channel c) { return {c, kNone, kNone, kNone}; }

// Sorted by target: image_rows() takes a stretch.
constexpr ImageRow kRows[] = {
    {Target::kRaw, "", "_albedo", ".exr", kHalf, false, kBase},
    {Target::kRaw, "", "_coverage", ".png", kU16, false, only(kCoverage)},
    {Target::kRaw, "", "_height", ".exr", kHalf, false, only(kHeightMm)},
    {Target::kRaw, "", "_normal", ".png", kU16, false, kNormalUp},
    {Target::kRaw, "", "_tangent", ".png", kU16, false, {kFibreX, kFibreY, kFibreZ, kNone}},
    {Target::kRaw, "", "_roughness", ".png", kU16, false, {kRoughnessAlong, kRoughnessAcross, kMetal, kNone}},
    {Target::kRaw, "", "_occlusion", ".png", kU16, false, only(kOcclusion)},
    {Target::kRaw, "", "_thread", ".png", kU16, false, {kThreadLow, kThreadHigh, kSystem, kNone}},

    {Target::kGltf, "", "_basecolor", ".png", kU8, true, kBaseCoverage},
    {Target::kGltf, "", "_orm", ".png", kU8, false, {kOcclusion, kRoughnessNarrow, kMetal, kNone}},
    {Target::kGltf, "", "_normal", ".png", kU8, false, kNormalUp},
    {Target::kGltf, "", "_anisotropy", ".png", kU8, false, {kWideX, kWideY, kGltfAnisotropy, kNone}},
    {Target::kGltf, "", "_sheen", ".png", kU8, true, kSheen},

    {Target::kUnreal, "T_", "_BC", ".png", kU8, true, kBase},
    {Target::kUnreal, "T_", "_N", ".png", kU8, false, {kNormalX, kNormalYDown, kNormalZ, kNone}},
    {Target::kUnreal, "T_", "_ORM", ".png", kU8, false, kOrm},
    {Target::kUnreal, "T_", "_OM", ".png", kU8, false, only(kCoverage)},
    {Target::kUnreal, "T_", "_FC", ".png", kU8, true, {kSheenR, kSheenG, kSheenB, kNone}},
    {Target::kUnreal, "T_", "_CW", ".png", kU8, false, only(kSheenWeight)},

    {Target::kUnityHdrp, "", "_BaseMap", ".png", kU8, true, kBaseCoverage},
    {Target::kUnityHdrp, "", "_MaskMap", ".png", kU8, false, {kMetal, kOcclusion, kOne, kSmoothness}},
    {Target::kUnityHdrp, "", "_NormalMap", ".png", kU8, false, kNormalUp},
    {Target::kUnityHdrp, "", "_ThreadMap", ".png", kU8, false, {kOcclusion, kNormalY, kSmoothness, kNormalX}},

    {Target::kUnityUrp, "", "_BaseMap", ".png", kU8, true, kBaseCoverage},
    {Target::kUnityUrp, "", "_MetallicSmoothness", ".png", kU8, false, {kMetal, kMetal, kMetal, kSmoothness}},
    {Target::kUnityUrp, "", "_Normal", ".png", kU8, false, kNormalUp},
    {Target::kUnityUrp, "", "_Occlusion", ".png", kU8, false, only(kOcclusion)},

    {Target::kGodot, "", "_albedo", ".png", kU8, true, kBaseCoverage},
    {Target::kGodot, "", "_orm", ".png", kU8, false, kOrm},
    {Target::kGodot, "", "_normal", ".png", kU8, false, kNormalUp},
    {Target::kGodot, "", "_flowmap", ".png", kU8, false, {kWideX, kWideY, kOne, kAspectAnisotropy}},
    {Target::kGodot, "", "_backlight", ".png", kU8, true, kThrough},

    {Target::kBlender, "", "_basecolor", ".png", kU8, true, kBase},
    {Target::kBlender, "", "_alpha", ".png", kU8, false, only(kCoverage)},
    {Target::kBlender, "", "_roughness", ".png", kU8, false, only(kRoughness)},
    {Target::kBlender, "", "_metallic", ".png", kU8, false, only(kMetal)},
    {Target::kBlender, "", "_normal", ".png", kU16, false, kNormalUp},
    {Target::kBlender, "", "_tangent", ".png", kU16, false, {kWideX, kWideY, kOne, kNone}},
    {Target::kBlender, "", "_anisotropic", ".png", kU8, false, only(kAspectAnisotropy)},
    {Target::kBlender, "", "_sheen", ".png", kU8, true, {kSheenR, kSheenG, kSheenB, kNone}},
    {Target::kBlender, "", "_height", ".exr", kHalf, false, only(kHeightMm)},
};
static_assert(std::is_sorted(std::begin(kRows), std::end(kRows),
                             [](const ImageRow& a, const ImageRow& b) { return a.target < b.target; }));

struct TargetRow {
  Target target;
  const char* name;
  const char* normal;
};
constexpr TargetRow kTargets[] = {
    {Target::kRaw, "raw", "+Y"},
    {Target::kGltf, "gltf", "+Y"},
    {Target::kUnreal, "unreal", "-Y"},
    {Target::kUnityHdrp, "unity-hdrp", "+Y"},
    {Target::kUnityUrp, "unity-urp", "+Y"},
    {Target::kGodot, "godot", "+Y"},
    {Target::kBlender, "blender", "+Y"},
};

const TargetRow& target_row(Target target) { return kTargets[static_cast<size_t>(target)]; }

float encoded(float linear, bool srgb) { return srgb ? srgb_encoded(std::clamp(linear, 0.0f, 1.0f)) : linear; }

float half_range(float v) { return 0.5f + 0.5f * v; }

/// Of a round lobe with the same area as the texel's.
float round_roughness(const GgxAlphas& a) { return std::sqrt(std::sqrt(a.wide * a.narrow)); }

float gltf_strength(const GgxAlphas& a) {
  return a.narrow < 1 ? std::sqrt(std::max(a.wide - a.narrow, 0.0f) / (1 - a.narrow)) : 0.0f;
}

/// Their aspect^2 = narrow / wide = 1 - 0.9 a.
float aspect_anisotropy(const GgxAlphas& a) {
  return a.wide > 0 ? std::clamp((1 - a.narrow / a.wide) / 0.9f, 0.0f, 1.0f) : 0.0f;
}

float value(Channel channel, const SurfaceTexel& t, bool srgb) {
  switch (channel) {
    case kNone:
      return 0;
    case kOne:
      return 1;
    case kBaseR:
      return encoded(t.base.r, srgb);
    case kBaseG:
      return encoded(t.base.g, srgb);
    case kBaseB:
      return encoded(t.base.b, srgb);
    case kCoverage:
      return t.coverage;
    case kOcclusion:
      return t.occlusion;
    case kMetal:
      return t.metal;
    case kRoughness:
      return round_roughness(ggx_alphas(t));
    case kSmoothness:
      return 1 - round_roughness(ggx_alphas(t));
    case kRoughnessNarrow:
      return std::sqrt(ggx_alphas(t).narrow);
    case kRoughnessAlong:
      return std::sqrt(ggx_along_across(t)[0]);
    case kRoughnessAcross:
      return std::sqrt(ggx_along_across(t)[1]);
    case kNormalX:
      return half_range(-t.normal[0]);
    case kNormalY:
      return half_range(-t.normal[1]);
    case kNormalZ:
      return half_range(t.normal[2]);
    case kNormalYDown:
      return half_range(t.normal[1]);
    case kFibreX:
      return half_range(-t.fibre[0]);
    case kFibreY:
      return half_range(-t.fibre[1]);
    case kFibreZ:
      return half_range(t.fibre[2]);
    case kWideX:
      return half_range(ggx_alphas(t).wide_axis[0]);
    case kWideY:
      return half_range(ggx_alphas(t).wide_axis[1]);
    case kGltfAnisotropy:
      return gltf_strength(ggx_alphas(t));
    case kAspectAnisotropy:
      return aspect_anisotropy(ggx_alphas(t));
    case kSheenR:
      return encoded(t.sheen.r, srgb);
    case kSheenG:
      return encoded(t.sheen.g, srgb);
    case kSheenB:
      return encoded(t.sheen.b, srgb);
    case kSheenRoughness:
      return t.sheen_roughness;
    case kSheenWeight:
      return std::max({t.sheen.r, t.sheen.g, t.sheen.b});
    case kThroughR:
      return encoded(t.through.r, srgb);
    case kThroughG:
      return encoded(t.through.g, srgb);
    case kThroughB:
      return encoded(t.through.b, srgb);
    case kHeightMm:
      return t.height_mm;
    case kThreadLow:
      return static_cast<float>(t.thread & 0xFFFFu) / 65535.0f;
    case kThreadHigh:
      return static_cast<float>(t.thread >> 16) / 65535.0f;
    case kSystem:
      return t.system;
  }
  return 0;
}

}  // namespace

std::span<const ImageRow> image_rows(Target target) {
  const auto first =
      std::find_if(std::begin(kRows), std::end(kRows), [=](const ImageRow& r) { return r.target == target; });
  const auto last = std::find_if(first, std::end(kRows), [=](const ImageRow& r) { return r.target != target; });
  return {first, last};
}

std::optional<Target> target_named(const std::string& name) {
  for (const TargetRow& row : kTargets) {
    if (name == row.name) return row.target;
  }
  return std::nullopt;
}

const char* target_name(Target target) { return target_row(target).name; }
const char* normal_convention(Target target) { return target_row(target).normal; }

const char* channel_words(Channel channel) {
  switch (channel) {
    case kNone:
      return "none";
    case kOne:
      return "one";
    case kBaseR:
      return "base colour red";
    case kBaseG:
      return "base colour green";
    case kBaseB:
      return "base colour blue";
    case kCoverage:
      return "coverage";
    case kOcclusion:
      return "ambient occlusion";
    case kMetal:
      return "metalness";
    case kRoughness:
      return "roughness";
    case kSmoothness:
      return "smoothness";
    case kRoughnessNarrow:
      return "roughness of the narrow axis";
    case kRoughnessAlong:
      return "roughness along the fibre";
    case kRoughnessAcross:
      return "roughness across the fibre";
    case kNormalX:
      return "normal x";
    case kNormalY:
      return "normal y, up";
    case kNormalZ:
      return "normal z";
    case kNormalYDown:
      return "normal y, down";
    case kFibreX:
      return "fibre direction x";
    case kFibreY:
      return "fibre direction y";
    case kFibreZ:
      return "fibre direction z";
    case kWideX:
      return "anisotropy direction x";
    case kWideY:
      return "anisotropy direction y";
    case kGltfAnisotropy:
      return "anisotropy strength (KHR_materials_anisotropy)";
    case kAspectAnisotropy:
      return "anisotropy (narrow / wide = 1 - 0.9 a)";
    case kSheenR:
      return "sheen colour red";
    case kSheenG:
      return "sheen colour green";
    case kSheenB:
      return "sheen colour blue";
    case kSheenRoughness:
      return "sheen roughness";
    case kSheenWeight:
      return "weight of the cloth layer";
    case kThroughR:
      return "transmitted light red";
    case kThroughG:
      return "transmitted light green";
    case kThroughB:
      return "transmitted light blue";
    case kHeightMm:
      return "height in millimetres above the middle plane";
    case kThreadLow:
      return "thread index modulo 65536";
    case kThreadHigh:
      return "thread index over 65536";
    case kSystem:
      return "thread system: 0 warp, 1 weft";
  }
  return "";
}

const char* exr_name(Channel channel) {
  switch (channel) {
    case kBaseR:
      return "R";
    case kBaseG:
      return "G";
    case kBaseB:
      return "B";
    case kHeightMm:
      return "height.mm";
    case kNormalX:
      return "N.X";
    case kNormalY:
      return "N.Y";
    case kNormalZ:
      return "N.Z";
    case kRoughnessAlong:
      return "roughness.along";
    case kRoughnessAcross:
      return "roughness.across";
    default:
      return "";
  }
}

Image pack(const ImageRow& row, const Surface& surface) {
  const int width = surface.texels.width, height = surface.texels.height;
  const auto end = std::find(row.channels.begin(), row.channels.end(), kNone);
  const int channels = static_cast<int>(end - row.channels.begin());
  Image image{
      width, height, channels,
      std::vector<float>(static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(channels))};
  for_each_job(height, [&](int y) {
    const SurfaceTexel* texel = surface.texels.row(y);
    float* out = image.texels.data() + static_cast<size_t>(y) * static_cast<size_t>(width * channels);
    for (int x = width - 1; x >= 0; --x) {
      for (int c = 0; c < channels; ++c) *out++ = value(row.channels[static_cast<size_t>(c)], texel[x], row.srgb);
    }
  });
  return image;
}

Image pack_planes(const std::vector<Plane<float>>& planes) {
  if (planes.empty()) return {};
  const int width = planes[0].width, height = planes[0].height, channels = static_cast<int>(planes.size());
  Image image{width, height, channels, {}};
  image.texels.reserve(static_cast<size_t>(width) * static_cast<size_t>(height) * planes.size());
  const size_t turned = planes.size() / 2;  // half a turn: azimuths are those of the image
  for (int y = 0; y < height; ++y) {
    for (int x = width - 1; x >= 0; --x) {
      for (size_t k = 0; k < planes.size(); ++k) image.texels.push_back(planes[(k + turned) % planes.size()].at(x, y));
    }
  }
  return image;
}

}  // namespace weftlight::texture_set
