#include "texture_set/set_preview.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "draft/drawdown.h"
#include "texture_set/contact_sheet.h"
#include "texture_set/material_files.h"

namespace weftlight::texture_set {

using base::tr;
using files::PixelType, files::encode_png;

namespace {

constexpr float kMaxRepeats = 40;  // of the tile, across a swatch
constexpr float kPizRatio = 0.7f;  // compressed size of half floats of our maps

float bytes_of(const ImageRow& row, const Image& image) {
  if (row.type == PixelType::kHalf) return kPizRatio * 2 * static_cast<float>(image.texels.size());
  return static_cast<float>(encode_png(image, row.type).size());
}

std::vector<std::string> channel_descriptions(const ImageRow& row) {
  std::vector<std::string> out;
  for (int c = 0; c < channels_of(row); ++c)
    out.emplace_back(tr(channel_description(row.channels[static_cast<size_t>(c)])));
  return out;
}

}  // namespace

SetPreview preview_set(const Design& design, Face face, const TextureSetOptions& options, int side, int swatch_width,
                       int swatch_height, float swatch_mm, const std::stop_token& stop) {
  SetPreview out;
  if (design.draft.ends() < 1 || design.draft.picks() < 1 || stop.stop_requested()) return out;
  const FaceSource source = face_at(design, face, options, side);
  if (stop.stop_requested()) return out;
  const ExportTarget& target = *options.target;
  const SurfaceTexels surface = source.rows(0, source.size().height);
  out.coverage = source.coverage();
  out.alpha = alpha_for(target, options.alpha, out.coverage);
  float bytes = 0;
  for (const ImageRow& row : target.images) {
    Image image = pack(row, surface);
    bytes += bytes_of(row, image);
    out.images.push_back(
        {image_file(target, row, options.name, face), row.srgb, std::move(image), channel_descriptions(row)});
  }
  const float texels = static_cast<float>(surface.texels.width) * static_cast<float>(surface.texels.height);
  out.bytes_per_texel = bytes / texels * (target.embeds_images ? 2.0f : 1.0f);
  const float repeats = std::max(2.0f, std::ceil(swatch_mm / std::max(surface.width_mm, 0.1f)));
  out.swatch = lit_swatch(source.small(), swatch_width, swatch_height, std::min(repeats, kMaxRepeats));
  return out;
}

}  // namespace weftlight::texture_set
