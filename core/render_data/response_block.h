#pragma once
// The answers of both faces to light from afar (light/cloth_response.h), laid out as the renderer uploads them.

#include <glm/glm.hpp>
#include <vector>

#include "light/cloth_response.h"
#include "render_data/cloth_block.h"
#include "render_data/names.h"
#include "render_data/packed_maps.h"

namespace weftlight::render_data {

// Azimuths with the first again at the end. Answer and lean stand side by side, below them the answer from behind.
inline constexpr int kAnswerWidth = kLightAzimuths + 1, kSeenWidth = kViewAzimuths + 1;
inline constexpr int kResponseWidth = RESPONSE_WIDTH, kResponseHeight = RESPONSE_HEIGHT;
static_assert(2 * kAnswerWidth <= kResponseWidth && kBehindAzimuths + 1 <= kResponseWidth);
inline constexpr int kSlopeRows = 8;  // (face * 2 + system) * 2 + axis
inline constexpr int kSeenHeight = SEEN_TABLES * kResponseElevations;

/// Yarns a pixel from which on the packed colour of the face is the same everywhere to 2 percent.
float even_from_yarns(const PackedFace& face, float width_mm, float spacing_mm);

/// The answers of the front and of the back, and in `data` the means that go with them.
ResponseTables response_tables(interop::ClothData& data, const FaceInput& front, const FaceInput& back,
                               int samples = kResponseSamples);

/// Gives `data` the means of an earlier answer, which is kept.
void keep_response(interop::ClothData& data, const interop::ClothData& earlier);

}  // namespace weftlight::render_data
