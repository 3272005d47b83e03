#pragma once
// Thickness of an uneven thread at its crossings, by shaders/thread_thickness.glsl, the same for bodies, tubes, maps
// and heights.

#include <glm/glm.hpp>

#include "cloth/centre_line.h"
#include "cloth/cloth.h"

namespace weftlight::cloth {

using design::Finish, design::Yarn;
using draft::System;

/// Fraction of the threads' relief that the densest nap removes; by eye.
inline constexpr float kNapFlattening = 0.93f;

/// Standard deviation of a yarn's thickness along it, over its mean; smaller under a nap.
float unevenness_of(const Yarn& yarn, const Finish& finish);

/// The same for a thread of this length; smaller where it is too short for a thick and a thin place.
float spread_in(const ThreadBody& body, float length_mm);

/// Half width and half height (mm) of a thread at a crossing; both indices wrap. The cloth has one layer.
glm::vec2 half_section(const Cloth& cloth, System system, int thread, int crossing);
/// The same between two crossings.
glm::vec2 half_section(const Cloth& cloth, System system, int thread, const CentreStep& step);

/// Half height of the thickest thread of a system, at its thickest.
float tallest_half(const Cloth& cloth, System system);

/// Whether any thread of the system has uneven thickness.
bool uneven(const Cloth& cloth, System system);

}  // namespace weftlight::cloth
