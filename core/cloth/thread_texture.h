#pragma once
// The fine pattern on a thread, as the formulas of shaders/thread_texture.glsl read it: grooves, plies and tone
// over (around, along), periodic with the tile; and the records of threads of shaders/thread_records.glsl.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/cloth.h"
#include "design/fibre_facts.h"
#include "shaders/interop.h"

namespace weftlight::cloth {

using design::FibreFacts, design::Yarn;
using draft::System;

namespace thread_formulas {
using glm::uint;
using interop::YarnData;
using namespace glm;
#define FORMULA inline
#include "shaders/crossing_height.glsl"
#include "shaders/thread_curve.glsl"
#include "shaders/thread_records.glsl"
#undef FORMULA
}  // namespace thread_formulas

static_assert(sizeof(thread_formulas::ThreadHead) == THREAD_HEAD_TEXELS * sizeof(glm::uvec4));
static_assert(sizeof(thread_formulas::ThreadRecord) == THREAD_TEXELS * sizeof(glm::uvec4));
static_assert(offsetof(thread_formulas::ThreadRecord, body) == THREAD_BODY * sizeof(glm::uvec4));
static_assert(offsetof(thread_formulas::ThreadRecord, color) == THREAD_COLOR * sizeof(glm::uvec4));
static_assert(offsetof(thread_formulas::ThreadRecord, pattern) == THREAD_PATTERN * sizeof(glm::uvec4));
static_assert(offsetof(thread_formulas::ThreadRecord, dye) == THREAD_DYE * sizeof(glm::uvec4));

using thread_formulas::contrast_left;
using thread_formulas::fibre_detail;
using thread_formulas::FibreDetail;
using thread_formulas::Texel;
using thread_formulas::texture_at;
using thread_formulas::TexturePoint;
using thread_formulas::ThreadHead;
using thread_formulas::ThreadRecord;
using thread_formulas::ThreadTexture;

/// `length_mm` is the period along the thread.
ThreadTexture thread_texture(const Yarn& yarn, const ThreadBody& body, System system, int thread, float length_mm);
/// The same with the facts of the yarn's fibre known; they count only for fibre_detail.glsl.
ThreadTexture thread_texture(const Yarn& yarn, const FibreFacts& facts, const ThreadBody& body, System system,
                             int thread, float length_mm);
/// Of the fibre of each of its yarns.
std::vector<FibreFacts> fibre_facts(const Cloth& cloth);
/// Textures of all ends, then of all picks.
std::array<std::vector<ThreadTexture>, 2> thread_textures(const Cloth& cloth);

}  // namespace weftlight::cloth
