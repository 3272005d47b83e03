// The upper surface of the threads, their sections swept at right angles along their centre lines. At a sample at most
// one end and one pick can be on top, since a thread is never wider than its room. A section leans with its thread:
// at slope m the vertical cut through it is sqrt(1 + m^2) as high, and a point on top of the cut belongs to a section
// further along (to first order in the section's height).

#include "cloth/surface_sampler.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <numbers>

#include "cloth/thickness.h"
#include "cloth/wrap.h"
#include "platform/vectors.h"

namespace weftlight::cloth {

using cloth::thread_formulas::fibre_colour, cloth::thread_formulas::section_gradient,
    cloth::thread_formulas::section_top, cloth::thread_formulas::shows_turn;

namespace {

constexpr float kTwoPi = 2.0f * std::numbers::pi_v<float>;
constexpr int kSamplesPerThread = 3;
const TexturePoint kTooFine{0, 0, 0, 0, 0, 1e6f, 0};  // any point in samples that show nothing of a pattern
constexpr float kMinCover = 1e-6f;                    // below it is rounding
constexpr double kMaxSamples = 1 << 24;               // of one map; beyond, threads are sampled more sparsely

const std::vector<ThreadBody>& threads_of(const Cloth& cloth, System s) {
  return s == System::kWarp ? cloth.ends : cloth.picks;
}

int per_texel(size_t threads, int texels, int samples_a_thread, double most) {
  const double wanted = std::ceil(samples_a_thread * static_cast<double>(threads) / texels);
  return static_cast<int>(std::clamp(wanted, 1.0, std::max(1.0, most)));
}

int thread_at(const std::vector<ThreadBody>& threads, float s_mm) {
  const auto it = std::partition_point(threads.begin(), threads.end(),
                                       [&](const ThreadBody& t) { return t.centre_mm + 0.5f * t.spacing_mm <= s_mm; });
  return static_cast<int>(std::min(it - threads.begin(), std::ssize(threads) - 1));
}

/// Height of a thread's section above its axis.
float section(float centre_mm, glm::vec2 half, float squareness, float across_mm) {
  return half.x > 0.0f ? half.y * section_top((across_mm - centre_mm) / half.x, squareness) : 0.0f;
}

/// Turn around a thread for a step across it, both in half widths: of the angle to a point (x, y) of the section.
float turn_across(float x, float y, float squareness) {
  const glm::vec2 out = section_gradient(x, y, squareness);
  return (x * out.x + y * out.y) / std::max((x * x + y * y) * out.y, 1e-2f);
}

float unit_or_less(float x) { return std::min(x, 1.0f); }

}  // namespace

SampleGrid sample_grid(const Cloth& cloth, int width, int height, int samples_a_thread) {
  SampleGrid grid{width, height, 1, 1};
  const double room = kMaxSamples / (static_cast<double>(width) * height);
  const int y = per_texel(cloth.picks.size(), height, samples_a_thread, room);
  grid.per_texel_x =
      per_texel(cloth.ends.size(), width, samples_a_thread, std::max(std::sqrt(room), std::floor(room / y)));
  grid.per_texel_y = per_texel(cloth.picks.size(), height, samples_a_thread, std::floor(room / grid.per_texel_x));
  return grid;
}

SampleAxis sample_axis(const Cloth& cloth, System system, const SampleGrid& grid) {
  const auto& threads = threads_of(cloth, system);
  const bool warp = system == System::kWarp;
  const int samples = warp ? grid.samples_x() : grid.samples_y();
  const float period = warp ? cloth.width_mm : cloth.depth_mm, step = period / static_cast<float>(samples);
  SampleAxis axis{warp ? grid.per_texel_x : grid.per_texel_y, {0}, {}};
  // As the sampler does it: threads by their borders, crossings by their centres.
  for (int i = 0; i < samples; ++i) {
    const float middle = 0.5f * (static_cast<float>(i) * step + static_cast<float>(i + 1) * step);
    while (axis.thread_from.size() < threads.size()) {
      const ThreadBody& t = threads[axis.thread_from.size() - 1];
      if (t.centre_mm + 0.5f * t.spacing_mm > middle) break;
      axis.thread_from.push_back(i);
    }
    const float s = position_in_period((static_cast<float>(i) + 0.5f) * step, period);
    while (axis.crossing_from.size() < threads.size() && threads[axis.crossing_from.size()].centre_mm <= s)
      axis.crossing_from.push_back(i);
  }
  axis.thread_from.resize(threads.size() + 1, samples);
  axis.crossing_from.resize(threads.size() + 1, samples);
  return axis;
}

float floor_mm(const Cloth& cloth) {
  const float end = 2 * tallest_half(cloth, System::kWarp), pick = 2 * tallest_half(cloth, System::kWeft);
  float lowest = 0;
  // The relief of a single layer changes with its cells, and the floor is that of all texels.
  if (cloth.layers.empty()) return -0.5f * (end + pick);
  for (const float level : cloth.warp_level_mm) lowest = std::min(lowest, level);
  return lowest - 0.5f * (end + pick);
}

SurfaceSampler::Textures SurfaceSampler::textures(const Cloth& cloth, System system, float from_mm, float to_mm,
                                                  float step, float step_along) {
  const auto& threads = threads_of(cloth, system);
  const float length = system == System::kWarp ? cloth.depth_mm : cloth.width_mm;
  const int own = system == System::kWarp ? cloth.first_end : cloth.first_pick;
  const int margin = cloth::uneven(cloth, system) ? 1 : 0;
  Textures out;
  out.first = thread_at(threads, from_mm) - margin;
  for (int i = out.first, last = thread_at(threads, to_mm) + margin; i <= last; ++i) {
    const int thread = wrap(i, static_cast<int>(threads.size()));
    const ThreadBody& body = threads[static_cast<size_t>(thread)];
    const ThreadTexture t =
        thread_texture(cloth.yarns[static_cast<size_t>(body.yarn)], {}, body, system, own + thread, length);
    const auto along = [&](int advance) { return std::abs(static_cast<float>(advance)) * step_along / length; };
    const float cycles_along = along(t.advance);
    // At the ridge, where the grooves appear widest.
    const float cycles = std::max(t.fibres * step / (kTwoPi * std::max(0.5f * body.width_mm, 1e-7f)), cycles_along);
    out.of.push_back(
        {t, texture_at(t, kTooFine), cycles_along, along(t.ply_advance), contrast_left(0.99f * cycles) > 0});
  }
  return out;
}

SurfaceSampler::SurfaceSampler(const Cloth& cloth, const SampleGrid& grid, int x0, int x1, int y0, int y1)
    : cloth_(cloth),
      grid_(grid),
      x0_(x0),
      x1_(x1),
      y0_(y0),
      y1_(y1),
      dx_mm_(cloth.width_mm / static_cast<float>(grid.samples_x())),
      dy_mm_(cloth.depth_mm / static_cast<float>(grid.samples_y())),
      floor_mm_(floor_mm(cloth)),
      warp_texture_(textures(cloth, System::kWarp, static_cast<float>(x0) * dx_mm_, static_cast<float>(x1) * dx_mm_,
                             dx_mm_, dy_mm_)),
      weft_texture_(textures(cloth, System::kWeft, static_cast<float>(y0) * dy_mm_, static_cast<float>(y1) * dy_mm_,
                             dy_mm_, dx_mm_)),
      uneven_{cloth::uneven(cloth, System::kWarp), cloth::uneven(cloth, System::kWeft)},
      column_slots_(slots(System::kWarp, x0, x1)),
      row_slots_(slots(System::kWeft, y0, y1)) {
  if (!uneven_[0]) columns_ = across(System::kWarp);
  if (!uneven_[1]) rows_ = across(System::kWeft);
  column_steps_.reserve(column_slots_.size());
  for (int x = x0; x < x1; ++x)
    column_steps_.push_back(centre_step(cloth, System::kWeft, (static_cast<float>(x) + 0.5f) * dx_mm_));
  // More crossings on each side than the curves of the threads there and beside them read.
  const int end0 = column_slots_.front().middle, end1 = column_slots_.back().middle;
  lines_ = centre_lines(cloth, {end0 - 3, end1 + 5, row_slots_.front().middle - 3, row_slots_.back().middle + 5});
  if (uneven_[0]) warp_sizes_ = crossing_sizes(System::kWarp);
  if (uneven_[1]) weft_sizes_ = crossing_sizes(System::kWeft);
  const int margin = uneven_[0] ? 1 : 0;
  first_end_ = end0 - margin;
  warp_along_.resize(static_cast<size_t>(end1 + margin - first_end_ + 1));
  int most = 1;  // picks within a row
  for (const Slot& row : row_slots_) most = std::max(most, row.highest - row.lowest + 1);
  warp_sections_.resize(warp_sizes_.place.size());
  pick_along_.rows.resize(4);
  pick_sections_.rows.resize(std::bit_ceil(static_cast<size_t>(most + 2)));
}

float SurfaceSampler::centre_of(System system, int thread) const {
  const auto& threads = threads_of(cloth_, system);
  const int count = static_cast<int>(threads.size()), t = wrap(thread, count);
  const float period = system == System::kWarp ? cloth_.width_mm : cloth_.depth_mm;
  return threads[static_cast<size_t>(t)].centre_mm + (thread < 0 ? -period : thread >= count ? period : 0.0f);
}

std::vector<SurfaceSampler::Slot> SurfaceSampler::slots(System system, int first, int last) const {
  const auto& threads = threads_of(cloth_, system);
  const float step = system == System::kWarp ? dx_mm_ : dy_mm_;
  const int count = static_cast<int>(threads.size());
  const auto side_of = [&](int t, float way) {
    return threads[static_cast<size_t>(t)].centre_mm + way * 0.5f * threads[static_cast<size_t>(t)].spacing_mm;
  };
  std::vector<Slot> out;
  out.reserve(static_cast<size_t>(last - first));
  int lowest = thread_at(threads, static_cast<float>(first) * step);
  for (int i = first; i < last; ++i) {
    Slot s{static_cast<float>(i) * step, static_cast<float>(i + 1) * step, 0, 0, 0};
    while (lowest + 1 < count && side_of(lowest, 1) <= s.from) ++lowest;
    s.lowest = s.highest = s.middle = lowest;
    while (s.highest + 1 < count && side_of(s.highest + 1, -1) < s.to) ++s.highest;
    while (s.middle + 1 < count && side_of(s.middle, 1) <= 0.5f * (s.from + s.to)) ++s.middle;
    out.push_back(s);
  }
  return out;
}

std::vector<SurfaceSampler::Across> SurfaceSampler::across(System system) const {
  const auto& threads = threads_of(cloth_, system);
  std::vector<Across> out;
  for (const Slot& slot : system == System::kWarp ? column_slots_ : row_slots_) {
    const auto sections = [&](int t) -> Section {
      const ThreadBody& body = threads[static_cast<size_t>(wrap(t, static_cast<int>(threads.size())))];
      return {{0.5f * body.width_mm, 0.5f * body.height_mm},
              centre_of(system, t),
              0,
              glm::vec2(0.5f * body.spacing_mm),
              body.squareness};
    };
    set_across(out.emplace_back(), system, slot, sections);
    add_pattern(out.back(), system, slot, sections);
  }
  return out;
}

/// The thread within whose borders the middle of a sample lies.
template <class Sections>
int SurfaceSampler::thread_under(System system, const Slot& slot, const Sections& sections) const {
  if (!uneven_[system == System::kWarp ? 0 : 1]) return slot.middle;
  const Section& own = sections(slot.middle);
  const float beyond = 0.5f * (slot.from + slot.to) - own.place - own.aside;
  return beyond >= own.room.y ? slot.middle + 1 : beyond < -own.room.x ? slot.middle - 1 : slot.middle;
}

template <class Sections>
void SurfaceSampler::set_across(Across& a, System system, const Slot& slot, const Sections& sections) const {
  const auto& [from, to, lowest, highest, nominal] = slot;
  a.thread = a.first = a.last = thread_under(system, slot, sections);
  const Section& own = sections(a.thread);
  const float centre = own.centre();
  if (from < centre - own.room.x || to > centre + own.room.y) {
    const int margin = uneven_[system == System::kWarp ? 0 : 1] ? 1 : 0;
    a.first = lowest - margin, a.last = highest + margin;
  }
  float covered = 0;
  for (int t = a.first; t <= a.last; ++t) covered += covered_part(slot, sections(t)).width();
  a.cover = unit_or_less(covered / (to - from));
  const float half = std::max(own.half.x, 1e-7f);
  a.beyond_mm = std::max(0.0f, std::abs(0.5f * (from + to) - centre) - half);
  const float u0 = std::clamp((from - centre) / half, -1.0f, 1.0f);
  const float u1 = std::clamp((to - centre) / half, -1.0f, 1.0f);
  a.u = 0.5f * (u0 + u1);
  a.top = section_top(a.u, own.squareness);
  a.height_mm = own.half.y * a.top;
}

/// The mean slope of the threads within a sample, and where it lies on the pattern of its thread.
template <class Sections>
void SurfaceSampler::add_pattern(Across& a, System system, const Slot& slot, const Sections& sections) const {
  const bool warp = system == System::kWarp;
  const float step = warp ? dx_mm_ : dy_mm_;
  float covered = 0, rise = 0;
  for (int t = a.first; t <= a.last; ++t) {
    const Section& s = sections(t);
    const Part part = covered_part(slot, s);
    if (part.width() <= 0) continue;
    covered += part.width();
    rise += section(s.centre(), s.half, s.squareness, part.to) - section(s.centre(), s.half, s.squareness, part.from);
  }
  a.slope = covered > 1e-6f * (slot.to - slot.from) ? -rise / covered : 0.0f;
  const Textures::Thread& thread = (warp ? warp_texture_ : weft_texture_).at(a.thread);
  const ThreadTexture& texture = thread.texture;
  const Section& own = sections(a.thread);
  const float turn_per_sample = step / (kTwoPi * std::max(own.half.x, 1e-7f)) * turn_across(a.u, a.top, own.squareness);
  a.cycles = std::max(texture.fibres * turn_per_sample, thread.cycles_along);
  a.ply_fade = contrast_left(std::max(static_cast<float>(texture.plies) * turn_per_sample, thread.ply_cycles_along));
  a.turns = shows_turn(texture, a.cycles);
  if (!a.turns) return;
  const float around = std::atan2(a.u, a.top) / kTwoPi;
  a.turn = texture.fibres * around;
  a.ply_turn = static_cast<float>(texture.plies) * around;
}

SurfaceSampler::CrossingSizes SurfaceSampler::crossing_sizes(System system) const {
  const bool warp = system == System::kWarp;
  const auto& threads = threads_of(cloth_, system);
  const std::vector<Slot>& own = warp ? column_slots_ : row_slots_;
  const float end_mm = warp ? static_cast<float>(x1_) * dx_mm_ : static_cast<float>(y1_) * dy_mm_;
  const auto crossing = [&](int sample, float step) {
    return centre_step(cloth_, system, (static_cast<float>(sample) + 0.5f) * step).crossing;
  };
  CrossingSizes out;
  out.first_thread = own.front().lowest - 1;
  const bool moved = !cloth_.warp_aside_mm.empty();
  const int margin = moved ? 1 : 0;  // a step may begin one crossing earlier or later
  out.first = (warp ? crossing(y0_, dy_mm_) : crossing(x0_, dx_mm_)) - margin;
  out.crossings = (warp ? crossing(y1_ - 1, dy_mm_) : crossing(x1_ - 1, dx_mm_)) + 2 + margin - out.first;
  const int count = static_cast<int>(threads.size());
  int last = own.back().lowest;
  while (last + 1 < count &&
         threads[static_cast<size_t>(last + 1)].centre_mm - 0.5f * threads[static_cast<size_t>(last + 1)].spacing_mm <
             end_mm)
    ++last;
  for (int t = out.first_thread; t <= last + 1; ++t) {
    const ThreadBody& body = threads[static_cast<size_t>(wrap(t, count))];
    out.place.push_back(centre_of(system, t));
    out.squareness.push_back(body.squareness);
    out.room_by_width.push_back(room_mm(body) / std::max(body.width_mm, 1e-6f));
    for (int c = 0; c < out.crossings; ++c) {
      const glm::vec3 s = section_at(cloth_, system, t, out.first + c);
      out.over_size.push_back({1 / s.x, 1 / s.y, s.z});
      if (!moved) continue;
      const auto aside = [&](int of) { return aside_at(cloth_, system, of, out.first + c); };
      out.more_room.push_back(0.5f * glm::vec2(aside(t) - aside(t - 1), aside(t + 1) - aside(t)));
    }
  }
  return out;
}

SurfaceSampler::Along SurfaceSampler::along(System system, int thread, const CentreStep& step, float s_mm) const {
  const bool warp = system == System::kWarp;
  const Textures::Thread& own = (warp ? warp_texture_ : weft_texture_).at(thread);
  const ThreadTexture& texture = own.texture;
  const float period_fraction = s_mm / (warp ? cloth_.depth_mm : cloth_.width_mm);
  const CentrePoint centre = centre_at(lines_, system, thread, step);
  Along a;
  a.at_mm = s_mm;
  a.centre_mm = centre.height_mm;
  a.slope = centre.slope;
  a.lengthened = std::sqrt(1.0f + centre.slope * centre.slope);
  a.bend = centre.bend * centre.slope / a.lengthened;
  if (uneven_[warp ? 0 : 1]) a.sideways = (warp ? warp_sizes_ : weft_sizes_).sideways(thread, step);
  a.ply_turn = static_cast<float>(texture.ply_advance) * period_fraction;
  a.stray_turn = static_cast<float>(texture.stray_advance) * period_fraction;
  const float node = std::floor(period_fraction * static_cast<float>(texture.nodes));
  a.node = std::clamp(static_cast<int>(node), 0, texture.nodes - 1);
  a.blend = std::clamp(period_fraction * static_cast<float>(texture.nodes) - node, 0.0f, 1.0f);
  a.turn = static_cast<float>(texture.advance) * period_fraction;
  if (own.patterned) a.turn += thread_formulas::wander(texture, a.node, a.blend);
  return a;
}

CentreStep SurfaceSampler::pick_step(int pick, size_t column) const {
  const float s_mm = (static_cast<float>(x0_ + static_cast<int>(column)) + 0.5f) * dx_mm_;
  return moved_step(cloth_, System::kWeft, pick, s_mm, column_steps_[column]);
}

const std::vector<SurfaceSampler::Along>& SurfaceSampler::along_pick(int pick) {
  auto& [kept, by_column] = pick_along_.at(pick);
  if (kept == pick) return by_column;
  kept = pick;
  by_column.resize(column_slots_.size());
  for (size_t i = 0; i < by_column.size(); ++i)
    by_column[i] =
        along(System::kWeft, pick, pick_step(pick, i), (static_cast<float>(x0_ + static_cast<int>(i)) + 0.5f) * dx_mm_);
  return by_column;
}

const std::vector<SurfaceSampler::Section>& SurfaceSampler::sections_of_pick(int pick) {
  auto& [kept, by_column] = pick_sections_.at(pick);
  if (kept == pick) return by_column;
  kept = pick;
  by_column.resize(column_slots_.size());
  for (size_t i = 0; i < by_column.size(); ++i) by_column[i] = weft_sizes_.at(pick, pick_step(pick, i));
  return by_column;
}

SurfaceSample SurfaceSampler::finish(System system, const Across& a, const Along& l, float cover) const {
  const bool warp = system == System::kWarp;
  const std::vector<ThreadBody>& threads = warp ? cloth_.ends : cloth_.picks;
  const int thread = wrap(a.thread, static_cast<int>(threads.size()));
  const Textures::Thread& of = (warp ? warp_texture_ : weft_texture_).at(a.thread);
  const ThreadTexture& texture = of.texture;
  const Texel texel = !a.turns ? of.mean
                               : texture_at(texture, {a.turn + l.turn, a.ply_turn + l.ply_turn,
                                                      a.turn / thread_formulas::kStraySpacing + l.stray_turn, l.node,
                                                      l.blend, a.cycles, a.ply_fade});
  float across = a.slope * l.lengthened, along = -(l.slope + l.bend * a.height_mm) - l.sideways * across;
  SurfaceSample s;
  s.cover = cover;
  s.height_mm = l.centre_mm + a.height_mm * l.lengthened;
  if (texture.plies > 1) {
    // z -= relief ply^2. The factor 1 / cos of the tube's side is left out.
    const float slant = 4.0f * texture.ply_relief_mm * texel.ply;
    const float length = warp ? cloth_.depth_mm : cloth_.width_mm;
    s.height_mm -= texture.ply_relief_mm * texel.ply * texel.ply;
    across += slant * static_cast<float>(texture.plies) / (kTwoPi * texture.radius_mm);
    along += slant * static_cast<float>(texture.ply_advance) / length;
  }
  s.groove = texel.groove;
  const Linear& dye = colour_along(cloth_, system, thread, l.at_mm);
  const glm::vec3 colour = fibre_colour(texel, {dye.r, dye.g, dye.b});
  s.colour = {colour.r, colour.g, colour.b};
  s.thread = static_cast<uint32_t>(thread + (warp ? cloth_.first_end : cloth_.first_pick));
  s.system = warp ? 0 : 1;
  s.slope = warp ? Slope{across, along} : Slope{along, across};
  // Fibre direction: the axis turned by the helix angle in the tangent plane, and as the thread runs sideways.
  const float turn =
      texture.fibre_tan / std::sqrt(1.0f + across * across) + l.sideways / std::sqrt(1.0f + along * along);
  const float axis = 1.0f / std::sqrt(1.0f + along * along);
  const float ta = turn, tl = axis, tz = -(across * turn + along * axis);
  const float scale = 1.0f / std::sqrt(ta * ta + tl * tl + tz * tz);
  s.tangent = warp ? Direction{ta * scale, tl * scale, tz * scale} : Direction{tl * scale, ta * scale, tz * scale};
  return s;
}

void SurfaceSampler::row(int y, std::span<SurfaceSample> out, std::vector<Beside>& beside) {
  beside.clear();
  platform::with_widest_vectors([&] { sample_row(y, out, beside); });
}

void SurfaceSampler::sample_row(int y, std::span<SurfaceSample> out, std::vector<Beside>& beside) {
  const size_t at_row = static_cast<size_t>(y - y0_);
  const Slot& row_slot = row_slots_[at_row];
  const float s_mm = (static_cast<float>(y) + 0.5f) * dy_mm_;
  const CentreStep even = centre_step(cloth_, System::kWarp, s_mm);
  const auto end_step = [&](int end) { return moved_step(cloth_, System::kWarp, end, s_mm, even); };
  for (size_t e = 0; e < warp_along_.size(); ++e)
    warp_along_[e] =
        along(System::kWarp, first_end_ + static_cast<int>(e), end_step(first_end_ + static_cast<int>(e)), s_mm);
  // Uneven threads have another section at each position along them.
  for (size_t t = 0; t < warp_sections_.size(); ++t) {
    const int end = warp_sizes_.first_thread + static_cast<int>(t);
    warp_sections_[t] = warp_sizes_.at(end, end_step(end));
  }
  const auto end_section = [&](int end) -> const Section& {
    return warp_sections_[static_cast<size_t>(end - warp_sizes_.first_thread)];
  };
  Across uneven_column, uneven_row;
  for (size_t i = 0; i < out.size(); ++i) {
    const auto pick_section = [&](int pick) -> const Section& { return sections_of_pick(pick)[i]; };
    if (uneven_[0]) set_across(uneven_column, System::kWarp, column_slots_[i], end_section);
    if (uneven_[1]) set_across(uneven_row, System::kWeft, row_slot, pick_section);
    Across& column = uneven_[0] ? uneven_column : columns_[i];
    Across& across_row = uneven_[1] ? uneven_row : rows_[at_row];
    const Along& end = warp_along_[static_cast<size_t>(column.thread - first_end_)];
    const Along& pick = along_pick(across_row.thread)[i];
    const auto shown = [&](bool of_warp, float cover) {
      if (of_warp && uneven_[0]) add_pattern(column, System::kWarp, column_slots_[i], end_section);
      if (!of_warp && uneven_[1]) add_pattern(across_row, System::kWeft, row_slot, pick_section);
      return of_warp ? finish(System::kWarp, column, end, cover) : finish(System::kWeft, across_row, pick, cover);
    };
    // Coverage of each system: where both are present, one is on top.
    const float both = column.cover * across_row.cover;
    const bool over =
        end.centre_mm + column.height_mm * end.lengthened >= pick.centre_mm + across_row.height_mm * pick.lengthened;
    const float warp = column.cover - (over ? 0.0f : both), weft = across_row.cover - (over ? both : 0.0f);
    const bool open = warp + weft <= 0.0f;
    const bool warp_first = open ? column.beyond_mm <= across_row.beyond_mm : warp >= weft;
    out[i] = shown(warp_first, open ? 0.0f : std::max(warp, weft));
    if (open) out[i].height_mm = floor_mm_, out[i].slope = {};
    else if (std::min(warp, weft) > kMinCover)
      beside.push_back({static_cast<int>(i), shown(!warp_first, std::min(warp, weft))});
  }
}

LayeredSampler::LayeredSampler(const Cloth& cloth, std::span<const Cloth> layers, const SampleGrid& grid, int x0,
                               int x1, int y0, int y1) {
  if (layers.empty()) layers_.push_back({SurfaceSampler(cloth, grid, x0, x1, y0, y1), {}, {}});
  for (const Cloth& layer : layers) {
    layers_.push_back({SurfaceSampler(layer, grid, x0, x1, y0, y1), {}, {}});
    layers_.back().out.resize(static_cast<size_t>(x1 - x0));
  }
}

void LayeredSampler::row(int y, std::span<SurfaceSample> out, std::vector<Beside>& beside) {
  if (layers_.size() == 1) return layers_.front().sampler.row(y, out, beside);
  for (Shown& layer : layers_) layer.sampler.row(y, layer.out, layer.beside), layer.next = 0;
  beside.clear();
  for (size_t i = 0; i < out.size(); ++i) {
    const std::vector<SurfaceSample>& stack = stacked(i);
    const auto most = std::ranges::max_element(stack, {}, &SurfaceSample::cover);
    out[i] = *most;
    for (const SurfaceSample& s : stack)
      if (&s != &*most && s.cover > kMinCover) beside.push_back({static_cast<int>(i), s});
  }
}

const std::vector<SurfaceSample>& LayeredSampler::stacked(size_t i) {
  order_.clear();
  for (Shown& layer : layers_) order_.push_back(&layer);
  std::ranges::stable_sort(order_, std::greater{}, [&](const Shown* layer) { return layer->out[i].height_mm; });
  stack_.clear();
  float open = 1;
  for (Shown* layer : order_) {
    float covered = 0;
    const auto add = [&](SurfaceSample s) {
      covered += s.cover;
      s.cover *= open;
      stack_.push_back(s);
    };
    add(layer->out[i]);
    if (layer->next < layer->beside.size() && layer->beside[layer->next].sample == static_cast<int>(i))
      add(layer->beside[layer->next++].shows);
    open *= std::max(0.0f, 1 - covered);
  }
  return stack_;
}

}  // namespace weftlight::cloth
