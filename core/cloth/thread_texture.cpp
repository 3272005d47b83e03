// Based on: N. Adabala, N. Magnenat-Thalmann, G. Fei, Real-time Rendering of Woven Clothes, 2003,
// section 3.2 and figure 3 (twist tightness, thickness of the fibres, noise of stray fibres).
// Differs: the twist is a helix on a round thread with its pitch in millimetres, its phase is rounded
// so that the tile closes, and a pattern finer than the samples fades to its mean.

#include "cloth/thread_texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weftlight {
namespace {

constexpr float kTwoPi = 2.0f * std::numbers::pi_v<float>;
// Tone keeps along a fibre for about this many of its widths before it changes.
constexpr float kToneLength = 14.0f;
// A plied yarn is twisted against its singles, which lays its fibres nearly along the axis.
constexpr float kFibreTwistInPly = -0.2f;
constexpr float kPlyRelief = 0.14f;  // of the thread's height
constexpr int kMostTurns = 1 << 22;  // keeps phases exact enough in float

constexpr float kThreadTone = 0.05f;  // a thread is this much lighter or darker than its neighbours
constexpr float kFibreTone = 0.55f, kStrayTone = 0.35f;  // contrasts at hairiness 1
constexpr float kStrayShare = 0.35f;  // of the places for a stray fibre, at hairiness 1
constexpr int kFibresABundle = 4;
constexpr float kWander = 1.3f;       // grooves, at hairiness 1

uint32_t mix(uint32_t a, uint32_t b) {
  uint32_t h = a * 0x9E3779B1u ^ (b + 0x7F4A7C15u) * 0x85EBCA77u;
  h ^= h >> 15;
  h *= 0x2C1B3C6Du;
  h ^= h >> 12;
  h *= 0x297A2D39u;
  return h ^ (h >> 15);
}

float unit(uint32_t h) { return static_cast<float>(h >> 8) * 0x1p-24f; }

int rounded(float x) {
  return static_cast<int>(std::lround(std::clamp(x, -1.0f * kMostTurns, 1.0f * kMostTurns)));
}

}  // namespace

ThreadTexture thread_texture(const Yarn& yarn, const ThreadBody& body, System system, int thread, float length_mm) {
  ThreadTexture t;
  t.radius_mm = std::max(0.25f * (body.width_mm + body.height_mm), 1e-5f);
  const float fibre_mm = std::clamp(yarn.fibre_um, 1.0f, 2000.0f) * 1e-3f;
  t.fibres = std::max(3.0f, std::round(kTwoPi * t.radius_mm / fibre_mm));
  // Z runs like the stroke of the letter: up and to the right along an end (+x across), which is
  // against +y along a pick.
  const float hand = yarn.twist == Twist::kNone ? 0.0f : (yarn.twist == Twist::kZ) == (system == System::kWarp) ? -1.0f : 1.0f;
  const float turns = hand * std::clamp(yarn.turns_per_m, 0.0f, 5000.0f) * 1e-3f * length_mm;
  t.plies = std::clamp(yarn.plies, 1, 8);
  if (t.plies > 1) {
    t.ply_advance = rounded(turns * static_cast<float>(t.plies));
    t.ply_relief_mm = kPlyRelief * body.height_mm;
  }
  t.advance = rounded(turns * t.fibres * (t.plies > 1 ? kFibreTwistInPly : 1.0f));
  t.fibre_tan = -kTwoPi * t.radius_mm * static_cast<float>(t.advance) / (t.fibres * std::max(length_mm, 1e-6f));
  t.singles = std::abs(t.advance) * kFibresABundle;
  t.stray_advance = -rounded(0.35f * static_cast<float>(t.advance) / kStraySpacing);
  t.nodes = std::max(1, rounded(length_mm / (kToneLength * fibre_mm)));
  t.depth = std::clamp(yarn.groove_depth, 0.0f, 1.0f);
  t.hair = std::clamp(yarn.hairiness, 0.0f, 1.0f);
  t.seed = mix(static_cast<uint32_t>(thread), system == System::kWarp ? 0x51u : 0xA7u);
  t.phase = unit(mix(t.seed, 1)) * 64.0f;
  t.ply_phase = unit(mix(t.seed, 2));
  return t;
}

