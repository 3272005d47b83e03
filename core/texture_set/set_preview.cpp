#include "texture_set/set_preview.h"

#include <algorithm>
#include <cmath>

#include "draft/drawdown.h"
#include "texture_set/contact_sheet.h"
#include "texture_set/set_images.h"

namespace weftlight::texture_set {
namespace {

constexpr float kMaxRepeats = 40;  // of the tile across a swatch
constexpr float kExrShare = 0.7f;  // that piz leaves of half floats of our maps

/// A material that comes in one file with its images holds them a second time.
bool is_packed_too(Target target) {
  return target == Target::kGltf || target == Target::kU3m || target == Target::kMaterialX;
}

float bytes_of(const ImageRow& row, const Image& image) {
  if (row.type == PixelType::kHalf) return kExrShare * 2 * static_cast<float>(image.texels.size());
  return static_cast<float>(encode_png(image, row.type).size());
}

std::vector<std::string> words_of(const ImageRow& row) {
  std::vector<std::string> out;
  for (int c = 0; c < channels_of(row); ++c) out.emplace_back(channel_words(row.channels[static_cast<size_t>(c)]));
  return out;
}

}  // namespace

SetPreview preview_set(const Design& design, Face face, const TextureSetOptions& options, int side, int swatch_width,
                       int swatch_height, float swatch_mm, const std::stop_token& stop) {
  SetPreview out;
  if (design.draft.ends() < 1 || design.draft.picks() < 1 || stop.stop_requested()) return out;
  const FaceSource source = face_at(design, face, options, side);
  if (stop.stop_requested()) return out;
  const Surface surface = source.rows(0, source.size().height);
  out.coverage = source.coverage();
  out.alpha = alpha_for(options.target, options.alpha, out.coverage);
  float bytes = 0;
  for (const ImageRow& row : image_rows(options.target)) {
    Image image = pack(row, surface);
    bytes += bytes_of(row, image);
    out.images.push_back({image_file(row, options.name, face), row.srgb, std::move(image), words_of(row)});
  }
  const float texels = static_cast<float>(surface.texels.width) * static_cast<float>(surface.texels.height);
  out.bytes_a_texel = bytes / texels * (is_packed_too(options.target) ? 2.0f : 1.0f);
  const float repeats = std::max(2.0f, std::ceil(swatch_mm / std::max(surface.width_mm, 0.1f)));
  out.swatch = lit_swatch(source.small(), swatch_width, swatch_height, std::min(repeats, kMaxRepeats));
  return out;
}

}  // namespace weftlight::texture_set
