#include "reference/thread_curves.h"

#include <cmath>
#include <numbers>

namespace weftlight::reference {

using cloth::fibre_place, cloth::yarn_fibres;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

}  // namespace

int pieces_of(const StrayFibre& stray) { return stray.loop ? kLoopPieces : kHairPieces; }

ThreadFibres thread_fibres(const FibrePlan& plan, const PlannedThread& thread) {
  ThreadFibres made{&thread, yarn_fibres(thread.made_for), {}};
  if (!thread.core) made.yarn.fibres.clear();
  const float length = plan.length(thread.system), reach = plan.repeats_along(thread.system) ? kHairReach_mm : 0;
  const int copies = static_cast<int>(std::ceil(reach / length));
  for (const StrayFibre& stray : made.yarn.strays)
    for (int c = -copies; c <= copies; ++c) {
      const float shift = static_cast<float>(c) * length, at = stray.start_mm + shift;
      if (c == 0 || (at > -reach && at < length + reach)) made.strays.push_back({stray, shift});
    }
  return made;
}

ThreadCurves::ThreadCurves(const ThreadPaths& paths, const FibrePlan& plan, const ThreadFibres& made)
    : paths_(paths), plan_(plan), made_(made) {
  const int points = made.plan->points;
  step_mm_ = (plan.length(made.plan->system) + 2 * plan.pad_mm) / static_cast<float>(points - 1);
  if (!made.plan->core) return;
  frames_.reserve(static_cast<size_t>(points));
  for (int k = 0; k < points; ++k) frames_.push_back(frame_at(along(k)));
}

SectionFrame ThreadCurves::frame_at(float along_mm) const {
  const PlannedThread& t = *made_.plan;
  return {t.system, t.centre_mm, paths_.ring_at(t.system, t.thread, plan_.start(t.system) + along_mm)};
}

void ThreadCurves::thread(glm::vec4* out) const {
  for (const SectionFrame& f : frames_) *out++ = glm::vec4(f.centre, f.mean_radius());
}

void ThreadCurves::ply(int ply, glm::vec4* out) const {
  PlyFibre axis;
  axis.ply = ply;
  YarnFibres still = made_.yarn;  // fibres wander in their ply, it does not
  still.wander = still.migration = 0;
  still.fibres.clear(), still.strays.clear();
  const float share = still.plies == 1 ? 1 : std::sqrt(still.ply_half.x * still.ply_half.y);
  for (size_t k = 0; k < frames_.size(); ++k) {
    const glm::vec2 place = fibre_place(still, axis, along(static_cast<int>(k)));
    out[k] = glm::vec4(frames_[k].at(place, 0), share * frames_[k].mean_radius());
  }
}

void ThreadCurves::fibre(const PlyFibre& fibre, glm::vec4* out) const {
  for (size_t k = 0; k < frames_.size(); ++k) {
    const glm::vec2 place = fibre_place(made_.yarn, fibre, along(static_cast<int>(k)));
    out[k] = glm::vec4(frames_[k].at(place, fibre.radius_mm), fibre.radius_mm);
  }
}

void ThreadCurves::stray(const PlacedStray& placed, glm::vec4* out) const {
  const float start = placed.fibre.start_mm + placed.shift_mm;
  if (placed.fibre.loop) loop(placed.fibre, start, out);
  else hair(placed.fibre, frame_at(start), out);
}

/// Bulges out of the thread between two points of it.
void ThreadCurves::loop(const StrayFibre& loop, float start_mm, glm::vec4* out) const {
  for (int k = 0; k <= kLoopPieces; ++k) {
    const float t = static_cast<float>(k) / kLoopPieces, along = loop.length_mm * t;
    const SectionFrame f = frame_at(start_mm + along);
    const float turn = loop.turn_rad + 2 * kPi * along * made_.yarn.ply_turns_per_mm;
    const glm::vec2 way(std::cos(turn), std::sin(turn));
    const float out_mm = loop.reach_mm * std::sin(kPi * t);
    out[k] = glm::vec4(f.at(way, loop.radius_mm) + (f.across * way.x + f.up * way.y) * out_mm, loop.radius_mm);
  }
}

/// Grows straight from the surface and bends.
void ThreadCurves::hair(const StrayFibre& hair, const SectionFrame& from, glm::vec4* out) const {
  glm::vec3 p = from.at(0.9f * glm::vec2(std::cos(hair.turn_rad), std::sin(hair.turn_rad)), hair.radius_mm);
  const auto world = [&from](glm::vec3 v) { return from.across * v.x + from.up * v.y + from.axis * v.z; };
  glm::vec3 direction = world(hair.lean);
  const glm::vec3 bend = world(hair.bend);
  const float step = hair.length_mm / kHairPieces;
  for (int k = 0; k <= kHairPieces; ++k) {
    // It tapers to its end.
    out[k] = glm::vec4(p, hair.radius_mm * (1 - 0.4f * static_cast<float>(k) / kHairPieces));
    direction = glm::normalize(direction + glm::cross(bend, direction) * step);
    p += direction * step;
  }
}

}  // namespace weftlight::reference
