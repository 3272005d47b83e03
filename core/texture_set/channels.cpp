#include "texture_set/channels.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/loops.h"
#include "base/text.h"
#include "cloth/srgb_table.h"

namespace weftlight::texture_set {

using base::for_each_job, base::mark;
using cloth::SrgbTable;

namespace {

using enum Channel;

/// table: null for a linear image.
inline float encoded(float linear, const SrgbTable* table) {
  return table != nullptr ? table->encoded(linear) : linear;
}

float half_range(float v) { return 0.5f + 0.5f * v; }

/// Of an isotropic lobe with the same area as the texel's.
float round_roughness(const GgxAlphas& a) { return std::sqrt(std::sqrt(a.wide * a.narrow)); }

float gltf_strength(const GgxAlphas& a) {
  return a.narrow < 1 ? std::sqrt(std::max(a.wide - a.narrow, 0.0f) / (1 - a.narrow)) : 0.0f;
}

/// Disney's anisotropy a: aspect^2 = narrow / wide = 1 - 0.9 a.
float aspect_anisotropy(const GgxAlphas& a) {
  return a.wide > 0 ? std::clamp((1 - a.narrow / a.wide) / 0.9f, 0.0f, 1.0f) : 0.0f;
}

/// OpenPBR's anisotropy of alphas: wide = r^2 sqrt(2 / (1 + (1 - a)^2)), narrow = (1 - a) wide.
float openpbr_roughness(const GgxAlphas& a) {
  return std::sqrt(std::sqrt(0.5f * (a.wide * a.wide + a.narrow * a.narrow)));
}

/// True if the channel is computed from ggx_alphas().
bool needs_alphas(Channel channel) {
  switch (channel) {
    case kOpenPbrRoughness:
    case kOpenPbrAnisotropy:
    case kLean:
    case kWideAngle:
    case kDetailSmoothness:
    case kRoughness:
    case kSmoothness:
    case kRoughnessNarrow:
    case kWideX:
    case kWideY:
    case kGltfAnisotropy:
    case kAspectAnisotropy:
      return true;
    default:
      return false;
  }
}

/// alphas: of the texel, if needs_alphas(channel).
float value(Channel channel, const SurfaceTexel& t, const GgxAlphas& alphas, const SrgbTable* srgb,
            const SurfaceTexels& surface) {
  switch (channel) {
    case kNone:
      return 0;
    case kOne:
      return 1;
    case kOneHalf:
      return 0.5f;
    case kOpenPbrRoughness:
      return openpbr_roughness(alphas);
    case kOpenPbrAnisotropy:
      return alphas.wide > 0 ? 1 - alphas.narrow / alphas.wide : 0.0f;
    case kLean:
      return std::sqrt(std::max(alphas.wide * alphas.wide - alphas.narrow * alphas.narrow, 0.0f));
    case kWideAngle:
      return axis_turn(alphas.wide_axis, surface.first_turn);
    case kHeightNormalized:
      return (t.height_mm - surface.low_mm) / std::max(surface.high_mm - surface.low_mm, 1e-6f);
    case kDetailNormalX:
      return half_range(-t.normal[0]);
    case kDetailNormalY:
      return half_range(-t.normal[1]);
    case kDetailSmoothness:
      return half_range(1 - round_roughness(alphas) - surface.smoothness);
    case kDetailOcclusion:
      return t.occlusion;
    case kSheenHueR:
    case kSheenHueG:
    case kSheenHueB: {
      const float most = std::max({t.sheen.r, t.sheen.g, t.sheen.b, 1e-6f});
      return encoded((channel == kSheenHueR ? t.sheen.r : channel == kSheenHueG ? t.sheen.g : t.sheen.b) / most, srgb);
    }
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
      return round_roughness(alphas);
    case kSmoothness:
      return 1 - round_roughness(alphas);
    case kRoughnessNarrow:
      return std::sqrt(alphas.narrow);
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
      return half_range(alphas.wide_axis[0]);
    case kWideY:
      return half_range(alphas.wide_axis[1]);
    case kGltfAnisotropy:
      return gltf_strength(alphas);
    case kAspectAnisotropy:
      return aspect_anisotropy(alphas);
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
    case kTransmittedR:
      return encoded(t.transmitted.r, srgb);
    case kTransmittedG:
      return encoded(t.transmitted.g, srgb);
    case kTransmittedB:
      return encoded(t.transmitted.b, srgb);
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

int channels_of(const ImageRow& row) {
  return static_cast<int>(std::find(row.channels.begin(), row.channels.end(), Channel::kNone) - row.channels.begin());
}

bool holds_directions(const ImageRow& row) {
  constexpr Channel kDirections[] = {Channel::kNormalX,     Channel::kNormalY,       Channel::kNormalZ,
                                     Channel::kFibreX,      Channel::kFibreY,        Channel::kFibreZ,
                                     Channel::kWideX,       Channel::kWideY,         Channel::kWideAngle,
                                     Channel::kNormalYDown, Channel::kDetailNormalX, Channel::kDetailNormalY};
  return std::ranges::any_of(row.channels,
                             [&](Channel c) { return std::ranges::find(kDirections, c) != std::end(kDirections); });
}

const char* channel_description(Channel channel) {
  switch (channel) {
    case kNone:
      return mark("none");
    case kOne:
      return mark("one");
    case kOneHalf:
      return mark("one half");
    case kOpenPbrRoughness:
      return mark("roughness (OpenPBR's with its anisotropy)");
    case kOpenPbrAnisotropy:
      return mark("anisotropy (OpenPBR: narrow / wide = 1 - a)");
    case kLean:
      return mark("lean of the normals along the wider axis");
    case kWideAngle:
      return mark("direction of the wider axis, whole turns from right to up");
    case kHeightNormalized:
      return mark("height over the thickness, 0 lowest, 1 highest");
    case kDetailNormalX:
      return mark("normal x, flat is 0.5");
    case kDetailNormalY:
      return mark("normal y, flat is 0.5");
    case kDetailSmoothness:
      return mark("smoothness minus its mean, 0.5 adds nothing");
    case kDetailOcclusion:
      return mark("ambient occlusion, 1 changes nothing");
    case kSheenHueR:
      return mark("sheen hue red");
    case kSheenHueG:
      return mark("sheen hue green");
    case kSheenHueB:
      return mark("sheen hue blue");
    case kBaseR:
      return mark("base colour red");
    case kBaseG:
      return mark("base colour green");
    case kBaseB:
      return mark("base colour blue");
    case kCoverage:
      return mark("coverage");
    case kOcclusion:
      return mark("ambient occlusion");
    case kMetal:
      return mark("metalness");
    case kRoughness:
      return mark("roughness");
    case kSmoothness:
      return mark("smoothness");
    case kRoughnessNarrow:
      return mark("roughness of the narrow axis");
    case kRoughnessAlong:
      return mark("roughness along the fibre");
    case kRoughnessAcross:
      return mark("roughness across the fibre");
    case kNormalX:
      return mark("normal x");
    case kNormalY:
      return mark("normal y, up");
    case kNormalZ:
      return mark("normal z");
    case kNormalYDown:
      return mark("normal y, down");
    case kFibreX:
      return mark("fibre direction x");
    case kFibreY:
      return mark("fibre direction y");
    case kFibreZ:
      return mark("fibre direction z");
    case kWideX:
      return mark("anisotropy direction x");
    case kWideY:
      return mark("anisotropy direction y");
    case kGltfAnisotropy:
      return mark("anisotropy strength (KHR_materials_anisotropy)");
    case kAspectAnisotropy:
      return mark("anisotropy (narrow / wide = 1 - 0.9 a)");
    case kSheenR:
      return mark("sheen colour red");
    case kSheenG:
      return mark("sheen colour green");
    case kSheenB:
      return mark("sheen colour blue");
    case kSheenRoughness:
      return mark("sheen roughness");
    case kSheenWeight:
      return mark("weight of the cloth layer");
    case kTransmittedR:
      return mark("transmitted light red");
    case kTransmittedG:
      return mark("transmitted light green");
    case kTransmittedB:
      return mark("transmitted light blue");
    case kHeightMm:
      return mark("height in millimetres above the middle plane");
    case kThreadLow:
      return mark("thread index modulo 65536");
    case kThreadHigh:
      return mark("thread index over 65536");
    case kSystem:
      return mark("thread system: 0 warp, 1 weft");
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

Image pack(const ImageRow& row, const SurfaceTexels& surface, int threads) {
  const int width = surface.texels.width, height = surface.texels.height;
  const auto end = std::find(row.channels.begin(), row.channels.end(), kNone);
  const int channels = static_cast<int>(end - row.channels.begin());
  Image image{
      width, height, channels,
      std::vector<float>(static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(channels))};
  const bool has_lobes = std::any_of(row.channels.begin(), end, needs_alphas);
  const SrgbTable* const srgb = row.srgb ? &SrgbTable::get() : nullptr;
  for_each_job(height, threads, [&](int y) {
    const SurfaceTexel* texel = surface.texels.row(y);
    float* out = image.texels.data() + static_cast<size_t>(y) * static_cast<size_t>(width * channels);
    for (int x = width - 1; x >= 0; --x) {
      const GgxAlphas alphas = has_lobes ? ggx_alphas(texel[x]) : GgxAlphas{};
      for (int c = 0; c < channels; ++c)
        *out++ = value(row.channels[static_cast<size_t>(c)], texel[x], alphas, srgb, surface);
    }
  });
  return image;
}

Image pack_planes(const std::vector<Plane<float>>& planes) {
  if (planes.empty()) return {};
  const int width = planes[0].width, height = planes[0].height, channels = static_cast<int>(planes.size());
  Image image{width, height, channels, {}};
  image.texels.reserve(static_cast<size_t>(width) * static_cast<size_t>(height) * planes.size());
  const size_t half_turn = planes.size() / 2;  // from the azimuths of the cloth to those of the image
  for (int y = 0; y < height; ++y) {
    for (int x = width - 1; x >= 0; --x) {
      for (size_t k = 0; k < planes.size(); ++k)
        image.texels.push_back(planes[(k + half_turn) % planes.size()].at(x, y));
    }
  }
  return image;
}

}  // namespace weftlight::texture_set