float wander(const ThreadTexture& x, int node, float blend) {
  const auto at = [&](int n) { return unit(mix(x.seed ^ 0x5bd1e995u, static_cast<uint32_t>(n))) - 0.5f; };
  const float b = blend * blend * (3.0f - 2.0f * blend), here = at(node);
  return kWander * x.hair * (here + b * (at(node + 1 == x.nodes ? 0 : node + 1) - here));
}

Texel texture_at(const ThreadTexture& x, const TexturePoint& p) {
  Texel out;
  const float own = 1.0f + kThreadTone * x.hair * (2.0f * unit(mix(x.seed, 3)) - 1.0f);
  out.tone = own;
  out.groove = 1.0f - 0.2f * x.depth;
  if (const float fade = contrast_left(p.cycles); fade > 0.0f) {
    const float turn = p.turn + x.phase, fibre = std::floor(turn);
    // One value a fibre and node, blended along; over the tile's border fibre k goes on as k - advance.
    const int k = static_cast<int>(fibre);
    const bool wraps = p.node + 1 == x.nodes;
    const auto value = [&](uint32_t seed, int fibre_index, int node) {
      return unit(mix(seed + static_cast<uint32_t>(fibre_index) * 0x632BE5ABu, static_cast<uint32_t>(node)));
    };
    const float b = p.blend * p.blend * (3.0f - 2.0f * p.blend);
    const float here = value(x.seed, k, p.node);
    const float next = value(x.seed, wraps ? k - x.advance : k, wraps ? 0 : p.node + 1);
    const float tone = here + b * (next - here) - 0.5f;
    // Groove: 1 between fibres, 0 on their ridge; the fourth power has the mean 1/5.
    const float across = 2.0f * (turn - fibre) - 1.0f;
    const float groove = across * across * across * across;
    out.groove -= x.depth * fade * (groove * (1.0f + 1.6f * x.hair * tone) - 0.2f);
    // A stray fibre: thin, light, over one node's length, thinning out to both ends.
    const float stray_turn = p.stray_turn + x.phase, stray_fibre = std::floor(stray_turn);
    const float share = kStrayShare * x.hair;
    const float aside = 5.0f * (2.0f * (stray_turn - stray_fibre) - 1.0f);
    const bool there = std::abs(aside) < 1.0f &&
                       value(x.seed ^ 0xA341316Cu, static_cast<int>(stray_fibre), p.node) < share;
    const float stray = there ? (1.0f - aside * aside) * 4.0f * p.blend * (1.0f - p.blend) : 0.0f;
    constexpr float kMeanOfStray = 2.0f / 15.0f * 2.0f / 3.0f;
    out.tone += fade * (kFibreTone * x.hair * tone + kStrayTone * (stray - share * kMeanOfStray));
    // The single fibres of a bundle, each of its own tone.
    if (const float fine = contrast_left(static_cast<float>(kFibresABundle) * p.cycles); fine > 0.0f) {
      const float single = turn * static_cast<float>(kFibresABundle), index = std::floor(single);
      // The same fibre again after a period, so that the tile closes.
      const int fibre_index = x.singles > 0 ? static_cast<int>(index) % x.singles : static_cast<int>(index);
      const float rounded_off = 2.0f * (single - index) - 1.0f;  // darker to its sides; square's mean 1/3
      const float own_tone = value(x.seed ^ 0xC2B2AE35u, fibre_index < 0 ? fibre_index + x.singles : fibre_index, 0) - 0.5f;
      out.tone += fine * (0.06f + 0.3f * x.hair) * (0.7f * own_tone + 1.0f / 3.0f - rounded_off * rounded_off);
    }
  }
  if (x.plies > 1) {
    const float ply_turn = p.ply_turn + x.ply_phase;
    out.ply = 2.0f * (ply_turn - std::floor(ply_turn)) - 1.0f;
    const float furrow = out.ply * out.ply * out.ply * out.ply * out.ply * out.ply;  // mean 1/7
    out.groove *= 1.0f - x.depth * (1.0f / 7.0f + p.ply_fade * (furrow - 1.0f / 7.0f));
    out.ply *= p.ply_fade;
  }
  out.groove = std::clamp(out.groove, 0.0f, 1.0f);
  return out;
}

}  // namespace weftlight
