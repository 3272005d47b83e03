#include "cloth/thread_texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "design/fibre_facts.h"

namespace weftlight::cloth {

using cloth::thread_formulas::mix_bits, cloth::thread_formulas::unit_of;
using design::Twist, design::clamped, design::fibre_facts, design::fibre_radius_mm;

namespace {

constexpr float kTwoPi = 2.0f * std::numbers::pi_v<float>;
// The tone along a fibre changes after about this many of its widths.
constexpr float kToneLength = 14.0f;
// A plied yarn is twisted against its singles, so its fibres lie nearly along the axis.
constexpr float kFibreTwistInPly = -0.2f;
constexpr float kPlyRelief = 0.14f;    // of the thread's height
constexpr float kSpunBundling = 0.3f;  // of fibres that are not bound to each other
constexpr int kMaxTurns = 1 << 22;     // keeps phases exact in float

int rounded(float x) { return static_cast<int>(std::lround(std::clamp(x, -1.0f * kMaxTurns, 1.0f * kMaxTurns))); }

/// Lanes of single fibres. In a ply they keep their twist against it.
void set_single_fibres(ThreadTexture& t, const FibreFacts& facts, const Yarn& yarn) {
  const float lane_mm = std::min(2 * fibre_radius_mm(facts), yarn.fibre_um * 1e-3f);
  t.lanes = std::max(std::round(kTwoPi * t.radius_mm / lane_mm), t.fibres);
  const float net = static_cast<float>(t.advance) / t.fibres * t.lanes;
  const float ply = t.plies > 1 ? t.lanes * static_cast<float>(t.ply_advance) / static_cast<float>(t.plies) : 0.0f;
  t.lane_advance = rounded(net - ply);
  t.disorder = facts.disorder;
  t.bundling = facts.in_bundle > 1 ? 1.0f : kSpunBundling;
  t.convolution = std::min(facts.along_rad, 0.5f * yarn.lobes.along_width);
}

}  // namespace

ThreadTexture thread_texture(const Yarn& yarn, const ThreadBody& body, System system, int thread, float length_mm) {
  return thread_texture(yarn, fibre_facts(yarn), body, system, thread, length_mm);
}

ThreadTexture thread_texture(const Yarn& any, const FibreFacts& facts, const ThreadBody& body, System system,
                             int thread, float length_mm) {
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
  set_single_fibres(t, facts, yarn);
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

std::vector<FibreFacts> fibre_facts(const Cloth& cloth) {
  std::vector<FibreFacts> out;
  for (const Yarn& yarn : cloth.yarns) out.push_back(design::fibre_facts(yarn));
  return out;
}

std::array<std::vector<ThreadTexture>, 2> thread_textures(const Cloth& cloth) {
  const std::vector<FibreFacts> facts = fibre_facts(cloth);
  const auto of = [&](const std::vector<ThreadBody>& bodies, System system, float length_mm) {
    std::vector<ThreadTexture> out;
    for (size_t i = 0; i < bodies.size(); ++i) {
      const size_t yarn = static_cast<size_t>(bodies[i].yarn);
      out.push_back(thread_texture(cloth.yarns[yarn], facts[yarn], bodies[i], system, static_cast<int>(i), length_mm));
    }
    return out;
  };
  return {of(cloth.ends, System::kWarp, cloth.depth_mm), of(cloth.picks, System::kWeft, cloth.width_mm)};
}

}  // namespace weftlight::cloth
