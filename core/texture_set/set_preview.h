#pragma once
// A texture set as it will be, in few texels: every image with its channels, and a lit swatch of the tile.

#include <stop_token>
#include <string>
#include <vector>

#include "texture_set/names.h"
#include "texture_set/texture_set.h"

namespace weftlight::texture_set {

struct PreviewImage {
  std::string file;
  bool srgb = false;
  Image image;                        // as the file holds it
  std::vector<std::string> channels;  // what each holds, in words
};

struct SetPreview {
  std::vector<PreviewImage> images;  // of one face
  Image swatch;                      // sRGB-encoded RGB
  Alpha alpha = Alpha::kOpaque;      // what Alpha::kAuto comes to
  float coverage = 1;
  float bytes_a_texel = 0;  // that the files of one face take on the disk, about: of these images
};

/// `side`: texels of its images at most; the swatch shows `swatch_mm` of cloth across, at least two tiles. Empty where
/// the draft has no cloth or `stop` was asked for.
SetPreview preview_set(const Design& design, Face face, const TextureSetOptions& options, int side, int swatch_width,
                       int swatch_height, float swatch_mm, const std::stop_token& stop = {});

}  // namespace weftlight::texture_set
