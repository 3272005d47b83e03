#pragma once
// The fine pattern on a thread: dark grooves that follow the fibres' twist, plies, and the uneven
// tone of stray fibres. A procedural texture over (around, along), periodic with the tile.

#include <cstdint>

#include "cloth/cloth.h"

namespace weftlight {

/// What the texture of one thread needs, worked out once a thread.
struct ThreadTexture {
  float fibres = 1;        // grooves once around
  int advance = 0;         // grooves that pass in one period along; sign: the hand of the twist
  float fibre_tan = 0;     // tangent of the angle from the axis to the fibre, towards +across
  int plies = 1;
  int ply_advance = 0;
  float ply_relief_mm = 0; // depth of the furrow between plies
  float phase = 0, ply_phase = 0;
  int singles = 0;         // single fibres that pass in one period along; 0: without twist
  int stray_advance = 0;   // like advance, of the stray fibres that cross the others
  int nodes = 1;           // of the tone along one period
  float depth = 0, hair = 0;
  float radius_mm = 0;
  uint32_t seed = 0;
};

/// `length_mm` is the period along the thread.
ThreadTexture thread_texture(const Yarn& yarn, const ThreadBody& body, System system, int thread, float length_mm);

/// Stray fibres are this much sparser than grooves around the thread.
inline constexpr float kStraySpacing = 2.5f;

/// Share of a pattern's contrast that is left when one sample spans `cycles` of it (0: all, 1: none).
inline float contrast_left(float cycles) { return cycles < 0.25f ? 1.0f : cycles > 0.75f ? 0.0f : 1.5f - 2.0f * cycles; }

/// Grooves do not run quite straight: how far they are off at a place along, in grooves.
float wander(const ThreadTexture& texture, int node, float blend);

/// Place on the texture. `turn` counts grooves (fibres * angle / 2 pi + advance * s / length + wander).
struct TexturePoint {
  float turn = 0;      // in grooves
  float ply_turn = 0;  // in plies
  float stray_turn = 0;
  int node = 0;        // of the tone along, 0..nodes - 1
  float blend = 0;     // to the next node
  float cycles = 0;    // grooves that one sample spans
  float ply_fade = 1;
};

struct Texel {
  float groove = 1;  // factor, mean over the thread independent of fade
  float tone = 1;    // factor on the thread's colour, mean 1
  float ply = 0;     // -1..1 across a ply: 0 at its ridge
};
Texel texture_at(const ThreadTexture& texture, const TexturePoint& point);

}  // namespace weftlight
