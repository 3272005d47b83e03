// Signed distances. Based on: Quilez, "Distance functions" (iquilezles.org), for the rounded
// cylinder, the round cone and the smooth minimum. Measures of the form: a woman's size 38-40.

#include "drape/bodies.h"

#include <algorithm>
#include <iterator>

#include "drape/vec.h"

namespace weftlight::drape {

namespace {

float smooth_min(float a, float b, float width) {
  const float h = std::max(width - std::fabs(a - b), 0.0f) / width;
  return std::min(a, b) - h * h * width * 0.25f;
}

float smooth_max(float a, float b, float width) { return -smooth_min(-a, -b, width); }

/// A limb that tapers from radius ra at a to rb at b.
float limb(Vec3 p, Vec3 a, Vec3 b, float ra, float rb) {
  const Vec3 axis = b - a, from = p - a;
  const float t = std::clamp(dot(from, axis) / dot(axis, axis), 0.0f, 1.0f);
  return length(from - axis * t) - mix(ra, rb, t);
}

struct Measure {
  float height, half_width, half_depth, middle;
};

constexpr Measure kTrunk[] = {
    {740, 152, 112, -8}, {800, 170, 121, -9}, {880, 178, 122, -8}, {960, 162, 108, -3}, {1060, 126, 92, 0},
    {1140, 138, 102, 3}, {1230, 155, 119, 8}, {1310, 163, 106, 1}, {1360, 163, 86, -6}, {1395, 132, 70, -12},
    {1420, 84, 60, -14}, {1445, 60, 56, -10}, {1530, 53, 53, 4},
};

/// Catmull-Rom cubic between the middle two of four values.
float curve(float before, float from, float to, float after, float t) {
  const float slope_from = 0.5f * (to - before), slope_to = 0.5f * (after - from);
  const float t2 = t * t, t3 = t2 * t;
  return from * (2 * t3 - 3 * t2 + 1) + to * (3 * t2 - 2 * t3) + slope_from * (t3 - 2 * t2 + t) + slope_to * (t3 - t2);
}

float trunk(Vec3 p) {
  const TrunkSection s = trunk_section(p[1]);
  const float x = p[0], z = p[2] - s.middle;
  const float out = std::sqrt(x * x + z * z);
  const float scaled = std::sqrt(x * x / (s.half_width * s.half_width) + z * z / (s.half_depth * s.half_depth));
  return scaled < 0.05f ? -std::min(s.half_width, s.half_depth) : out * (1 - 1 / scaled);
}

}  // namespace

TrunkSection trunk_section(float height) {
  const auto last = std::prev(std::end(kTrunk));
  const auto above = std::find_if(std::begin(kTrunk), last, [&](const Measure& m) { return m.height > height; });
  const Measure& to = above == std::begin(kTrunk) ? *std::next(above) : *above;
  const Measure& from = *std::prev(&to);
  const Measure& before = &from == std::begin(kTrunk) ? from : *std::prev(&from);
  const Measure& after = &to == last ? to : *std::next(&to);
  const float t = std::clamp((height - from.height) / (to.height - from.height), 0.0f, 1.0f);
  const auto along = [&](float Measure::*part) { return curve(before.*part, from.*part, to.*part, after.*part, t); };
  return {along(&Measure::half_width), along(&Measure::half_depth), along(&Measure::middle)};
}

Arm arm() { return {{176, 1352, -10}, {345, 1142, -4}, {482, 948, 44}, 47, 37, 26}; }

Arm lowered_arm(float fraction) {
  const Vec3 raised{0.87f, -0.5f, 0.02f}, upper{0.30f, -0.95f, -0.04f}, lower{0.17f, -0.90f, 0.40f};
  const auto turned = [&](Vec3 to) { return unit(raised * (1 - fraction) + to * fraction); };
  const Arm out = arm();
  Arm a = out;
  a.elbow = a.shoulder + turned(upper) * length(out.elbow - out.shoulder);
  a.wrist = a.elbow + turned(lower) * length(out.wrist - out.elbow);
  return a;
}

float ground(Vec3 p) { return p[1]; }

float ball(Vec3 p) { return length(p - Vec3{0, kBallRadius, 0}) - kBallRadius; }

float table(Vec3 p) {
  constexpr float kEdge = 13, kHalfThickness = 14;
  const float out = std::sqrt(p[0] * p[0] + p[2] * p[2]) - (kTableRadius - kEdge);
  const float up = std::fabs(p[1] - (kTableHeight - kHalfThickness)) - (kHalfThickness - kEdge);
  const float outside = std::hypot(std::max(out, 0.0f), std::max(up, 0.0f));
  return outside + std::min(std::max(out, up), 0.0f) - kEdge;
}

std::array<RoundedBox, 2> board_boxes() {
  constexpr float kHalfThick = 16;
  const Vec3 middle = Vec3{0, kBoardHeight, 0} - lean_back({0, kHalfThick, 0}, kBoardLean);
  return {{{middle, {265, kHalfThick, 265}, 12, kBoardLean}, {{0, 70, -60}, {150, 70, 80}, 14, 0}}};
}

Vec3 lean_back(Vec3 p, float lean) {
  return {p[0], p[1] * std::cos(lean) + p[2] * std::sin(lean), p[2] * std::cos(lean) - p[1] * std::sin(lean)};
}

float board(Vec3 p) {
  float nearest = ground(p);
  for (const RoundedBox& box : board_boxes()) {
    const Vec3 out = glm::abs(lean_back(p - box.centre, -box.lean_rad)) - (box.half - box.edge);
    const float inside = std::min(std::max(out[0], std::max(out[1], out[2])), 0.0f);
    nearest = std::min(nearest, length(glm::max(out, Vec3(0))) + inside - box.edge);
  }
  return nearest;
}

float dress_form(Vec3 p) { return form_with(arm(), p); }

float form_with(const Arm& a, Vec3 p) {
  const Vec3 right{std::fabs(p[0]), p[1], p[2]};
  const float upper = limb(right, a.shoulder, a.elbow, a.shoulder_radius, a.elbow_radius);
  const float lower = limb(right, a.elbow, a.wrist, a.elbow_radius, a.wrist_radius);
  const float body = smooth_min(trunk(p), smooth_min(upper, lower, 12), 34);
  return smooth_max(smooth_max(body, p[1] - 1520, 14), 752 - p[1], 20);
}

float skirt_form(Vec3 p) { return smooth_max(smooth_max(trunk(p), p[1] - (kWaistHeight + 70), 14), 752 - p[1], 20); }

float taped_skirt_form(Vec3 p) {
  constexpr float kTape = 2.6f, kHalfWidth = 10, kFades = 18;  // mm
  const float beyond = std::clamp((std::fabs(p[1] - kWaistHeight) - kHalfWidth) / kFades, 0.0f, 1.0f);
  return skirt_form(p) - kTape * (1 - beyond * beyond * (3 - 2 * beyond));
}

float ring_x(int ring) { return (static_cast<float>(ring) / (kRings - 1) - 0.5f) * 660; }

}  // namespace weftlight::drape
