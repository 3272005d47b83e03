#pragma once
// Pictures as drafts: a pixel a crossing, for a Jacquard machine.

#include <string>

#include "files/names.h"
#include "wif/wif.h"

namespace weftlight::files {

/// By its ending: .png, .tif, .tiff or .bmp.
bool is_picture(const std::string& path);
/// A liftplan with a shaft an end. Two colours are crossings, the darker with the warp on top; of more each becomes a
/// weave. Errors: no picture, or more pixels than shafts or picks.
wif::WifRead read_picture_draft(const std::string& path);

}  // namespace weftlight::files
