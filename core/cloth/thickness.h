#pragma once
// Section and place of an uneven thread at its crossings, by shaders/thread_thickness.glsl, the same for bodies, tubes,
// maps and heights.

#include <glm/glm.hpp>
#include <span>

#include "cloth/centre_step.h"
#include "cloth/cloth.h"
#include "cloth/thread_texture.h"

namespace weftlight::cloth {

using design::Finish, design::Yarn;
using draft::System;
using thread_formulas::ThreadSection;

/// Fraction of the threads' relief that the densest nap removes; by eye.
inline constexpr float kNapFlattening = 0.93f;

/// Standard deviation of a yarn's thickness along it, over its mean; smaller under a nap.
float unevenness_of(const Yarn& yarn, const Finish& finish);

/// Lets the threads of a row, which is periodic, share its room: the border between two moves away from the thicker
/// one (`thickness`: over the yarn's mean, by thread), and sways as they are uneven. The threads' widths and heights
/// are those of their yarn's mean thickness on entry; then each fills the same part of its room, and its area is its
/// own.
void give_way(std::span<ThreadBody> row, std::span<const float> thickness);

/// As the formulas read it. length_mm: period along the thread; it sways less if it is too short for a thick and a thin
/// place.
ThreadSection thread_section(const ThreadBody& body, float length_mm);

/// Half width, half height, and offset of the centre towards +across (mm), of a thread at a crossing; both indices
/// wrap. The cloth has one layer.
glm::vec3 section_at(const Cloth& cloth, System system, int thread, int crossing);
/// The same between two crossings.
glm::vec3 section_at(const Cloth& cloth, System system, int thread, const CentreStep& step);

/// Between two crossings, as the shaders do: linear in the offset and in 1 over the sizes. t: 0 to 1.
inline glm::vec3 section_between_crossings(const glm::vec3& here, const glm::vec3& next, float t) {
  const glm::vec2 a = 1.0f / glm::vec2(here), b = 1.0f / glm::vec2(next);
  return {1.0f / (a + (b - a) * t), here.z + (next.z - here.z) * t};
}

/// Half height of the thickest thread of a system, at its thickest.
float tallest_half(const Cloth& cloth, System system);
/// The furthest that a thread reaches to a side of its place.
float furthest_side(const ThreadBody& body);

/// Whether any thread of the system is uneven or stands aside.
bool uneven(const Cloth& cloth, System system);
bool uneven(const ThreadBody& body);

}  // namespace weftlight::cloth
