#include "cloth/thread_texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weftlight::cloth {

using cloth::thread_formulas::mix_bits, cloth::thread_formulas::unit_of;
using design::Twist, design::clamped;

namespace {

constexpr float kTwoPi = 2.0f * std::numbers::pi_v<float>;
// The tone along a fibre changes after about this many of its widths.
constexpr float kToneLength = 14.0f;
// A plied yarn is twisted against its singles, so its fibres lie nearly along the axis.
constexpr float kFibreTwistInPly = -0.2f;
constexpr float kPlyRelief = 0.14f;  // of the thread's height
constexpr int kMaxTurns = 1 << 22;   // keeps phases exact in float

int rounded(float x) { return static_cast<int>(std::lround(std::clamp(x, -1.0f * kMaxTurns, 1.0f * kMaxTurns))); }

}  // namespace

ThreadTexture thread_texture(const Yarn& any, const ThreadBody& body, System system, int thread, float length_mm) {
  using thread_formulas::mix_bits, thread_formulas::unit_of;
  const Yarn yarn = clamped(any);
  ThreadTexture t{};
  t.radius_mm = std::max(0.25f * (body.width_mm + body.height_mm), 1e-5f);
  const float fibre_mm = yarn.fibre_um * 1e-3f;
  t.fibres = std::max(3.0f, std::round(kTwoPi * t.radius_mm / fibre_mm));
  // Z twist runs like the stroke of the letter: up and to the right along an end (+x across), which is against +y
  // along a pick.
  const float twist_sign = yarn.twist == Twist::kNone                               ? 0.0f
                           : (yarn.twist == Twist::kZ) == (system == System::kWarp) ? -1.0f
                                                                                    : 1.0f;
  const float turns = twist_sign * yarn.turns_per_m * 1e-3f * length_mm;
  t.plies = yarn.plies;
  if (t.plies > 1) {
    t.ply_advance = rounded(turns * static_cast<float>(t.plies));
    t.ply_relief_mm = kPlyRelief * body.height_mm;
  }
  t.advance = rounded(turns * t.fibres * (t.plies > 1 ? kFibreTwistInPly : 1.0f));
  t.fibre_tan = -kTwoPi * t.radius_mm * static_cast<float>(t.advance) / (t.fibres * std::max(length_mm, 1e-6f));
  t.singles = std::abs(t.advance) * thread_formulas::kFibresABundle;
  t.stray_advance = -rounded(0.35f * static_cast<float>(t.advance) / thread_formulas::kStraySpacing);
  t.nodes = std::max(1, rounded(length_mm / (kToneLength * fibre_mm)));
  t.depth = yarn.groove_depth;
  t.hairiness = yarn.hairiness;
  t.melange = yarn.melange;
  t.seed = mix_bits(static_cast<uint32_t>(thread), system == System::kWarp ? 0x51u : 0xA7u);
  t.phase = unit_of(mix_bits(t.seed, 1)) * 64.0f;
  t.ply_phase = unit_of(mix_bits(t.seed, 2));
  return t;
}

std::array<std::vector<ThreadTexture>, 2> thread_textures(const Cloth& cloth) {
  const auto of = [&cloth](const std::vector<ThreadBody>& bodies, System system, float length_mm) {
    std::vector<ThreadTexture> out;
    for (size_t i = 0; i < bodies.size(); ++i) {
      out.push_back(thread_texture(cloth.yarns[static_cast<size_t>(bodies[i].yarn)], bodies[i], system,
                                   static_cast<int>(i), length_mm));
    }
    return out;
  };
  return {of(cloth.ends, System::kWarp, cloth.depth_mm), of(cloth.picks, System::kWeft, cloth.width_mm)};
}

}  // namespace weftlight::cloth
