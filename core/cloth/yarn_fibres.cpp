#include "cloth/yarn_fibres.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cloth/thread_texture.h"
#include "design/fibre.h"

namespace weftlight::cloth {

using design::Twist, design::fibre_facts, design::fibre_radius_mm, design::hair_per_mm, design::tex_of;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kGoldenAngle = 2.39996323f;
constexpr float kAngleAStep = 0.5f;  // radians of twist between two points of a fibre
constexpr float kLongestStep_mm = 0.2f;
// Turns of the singles over those of the ply, the other way, as balanced yarns have them.
constexpr float kSinglesOverPly = 1.3f;
// A bundle of flax takes this part of its room; the furrows between bundles the rest.
constexpr float kBundleFill = 0.75f;
constexpr float kWanderWave_mm = 2.5f;
constexpr float kLoopsAHair = 0.7f;  // loops counted for each hair (Zhao et al. 2016)
constexpr float kLongHairs = 0.1f;   // part of the hairs, of kLongHair times the length
constexpr float kLongHair = 3;
constexpr float kLongestHair_mm = 6;
constexpr float kLoop_mm = 0.55f;
constexpr float kNapHair = 14;                                   // mm a mm that a raised finish pulls out
constexpr float kDepthOfFibres = 0.05f, kDepthOfMelange = 0.7f;  // spread of the logarithm
constexpr int kMaxInAThread = 1 << 22;                           // beyond, the memory limit has refused long since

/// Random numbers of one thread, one stream a purpose.
class Dice {
 public:
  Dice(uint32_t seed, uint32_t purpose) : seed_(thread_formulas::mix_bits(seed, purpose)) {}
  /// 0..1.
  float next() { return thread_formulas::unit_of(bits()); }
  uint32_t bits() { return thread_formulas::mix_bits(seed_, ++count_); }
  float between(float low, float high) { return low + (high - low) * next(); }
  float normal() {
    const float u = std::max(next(), 1e-7f);
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * kPi * next());
  }
  float exponential(float mean) { return -mean * std::log(std::max(1 - next(), 1e-6f)); }

 private:
  uint32_t seed_, count_ = 0;
};

FibreDye dye_of(const Yarn& yarn, Dice& dice) {
  FibreDye dye;
  dye.depth = std::exp((kDepthOfFibres + kDepthOfMelange * yarn.melange) * dice.normal());
  if (yarn.melange > 0)
    dye.hue = thread_formulas::kTuftHue * yarn.melange * thread_formulas::tuft_values(dice.bits(), 0, 0).y;
  return dye;
}

float turns_per_mm(const Yarn& yarn, System system) {
  // As in thread_texture.cpp: Z runs to +across along an end, on the visible side.
  if (yarn.twist == Twist::kNone) return 0;
  const float sign = (yarn.twist == Twist::kZ) == (system == System::kWarp) ? -1.0f : 1.0f;
  return sign * yarn.turns_per_m * 1e-3f;
}

/// Of a thread that repeats: a whole number of waves in its length, at least one if there are any.
float fitted_waves(float per_mm, const FibreThread& thread) {
  if (!(thread.length_mm > 0) || per_mm == 0) return 0;
  if (!thread.repeats) return per_mm;
  const float waves = std::round(per_mm * thread.length_mm);
  return (waves != 0 ? waves : std::copysign(1.0f, per_mm)) / thread.length_mm;
}

/// Half sections of the plies: circles that touch, wider across where there is room for it.
void place_plies(YarnFibres& yarn) {
  if (yarn.plies == 1) return;
  const float s = std::sin(kPi / static_cast<float>(yarn.plies)), r = s / (1 + s);
  yarn.ply_offset = 1 - r;
  yarn.ply_half = {r, r * (yarn.plies == 2 ? 1.5f : yarn.plies == 3 ? 1.2f : 1.1f)};
}

YarnFibres twisted(const FibreThread& thread, const FibreFacts& facts) {
  YarnFibres yarn;
  yarn.plies = std::clamp(thread.yarn.plies, 1, 64);
  place_plies(yarn);
  const float turns = fitted_waves(turns_per_mm(thread.yarn, thread.system), thread);
  yarn.ply_turns_per_mm = yarn.plies > 1 ? turns : 0;
  yarn.fibre_turns_per_mm = yarn.plies > 1 ? -fitted_waves(kSinglesOverPly * turns, thread) : turns;
  yarn.migration = facts.migration;
  const float turned = std::max(std::abs(yarn.fibre_turns_per_mm), 0.1f);
  yarn.migrations_per_mm = fitted_waves(facts.migrations * turned, thread);
  yarn.wander_per_mm = fitted_waves(1 / kWanderWave_mm, thread);
  return yarn;
}

