#pragma once
// Far-field response of both faces (light/cloth_response.h), in the layout of the renderer's textures.

#include <glm/glm.hpp>
#include <vector>

#include "light/measure_response.h"
#include "render_data/cloth_block.h"
#include "render_data/packed_maps.h"

namespace weftlight::render_data {

using light::kLightAzimuths, light::kResponseElevations, light::kResponseSamples, light::kTransmissionAzimuths,
    light::kViewAzimuths;

// Azimuths with the first repeated at the end. Reflected light and gradient are side by side, those of light from
// behind below.
inline constexpr int kReflectionWidth = kLightAzimuths + 1, kViewTableWidth = kViewAzimuths + 1;
inline constexpr int kResponseWidth = RESPONSE_WIDTH, kResponseHeight = RESPONSE_HEIGHT;
static_assert(2 * kReflectionWidth <= kResponseWidth && kTransmissionAzimuths + 1 <= kResponseWidth);
inline constexpr int kSlopeRows = 4 * light::kSlopeBins;  // (face * 2 + system) * bins + angle along y
inline constexpr int kViewTableHeight = VIEW_TABLES * kResponseElevations;

/// Yarns a pixel from which on the packed colour of the face is uniform to 2 percent.
float even_from_yarns(const PackedFace& face, float width_mm, float spacing_mm);

/// Response tables of front and back; sets the corresponding means in `data`.
ResponseTables response_tables(interop::ClothData& data, const FaceInput& front, const FaceInput& back,
                               int samples = kResponseSamples);

/// Copies the means of an earlier response that is kept.
void keep_response(interop::ClothData& data, const interop::ClothData& earlier);

}  // namespace weftlight::render_data
