#pragma once
// Pictures as drafts: one crossing per pixel, for a Jacquard loom.

#include <string>
#include <vector>

#include "base/progress.h"
#include "files/files.h"
#include "wif/wif.h"

namespace weftlight::files {

using design::Design;
using draft::BitMatrix, draft::Rgb;

/// By its extension: .png, .tif, .tiff or .bmp.
bool is_picture(const std::string& path);
/// The part of a picture that is woven, in pixels from its upper left corner; without width or height all of it.
struct PictureCrop {
  int left = 0, top = 0, width = 0, height = 0;
  bool operator==(const PictureCrop&) const = default;
};
/// How a picture becomes a drawdown. Two colours are crossings, the darker one with the warp on top. Of more colours
/// each becomes a weave, the darkest the most warp-faced.
struct PictureDraft {
  PictureCrop crop{};
  int ends = 0;           // width after scaling; 0: one end per pixel
  int picks = 0;          // height after scaling; 0: with the same proportions
  int colors = 0;         // 2..16 colours, each a weave; 0: two become crossings, more are reduced to at most eight
  int longest_float = 7;  // of these weaves, on both faces; 1 and up
  std::vector<BitMatrix> weaves{};  // the weaver's own for the colours, from dark to light; see weaves::PictureWeave
  bool own_colors = false;          // warp in its darkest colour, weft in its lightest; otherwise black and white
  bool operator==(const PictureDraft&) const = default;
};
/// A picture of at most kMaxPictureSide pixels a side.
base::Result<Image> read_picture(const std::string& path);
inline constexpr int kMaxPictureSide = 16384;

/// A woven picture, and what its dialog says of it.
struct WovenPicture {
  Design design;               // a liftplan with one shaft per end
  std::vector<Rgb> colors;     // of the reduced picture, dark to light
  std::vector<float> portion;  // of the picture that has each, 0..1
  bool by_crossings = false;   // its two colours are crossings, without weaves
};
/// Errors: no pixels, a crop outside of the picture, or more ends than shafts. Asked to stop, it gives some draft soon.
base::Result<WovenPicture> woven_picture(const Image& picture, const PictureDraft& options = {},
                                         const base::TaskProgress& progress = {});

/// A weave from words (weaves::read_weave_words), or the repeat of the draft at that path.
base::Result<BitMatrix> read_weave(const std::string& words);

/// A liftplan with one shaft per end. Errors: not a picture, or more pixels than shafts or picks.
wif::WifRead read_picture_draft(const std::string& path, const PictureDraft& options = {});

}  // namespace weftlight::files
