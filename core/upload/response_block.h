#pragma once
// The answers of both faces to light from afar (light/cloth_response.h), laid out as the renderer uploads them.

#include <vector>

#include "light/cloth_response.h"
#include "upload/cloth_block.h"
#include "upload/names.h"
#include "upload/packed_maps.h"

namespace weftlight::upload {

// Azimuths with the first again at the end; rows face * 2 + system, each of all elevations: the answer, then how it
// leans; a layer a view.
inline constexpr int kResponseWidth = kLightAzimuths + 1, kSeenWidth = kViewAzimuths + 1;
inline constexpr int kResponseHeight = 8 * kResponseElevations;
inline constexpr int kSlopeRows = 8;                         // (face * 2 + system) * 2 + axis
inline constexpr int kSeenHeight = 2 * kResponseElevations;  // rows face; share of the warp seen, its rise, heights
inline constexpr size_t kBroadFloats = size_t{4} * kResponseWidth * kResponseHeight * kResponseViews;
inline constexpr size_t kSlopeFloats = size_t{kSlopeBins} * kSlopeRows;
inline constexpr size_t kSeenFloats = size_t{4} * kSeenWidth * kSeenHeight;
inline constexpr size_t kResponseFloats = kBroadFloats + kSlopeFloats + kSeenFloats;

/// Gives a block of cloth_block() the answer, and the means with it, of an earlier whole block.
void keep_response(std::vector<float>& block, const std::vector<float>& earlier);

/// Yarns a pixel from which on the packed colour of the face is the same everywhere to 2 percent.
float even_from_yarns(const PackedFace& face, float width_mm, float spacing_mm);

/// Appends response, slopes and seen to a block of cloth_block(), and sets its means.
void append_response(std::vector<float>& block, const FaceInput& front, const FaceInput& back,
                     int samples = kResponseSamples);

}  // namespace weftlight::upload
