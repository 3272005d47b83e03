#pragma once
// Pictures as drafts: a pixel a crossing, for a Jacquard machine.

#include <string>

#include "files/names.h"
#include "wif/wif.h"

namespace weftlight::files {

/// By its ending: .png, .tif, .tiff or .bmp.
bool is_picture(const std::string& path);
/// How a picture becomes a drawdown. Two colours are crossings, the darker with the warp on top; of more each becomes a
/// weave, the darkest the most warp-faced.
struct PictureDraft {
  int ends = 0;           // 0: a pixel an end; else the picture is made so wide, and so high as to keep its shape
  int colors = 0;         // 2..16 that it is reduced to, each a weave; 0: two as crossings, of more up to eight
  int longest_float = 7;  // 1 and up, on both faces of such weaves
  bool operator==(const PictureDraft&) const = default;
};
/// A liftplan with a shaft an end. Errors: no picture, or more pixels than shafts or picks.
wif::WifRead read_picture_draft(const std::string& path, const PictureDraft& how = {});

}  // namespace weftlight::files