/// Length of a fibre over that of the thread, mean over the section.
double longer_way(const YarnFibres& yarn, float radius_mm) {
  constexpr int kFibres = 24, kSteps = 64;
  const float turns = std::max({std::abs(yarn.ply_turns_per_mm), std::abs(yarn.fibre_turns_per_mm), 1e-3f});
  const float step = 1 / turns / kSteps;
  double sum = 0;
  for (int i = 0; i < kFibres; ++i) {
    PlyFibre fibre;
    fibre.place = {std::sqrt((static_cast<float>(i) + 0.5f) / kFibres), kGoldenAngle * static_cast<float>(i)};
    glm::vec2 before = fibre_place(yarn, fibre, 0);
    for (int k = 1; k <= kSteps; ++k) {
      const glm::vec2 here = fibre_place(yarn, fibre, step * static_cast<float>(k));
      const float aside = glm::length(here - before) * radius_mm;
      sum += std::sqrt(1 + static_cast<double>(aside * aside / (step * step)));
      before = here;
    }
  }
  return sum / (kFibres * kSteps);
}

int fibres_in_ply(const FibreThread& thread, const FibreFacts& facts, const YarnFibres& yarn) {
  const double tex = static_cast<double>(tex_of(thread.yarn, thread.diameter_mm)) / yarn.plies;
  const double longer = longer_way(yarn, 0.5f * thread.diameter_mm);
  const double wanted = 10 * tex / (static_cast<double>(facts.fineness_dtex) * longer);
  return static_cast<int>(std::clamp(std::round(wanted), 1.0, double{kMaxInAThread}));
}

/// Even places in the unit disc, polar: the i-th of n, moved by `jitter` mean distances.
glm::vec2 place_in_disc(float fraction, int i, int n, float jitter, Dice& dice) {
  const float r = std::sqrt(fraction), a = kGoldenAngle * static_cast<float>(i);
  const float off = jitter * 1.8f / std::sqrt(static_cast<float>(n));
  const glm::vec2 p(r * std::cos(a) + off * dice.between(-0.5f, 0.5f),
                    r * std::sin(a) + off * dice.between(-0.5f, 0.5f));
  return {std::min(glm::length(p), 1.0f), std::atan2(p.y, p.x)};
}

/// Places of n fibres that stay together in bundles of unequal size.
std::vector<glm::vec2> bundled_places(int n, int in_bundle, Dice& dice) {
  const int bundles = std::max(1, static_cast<int>(std::lround(static_cast<float>(n) / static_cast<float>(in_bundle))));
  std::vector<float> sizes(static_cast<size_t>(bundles));
  float all = 0;
  for (float& size : sizes) all += size = dice.between(0.35f, 1.65f);
  std::vector<glm::vec2> places;
  float before = 0;
  for (int b = 0; b < bundles; ++b) {
    const float part = sizes[static_cast<size_t>(b)] / all;
    const glm::vec2 middle = place_in_disc(before + 0.5f * part, b, bundles, 0.3f, dice);
    const glm::vec2 at(middle.x * std::cos(middle.y), middle.x * std::sin(middle.y));
    const int last = b + 1 == bundles ? n : static_cast<int>(std::lround((before + part) * static_cast<float>(n)));
    const int own = std::max(last - static_cast<int>(places.size()), 0);
    const float reach = std::sqrt(kBundleFill * part), flat = dice.between(0.75f, 1.3f), turn = 2 * kPi * dice.next();
    for (int i = 0; i < own; ++i) {
      const float r = reach * std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(own));
      const float a = kGoldenAngle * static_cast<float>(i);
      const glm::vec2 q(r * std::cos(a) * flat, r * std::sin(a) / flat);
      const glm::vec2 p =
          at + glm::vec2(q.x * std::cos(turn) - q.y * std::sin(turn), q.x * std::sin(turn) + q.y * std::cos(turn));
      places.push_back({std::min(glm::length(p), 1.0f), std::atan2(p.y, p.x)});
    }
    before += part;
  }
  return places;
}

