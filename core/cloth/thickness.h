#pragma once
// How thick a thread is where it crosses another, by shaders/thread_thickness.glsl: the same place for bodies, tubes,
// maps and heights.

#include <glm/glm.hpp>

#include "cloth/centre_line.h"
#include "cloth/cloth.h"
#include "cloth/names.h"

namespace weftlight::cloth {

/// Of the threads' relief, under the closest nap; by eye.
inline constexpr float kReliefLost = 0.93f;

/// Standard deviation of a yarn's thickness along it, over its mean; less under a nap.
float unevenness_of(const Yarn& yarn, const Finish& finish);

/// That of a thread in a period so long: less where it is too short for a thick and a thin place to follow one another.
float spread_in(const ThreadBody& body, float length_mm);

/// Half width and half height (mm) of a thread of a cloth in one layer, or of a layer alone, at a crossing; both
/// indices may run outside 0..count (they wrap).
glm::vec2 half_section(const Cloth& cloth, System system, int thread, int crossing);
/// The same between two crossings.
glm::vec2 half_section(const Cloth& cloth, System system, int thread, const CentreStep& step);

/// Half height of the thickest place of a system.
float tallest_half(const Cloth& cloth, System system);

/// Whether any thread of the system swells.
bool uneven(const Cloth& cloth, System system);

}  // namespace weftlight::cloth
