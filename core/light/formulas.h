#pragma once
// The formulas of shaders/*.glsl as C++: the same text, through GLM, in weftlight::formulas.
// Its tables are those of light/tables.h.

#include <glm/glm.hpp>

namespace weftlight::formulas {

using glm::ivec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using namespace glm;

vec4 albedo_table(float opening, float along, float across);
vec2 albedo_mean_table(float major, float minor);
vec4 fuzz_table(float opening, float depth);

#define FORMULA inline
#include "shaders/filter.glsl"
#include "shaders/horizon.glsl"
#include "shaders/lobes.glsl"
#include "shaders/tone.glsl"
#include "shaders/vrst03.glsl"
#undef FORMULA

}  // namespace weftlight::formulas
