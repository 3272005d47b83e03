#pragma once
// The fine pattern on a thread, as the formulas of shaders/thread_texture.glsl read it: grooves, plies and tone
// over (around, along), periodic with the tile.

#include <cstdint>
#include <glm/glm.hpp>

#include "cloth/cloth.h"
#include "cloth/names.h"

namespace weftlight::cloth {

namespace thread_formulas {
using glm::uint;
using namespace glm;
#define FORMULA inline
#include "shaders/thread_curve.glsl"
#include "shaders/thread_texture.glsl"
#undef FORMULA
}  // namespace thread_formulas

using thread_formulas::contrast_left;
using thread_formulas::Texel;
using thread_formulas::texture_at;
using thread_formulas::TexturePoint;
using thread_formulas::ThreadTexture;

/// `length_mm` is the period along the thread.
ThreadTexture thread_texture(const Yarn& yarn, const ThreadBody& body, System system, int thread, float length_mm);

}  // namespace weftlight::cloth