void fill_ply(YarnFibres& yarn, int ply, int n, const FibreThread& thread, const FibreFacts& facts) {
  Dice dice(thread.seed, 0x100u + static_cast<uint32_t>(ply));
  std::vector<glm::vec2> places;
  if (facts.in_bundle > 1) {
    places = bundled_places(n, facts.in_bundle, dice);
  } else {
    for (int i = 0; i < n; ++i)
      places.push_back(place_in_disc((static_cast<float>(i) + 0.5f) / static_cast<float>(n), i, n,
                                     0.3f + 0.7f * facts.disorder, dice));
  }
  const float radius = fibre_radius_mm(facts);
  // The ply's area is kept whatever the spread of its fibres.
  const float usual = radius / std::sqrt(1 + facts.spread * facts.spread);
  for (const glm::vec2& place : places) {
    PlyFibre fibre;
    fibre.ply = ply;
    fibre.place = place;
    fibre.radius_mm = usual * std::clamp(1 + facts.spread * dice.normal(), 0.4f, 1.8f);
    fibre.migration = 2 * kPi * dice.next();
    fibre.wander = {2 * kPi * dice.next(), 2 * kPi * dice.next()};
    fibre.dye = dye_of(thread.yarn, dice);
    yarn.fibres.push_back(fibre);
  }
}

float hair_of(const FibreThread& thread) { return hair_per_mm(thread.yarn) + kNapHair * thread.raised; }

/// Length of a mean hair, with the few long ones and without what is cut.
float mean_hair_mm(const FibreThread& thread, const FibreFacts& facts) {
  const float mean = facts.hair_mm * (1 + 0.5f * thread.raised);
  const auto cut = [](float m) { return m * (1 - std::exp(-kLongestHair_mm / m)); };
  return (1 - kLongHairs) * cut(mean) + kLongHairs * cut(kLongHair * mean);
}

int hair_count(const FibreThread& thread, const FibreFacts& facts) {
  const float wanted = hair_of(thread) * thread.length_mm / std::max(mean_hair_mm(thread, facts), 0.05f);
  return static_cast<int>(std::clamp(std::round(wanted), 0.0f, float{kMaxInAThread}));
}

void add_hairs(YarnFibres& yarn, const FibreThread& thread, const FibreFacts& facts) {
  Dice dice(thread.seed, 0x7000u);
  const float radius = fibre_radius_mm(facts), mean = facts.hair_mm * (1 + 0.5f * thread.raised);
  const float twist = 2 * kPi * 0.5f * thread.diameter_mm * (yarn.ply_turns_per_mm + 0.3f * yarn.fibre_turns_per_mm);
  for (int i = hair_count(thread, facts); i > 0; --i) {
    StrayFibre hair;
    hair.start_mm = dice.next() * thread.length_mm;
    hair.turn_rad = 2 * kPi * dice.next();
    hair.length_mm =
        std::min(dice.exponential(dice.next() < kLongHairs ? kLongHair * mean : mean), kLongestHair_mm) + 0.05f;
    // It leaves along the twist, at a small angle, either way; wool and nap rise more.
    const float rise = dice.between(0.12f, 0.6f + 0.4f * facts.hair_curl * 0.3f + 0.5f * thread.raised);
    const float way = dice.next() < 0.5f ? -1.0f : 1.0f;
    const glm::vec2 out(std::cos(hair.turn_rad), std::sin(hair.turn_rad)), around(-out.y, out.x);
    const glm::vec2 aside = out * rise + around * (twist * way + 0.25f * dice.normal());
    hair.lean = glm::normalize(glm::vec3(aside, way));
    hair.bend = facts.hair_curl * glm::vec3(dice.normal(), dice.normal(), dice.normal());
    hair.radius_mm = radius * dice.between(0.75f, 1.05f);
    yarn.strays.push_back(hair);
  }
}

int loop_count(const FibreThread& thread, const FibreFacts& facts) {
  return static_cast<int>(std::lround(kLoopsAHair * static_cast<float>(hair_count(thread, facts))));
}

void add_loops(YarnFibres& yarn, const FibreThread& thread, const FibreFacts& facts) {
  Dice dice(thread.seed, 0x9000u);
  for (int i = loop_count(thread, facts); i > 0; --i) {
    StrayFibre loop;
    loop.loop = true;
    loop.start_mm = dice.next() * thread.length_mm;
    loop.turn_rad = 2 * kPi * dice.next();
    loop.length_mm = kLoop_mm * dice.between(0.5f, 1.5f);
    loop.reach_mm = 0.5f * thread.diameter_mm * std::max(0.05f, 0.14f + 0.1f * dice.normal());
    loop.radius_mm = fibre_radius_mm(facts);
    yarn.strays.push_back(loop);
  }
}

}  // namespace

