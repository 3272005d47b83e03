#pragma once
// One picture of a whole texture set: a lit flat swatch, and every image of the set with its name.

#include <string>
#include <vector>

#include "files/files.h"
#include "texture_set/surface_texels.h"

namespace weftlight::texture_set {

using files::Image;

struct SheetEntry {
  std::string label;
  Image image;  // a thumbnail()
};

/// A small sRGB-encoded RGB picture of an image, in its proportions. One channel becomes grey, a range beyond 0..1 is
/// mapped to 0..1 (of `stretched` any range), alpha is dropped.
Image thumbnail(const Image& image, bool stretched = false);
/// The same for thread indices (thread low, thread high, system), each in a different colour.
Image thread_thumbnail(const Image& image);

/// The large picture of the sheet: lit_swatch() of the front.
Image sheet_swatch(const SurfaceTexels& front);
/// sRGB-encoded RGB. `swatch`: a sheet_swatch().
Image contact_sheet(const std::string& title, const std::string& facts, const Image& swatch,
                    const std::vector<SheetEntry>& entries);

/// A flat swatch under one light from the upper left, with fibre highlights; sRGB-encoded RGB, `repeats_across` repeats
/// wide.
Image lit_swatch(const SurfaceTexels& surface, int width, int height, float repeats_across);

}  // namespace weftlight::texture_set
