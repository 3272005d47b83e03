#pragma once
// Pictures as drafts: one crossing per pixel, for a Jacquard loom.

#include <string>

#include "wif/wif.h"

namespace weftlight::files {

/// By its extension: .png, .tif, .tiff or .bmp.
bool is_picture(const std::string& path);
/// How a picture becomes a drawdown. Two colours are crossings, the darker one with the warp on top. Of more colours
/// each becomes a weave, the darkest the most warp-faced.
struct PictureDraft {
  int ends = 0;           // width after scaling, with the same proportions; 0: one end per pixel
  int colors = 0;         // 2..16 colours, each a weave; 0: two become crossings, more are reduced to at most eight
  int longest_float = 7;  // of these weaves, on both faces; 1 and up
  bool operator==(const PictureDraft&) const = default;
};
/// A liftplan with one shaft per end. Errors: not a picture, or more pixels than shafts or picks.
wif::WifRead read_picture_draft(const std::string& path, const PictureDraft& options = {});

}  // namespace weftlight::files
