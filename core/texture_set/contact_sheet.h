#pragma once
// One picture of a whole texture set: the cloth lit flat, and every image of the set with its name.

#include <string>
#include <vector>

#include "files/files.h"
#include "texture_set/names.h"
#include "texture_set/surface_texels.h"

namespace weftlight::texture_set {

struct SheetEntry {
  std::string label;
  Image image;  // a thumbnail()
};

/// A small sRGB-encoded RGB picture of an image of a set, in its proportions: one channel is grey, values
/// outside 0..1 are stretched to their range, alpha is left out.
Image thumbnail(const Image& image);
/// The same of thread indices (thread low, thread high, system): a colour of its own for each.
Image thread_thumbnail(const Image& image);

/// sRGB-encoded RGB.
Image contact_sheet(const std::string& title, const std::string& facts, const Surface& front,
                    const std::vector<SheetEntry>& entries);

/// A flat swatch under one light from the upper left, with fibre highlights; sRGB-encoded RGB. Shows
/// `repeats` periods across, whatever its size.
Image lit_swatch(const Surface& surface, int width, int height, float repeats_across);

}  // namespace weftlight::texture_set
