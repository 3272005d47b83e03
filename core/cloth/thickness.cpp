#include "cloth/thickness.h"

#include <algorithm>
#include <cmath>

#include "cloth/wrap.h"

namespace weftlight::cloth {

using thread_formulas::border_sway, thread_formulas::kBorderSteps, thread_formulas::kMaxAside,
    thread_formulas::kMaxSway, thread_formulas::kTallestSection, thread_formulas::section_between,
    thread_formulas::slubs_in;

namespace {

constexpr float kMinRoom = 1e-6f;

const std::vector<ThreadBody>& threads_of(const Cloth& cloth, System s) {
  return s == System::kWarp ? cloth.ends : cloth.picks;
}
float length_of(const Cloth& cloth, System s) { return s == System::kWarp ? cloth.depth_mm : cloth.width_mm; }

/// Of the sway in a thread of this length: smaller where it is too short for a thick and a thin place.
float swaying(float length_mm) {
  const float whole = std::min(length_mm / thread_formulas::kSlub_mm, 1.0f);
  return whole * whole;
}

/// Half of what a thread wants in addition to its spacing.
float push_mm(const ThreadBody& t, float thickness) { return 0.5f * t.spacing_mm * (thickness - 1); }

ThreadBorder border_between(const ThreadBody& a, float a_thickness, const ThreadBody& b, float b_thickness) {
  const float most = 0.5f * kMaxAside * std::min(a.spacing_mm, b.spacing_mm);
  ThreadBorder border;
  // Sways take part of what is left, so that the widest ones still end within the bound.
  border.aside_mm = std::clamp(push_mm(a, a_thickness) - push_mm(b, b_thickness), -0.5f * most, 0.5f * most);
  // Both borders of a thread sway independently: its room has the standard deviation of its thickness.
  const float sway = 0.5f * std::hypot(a.unevenness * a.spacing_mm, b.unevenness * b.spacing_mm);
  border.sway_mm = std::min(sway, (most - std::abs(border.aside_mm)) / kMaxSway);
  // In steps that the threads' records hold, so that bodies and tubes agree.
  const float step = 0.5f * std::min(a.spacing_mm, b.spacing_mm) / kBorderSteps;
  border.aside_mm = std::round(border.aside_mm / step) * step;
  border.sway_mm = std::floor(2 * border.sway_mm / step) * (0.5f * step);
  return border;
}

}  // namespace

float unevenness_of(const Yarn& yarn, const Finish& finish) {
  if (std::isnan(yarn.unevenness)) return 0;
  // Mass goes with the square of the thickness, so the CV of thickness is half the CV of mass.
  return std::clamp(0.005f * yarn.unevenness, 0.0f, 0.5f) *
         (1 - kNapFlattening * std::clamp(finish.raised, 0.0f, 1.0f));
}

void give_way(std::span<ThreadBody> row, std::span<const float> thickness) {
  const size_t n = row.size();
  for (size_t i = 0; i < n; ++i) {
    const size_t next = i + 1 < n ? i + 1 : 0;
    if (next == i) break;
    row[i].after = border_between(row[i], thickness[i], row[next], thickness[next]);
    row[next].before = row[i].after;
  }
  for (size_t i = 0; i < n; ++i) {
    ThreadBody& t = row[i];
    if (t.width_mm <= 0 || t.spacing_mm <= 0) continue;
    const float wider = room_mm(t) / t.spacing_mm;
    t.width_mm *= wider;
    // Rounder than a thread may get where it is thick and its neighbours do not give way enough.
    t.height_mm = std::min(t.height_mm * thickness[i] * thickness[i] / wider,
                           std::max(kTallestSection * t.width_mm, t.height_mm));
  }
}

ThreadSection thread_section(const ThreadBody& body, float length_mm) {
  const float part = swaying(length_mm);
  return {body.centre_mm,
          0.5f * body.spacing_mm,
          0.5f * body.width_mm,
          0.5f * body.height_mm,
          {body.before.aside_mm, body.after.aside_mm},
          {part * body.before.sway_mm, part * body.after.sway_mm},
          body.squareness};
}

glm::vec3 section_at(const Cloth& cloth, System system, int thread, int crossing) {
  const auto& threads = threads_of(cloth, system);
  const int n = static_cast<int>(threads.size()), own = wrap(thread, n);
  const float length = length_of(cloth, system);
  const ThreadSection body = thread_section(threads[static_cast<size_t>(own)], length);
  const glm::vec3 moved(0, 0, aside_at(cloth, system, thread, crossing));
  if (!is_uneven(body)) return section_between(body, 0, 0) + moved;
  const int count = static_cast<int>(threads_of(cloth, system == System::kWarp ? System::kWeft : System::kWarp).size());
  const int first = system == System::kWarp ? cloth.first_end : cloth.first_pick;
  const auto sway = [&](int of) {
    return border_sway(system == System::kWarp ? 0 : 1, first + of, wrap(crossing, count), count, slubs_in(length));
  };
  return section_between(body, sway(own > 0 ? own - 1 : n - 1), sway(own)) + moved;
}

glm::vec3 section_at(const Cloth& cloth, System system, int thread, const CentreStep& step) {
  const glm::vec3 here = section_at(cloth, system, thread, step.crossing);
  const auto& threads = threads_of(cloth, system);
  if (cloth.warp_aside_mm.empty() &&
      !uneven(threads[static_cast<size_t>(wrap(thread, static_cast<int>(threads.size())))]))
    return here;
  return section_between_crossings(here, section_at(cloth, system, thread, step.crossing + 1), step.t);
}

float tallest_half(const Cloth& cloth, System system) {
  const float part = swaying(length_of(cloth, system));
  float most = 0;
  for (const ThreadBody& t : threads_of(cloth, system)) {
    const float room = std::max(room_mm(t), kMinRoom);
    most = std::max(most, 0.5f * t.height_mm * (1 + kMaxSway * part * (t.before.sway_mm + t.after.sway_mm) / room));
  }
  return most;
}

float furthest_side(const ThreadBody& t) {
  return std::max(thread_formulas::furthest_side(thread_section(t, thread_formulas::kSlub_mm)), 0.5f * t.width_mm);
}

bool uneven(const ThreadBody& t) { return t.before != ThreadBorder{} || t.after != ThreadBorder{}; }

bool uneven(const Cloth& cloth, System system) {
  return !cloth.warp_aside_mm.empty() ||
         std::ranges::any_of(threads_of(cloth, system), [](const ThreadBody& t) { return uneven(t); });
}

}  // namespace weftlight::cloth
