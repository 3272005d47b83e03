#include "cloth/thickness.h"

#include <algorithm>
#include <cmath>

#include "cloth/thread_texture.h"

namespace weftlight::cloth {

using cloth::thread_formulas::slubs_in, cloth::thread_formulas::thickness_factor,
    cloth::thread_formulas::uneven_section;

namespace {

using thread_formulas::slubs_in, thread_formulas::thickness_factor, thread_formulas::uneven_section;

constexpr float kThinnest_mm = 1e-6f;

const std::vector<ThreadBody>& threads_of(const Cloth& cloth, System s) {
  return s == System::kWarp ? cloth.ends : cloth.picks;
}
float length_of(const Cloth& cloth, System s) { return s == System::kWarp ? cloth.depth_mm : cloth.width_mm; }

int wrap(int i, int n) {
  const int r = i % n;
  return r < 0 ? r + n : r;
}

glm::vec2 even_section(const ThreadBody& body) {
  return glm::max(glm::vec2(0.5f * body.width_mm, 0.5f * body.height_mm), glm::vec2(kThinnest_mm));
}

}  // namespace

float unevenness_of(const Yarn& yarn, const Finish& finish) {
  if (std::isnan(yarn.unevenness)) return 0;
  // Mass goes with the square of the thickness, so the CV of thickness is half the CV of mass.
  return std::clamp(0.005f * yarn.unevenness, 0.0f, 0.5f) *
         (1 - kNapFlattening * std::clamp(finish.raised, 0.0f, 1.0f));
}

float spread_in(const ThreadBody& body, float length_mm) {
  const float whole = std::min(length_mm / thread_formulas::kSlub_mm, 1.0f);
  return body.unevenness * whole * whole;
}

glm::vec2 half_section(const Cloth& cloth, System system, int thread, int crossing) {
  const auto& threads = threads_of(cloth, system);
  const int own = wrap(thread, static_cast<int>(threads.size()));
  const ThreadBody& body = threads[static_cast<size_t>(own)];
  if (body.unevenness <= 0) return even_section(body);
  const int count = static_cast<int>(threads_of(cloth, system == System::kWarp ? System::kWeft : System::kWarp).size());
  const int first = system == System::kWarp ? cloth.first_end : cloth.first_pick;
  const float length = length_of(cloth, system);
  const float f = thickness_factor(spread_in(body, length), system == System::kWarp ? 0 : 1, first + own,
                                   wrap(crossing, count), count, slubs_in(length));
  return uneven_section(even_section(body), 0.5f * body.spacing_mm, f);
}

glm::vec2 half_section(const Cloth& cloth, System system, int thread, const CentreStep& step) {
  const auto& threads = threads_of(cloth, system);
  const ThreadBody& body = threads[static_cast<size_t>(wrap(thread, static_cast<int>(threads.size())))];
  if (body.unevenness <= 0) return even_section(body);
  // Interpolates 1 / size, as the shaders do.
  const glm::vec2 here = 1.0f / half_section(cloth, system, thread, step.crossing),
                  next = 1.0f / half_section(cloth, system, thread, step.crossing + 1);
  return 1.0f / (here + (next - here) * step.t);
}

float tallest_half(const Cloth& cloth, System system) {
  float most = 0;
  for (const ThreadBody& t : threads_of(cloth, system)) {
    const glm::vec2 even = even_section(t);
    most = std::max(most, even.y);
    if (t.unevenness <= 0) continue;
    // Top of the strongest possible thick place; about one in a few hundred comes near it.
    const float f = 1 + 2 * spread_in(t, length_of(cloth, system)) * thread_formulas::kSlubGain;
    most = std::max(most, uneven_section(even, 0.5f * t.spacing_mm, f).y);
  }
  return most;
}

bool uneven(const Cloth& cloth, System system) {
  return std::ranges::any_of(threads_of(cloth, system), [](const ThreadBody& t) { return t.unevenness > 0; });
}

}  // namespace weftlight::cloth