float fibre_step_mm(const Yarn& yarn) {
  const float turns = std::abs(turns_per_mm(yarn, System::kWarp)) * (yarn.plies > 1 ? 1 + kSinglesOverPly : 1);
  return std::min(kLongestStep_mm, turns > 0 ? kAngleAStep / (2 * kPi * turns) : kLongestStep_mm);
}

int fibre_count(const FibreThread& thread) {
  const FibreFacts facts = fibre_facts(thread.yarn);
  const YarnFibres yarn = twisted(thread, facts);
  return static_cast<int>(
      std::min<int64_t>(int64_t{yarn.plies} * fibres_in_ply(thread, facts, yarn), int64_t{kMaxInAThread}));
}

int stray_count(const FibreThread& thread) {
  const FibreFacts facts = fibre_facts(thread.yarn);
  return hair_count(thread, facts) + loop_count(thread, facts);
}

float stray_length_mm(const FibreThread& thread) {
  const FibreFacts facts = fibre_facts(thread.yarn);
  const auto hairs = static_cast<float>(hair_count(thread, facts)),
             loops = static_cast<float>(loop_count(thread, facts));
  return (hairs * mean_hair_mm(thread, facts) + loops * kLoop_mm) / std::max(hairs + loops, 1.0f);
}

YarnFibres yarn_fibres(const FibreThread& thread) {
  const FibreFacts facts = fibre_facts(thread.yarn);
  YarnFibres yarn = twisted(thread, facts);
  const int n = fibres_in_ply(thread, facts, yarn);
  yarn.wander = facts.disorder * 0.9f / std::sqrt(static_cast<float>(n));
  for (int ply = 0; ply < yarn.plies; ++ply) fill_ply(yarn, ply, n, thread, facts);
  add_hairs(yarn, thread, facts);
  add_loops(yarn, thread, facts);
  Dice dyes(thread.seed, 0xD1u);
  for (StrayFibre& stray : yarn.strays) stray.dye = dye_of(thread.yarn, dyes);
  // Every thread begins at a place of its own in its twist.
  Dice dice(thread.seed, 0x42u);
  yarn.phase = 2 * kPi * dice.next();
  return yarn;
}

glm::vec3 FibreDye::tinted(glm::vec3 thread_colour) const {
  thread_formulas::Texel texel{};
  texel.tone = 1, texel.hue = hue;
  return thread_formulas::fibre_colour(texel, thread_colour);
}

glm::vec3 FibreDye::on_surface(glm::vec3 thread_colour) const {
  return glm::pow(tinted(thread_colour), glm::vec3(depth));
}

glm::vec2 fibre_place(const YarnFibres& yarn, const PlyFibre& fibre, float along_mm) {
  const float wave = 2 * kPi * along_mm;
  const float inwards = 0.5f * yarn.migration * (1 + std::cos(wave * yarn.migrations_per_mm + fibre.migration));
  const float angle = fibre.place.y + wave * yarn.fibre_turns_per_mm, r = fibre.place.x * (1 - inwards);
  glm::vec2 p(r * std::cos(angle), r * std::sin(angle));
  if (yarn.wander > 0) {
    const float slow = wave * yarn.wander_per_mm;
    p += yarn.wander * glm::vec2(std::sin(slow + fibre.wander.x) + 0.5f * std::sin(3 * slow + 2 * fibre.wander.y),
                                 std::cos(slow + fibre.wander.y) + 0.5f * std::cos(3 * slow + 2 * fibre.wander.x));
    // It stays in its ply.
    const float far = glm::length(p);
    if (far > 1) p /= far;
  }
  if (yarn.plies == 1) return p;
  const float turn = yarn.phase + 2 * kPi * (static_cast<float>(fibre.ply) / static_cast<float>(yarn.plies)) +
                     wave * yarn.ply_turns_per_mm;
  const glm::vec2 q(yarn.ply_offset + p.x * yarn.ply_half.x, p.y * yarn.ply_half.y);
  return {q.x * std::cos(turn) - q.y * std::sin(turn), q.x * std::sin(turn) + q.y * std::cos(turn)};
}

}  // namespace weftlight::cloth
