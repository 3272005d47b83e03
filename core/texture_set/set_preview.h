#pragma once
// A preview of a texture set in few texels: every image with its channels, and a lit swatch of the tile.

#include <stop_token>
#include <string>
#include <vector>

#include "texture_set/texture_set.h"

namespace weftlight::texture_set {

using design::Design;
using draft::Face;
using files::Image;

struct PreviewImage {
  std::string file;
  bool srgb = false;
  Image image;                        // as in the file
  std::vector<std::string> channels;  // descriptions in the user's language
};

struct SetPreview {
  std::vector<PreviewImage> images;  // of one face
  Image swatch;                      // sRGB-encoded RGB
  Alpha alpha = Alpha::kOpaque;      // the resolved mode, never kAuto
  float coverage = 1;
  float bytes_per_texel = 0;  // estimated size of the files of one face on the disk
};

/// `side`: most texels per side of the images. The swatch shows `swatch_mm` of cloth across, at least two tiles. Empty
/// if the draft has no cloth or `stop` was requested.
SetPreview preview_set(const Design& design, Face face, const TextureSetOptions& options, int side, int swatch_width,
                       int swatch_height, float swatch_mm, const std::stop_token& stop = {});

/// A lit flat swatch of the first ends and picks, `across_mm` of cloth wide: sRGB-encoded RGB. The lights and the scale
/// are the same for every design, so that swatches can be compared. Empty as preview_set().
Image flat_swatch(const Design& design, Face face, int width, int height, float across_mm,
                  const std::stop_token& stop = {});

}  // namespace weftlight::texture_set
