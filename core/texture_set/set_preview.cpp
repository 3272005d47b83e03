#include "texture_set/set_preview.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "design/edits.h"
#include "draft/drawdown.h"
#include "texture_set/contact_sheet.h"
#include "texture_set/material_files.h"

namespace weftlight::texture_set {

using base::tr;
using design::spacing_of, design::with_size;
using draft::System, draft::drawdown;
using files::PixelType, files::encode_png;

namespace {

constexpr float kMaxRepeats = 40;  // of the tile, across a swatch
constexpr float kPizRatio = 0.7f;  // compressed size of half floats of our maps

float bytes_of(const ImageRow& row, const Image& image) {
  if (row.type == PixelType::kHalf) return kPizRatio * 2 * static_cast<float>(image.texels.size());
  return static_cast<float>(encode_png(image, row.type).size());
}

/// Threads from the first to cover that many mm; all of them if they do not.
int threads_for(const Design& design, System system, float mm) {
  const int count = design.draft.threads(system).size();
  double covered = 0;
  for (int i = 0; i < count; ++i)
    if ((covered += spacing_of(design, system, i)) >= static_cast<double>(mm)) return i + 1;
  return count;
}

/// Without the threads beyond a swatch, so that a picture of a wide cloth costs no more than one of a sample.
Design cut_for_swatch(Design design, float across_mm, float down_mm) {
  const int ends = threads_for(design, System::kWarp, across_mm), picks = threads_for(design, System::kWeft, down_mm);
  const int shafts = design.draft.shafts, treadles = design.draft.treadles;
  return with_size(std::move(design), ends, picks, shafts, treadles);
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

Image flat_swatch(const Design& design, Face face, int width, int height, float across_mm,
                  const std::stop_token& stop) {
  constexpr int kMinSide = 32, kMaxSide = 1024;
  constexpr float kTexelsPerPixel = 1.5f;
  if (design.draft.ends() < 1 || design.draft.picks() < 1 || width < 1 || height < 1 || !(across_mm > 0)) return {};
  const float mm_per_pixel = across_mm / static_cast<float>(width);
  const Design shown = cut_for_swatch(design, across_mm, mm_per_pixel * static_cast<float>(height));
  if (stop.stop_requested()) return {};
  Tile tile = make_tile(shown, drawdown(shown.draft), face, kTileOfYarns, kMaxSide);
  const float side_mm = std::max(tile.cloth.width_mm, tile.cloth.depth_mm);
  int side = kMinSide;
  while (side < kMaxSide && static_cast<float>(side) < kTexelsPerPixel * side_mm / mm_per_pixel) side *= 2;
  FaceOptions options;
  options.size = texture_size(tile.cloth.width_mm, tile.cloth.depth_mm, side);
  options.fitted = false;
  const FaceSource source(std::move(tile), options);
  if (stop.stop_requested()) return {};
  const SurfaceTexels& surface = source.small();
  return lit_swatch(surface, width, height, across_mm / surface.width_mm);
}

}  // namespace weftlight::texture_set
