#include "render_data/picture_layers.h"

#include <array>
#include <cmath>

namespace weftlight::render_data {

using draft::System;
using reference::PixelLayers;

namespace {

constexpr size_t kPictureChannels = 4, kLayerChannels = 17;

std::array<float, kLayerChannels> values_of(const PixelLayers& l, glm::vec3 radiance, float exposure) {
  const glm::vec3 direct = l.direct * exposure, indirect = radiance * exposure - direct;
  const float number = static_cast<float>(l.thread + 1);
  const bool end = l.system == System::kWarp;
  return {l.depth_mm, l.albedo.r,       l.albedo.g,       l.albedo.b, direct.r,   direct.g,
          direct.b,   indirect.r,       indirect.g,       indirect.b, l.normal.x, l.normal.y,
          l.normal.z, end ? number : 0, end ? 0 : number, l.uv_mm.x,  l.uv_mm.y};
}

}  // namespace

const std::vector<std::string>& layer_channels() {
  static const std::vector<std::string> names{
      "R",        "G",        "B",        "A",        "Z",          "albedo.R",   "albedo.G",
      "albedo.B", "direct.R", "direct.G", "direct.B", "indirect.R", "indirect.G", "indirect.B",
      "normal.X", "normal.Y", "normal.Z", "thread.X", "thread.Y",   "uv.U",       "uv.V"};
  return names;
}

Image with_layers(const Image& picture, const TracedImage& traced, float exposure_ev) {
  const float exposure = std::exp2(exposure_ev);
  Image out{picture.width, picture.height, static_cast<int>(kPictureChannels + kLayerChannels), {}};
  out.texels.reserve(traced.pixels.size() * (kPictureChannels + kLayerChannels));
  for (size_t i = 0; i < traced.pixels.size(); ++i) {
    const auto first = picture.texels.begin() + static_cast<std::ptrdiff_t>(i * kPictureChannels);
    out.texels.insert(out.texels.end(), first, first + kPictureChannels);
    const auto values = values_of(traced.layers[i], glm::vec3(traced.pixels[i]), exposure);
    out.texels.insert(out.texels.end(), values.begin(), values.end());
  }
  return out;
}

}  // namespace weftlight::render_data
