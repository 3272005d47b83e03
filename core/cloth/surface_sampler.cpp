// The upper surface of the threads, their sections swept at right angles along their centre lines. At a sample at most
// one end and one pick can be on top, since a thread is never wider than its room. A section leans with its thread:
// at slope m the vertical cut through it is sqrt(1 + m^2) as high, and a point on top of the cut belongs to a section
// further along (to first order in the section's height).

#include "cloth/surface_sampler.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "cloth/thickness.h"
#include "cloth/wrap.h"

namespace weftlight::cloth {

using cloth::thread_formulas::fibre_colour, cloth::thread_formulas::section_gradient,
    cloth::thread_formulas::section_top;

namespace {

constexpr float kTwoPi = 2.0f * std::numbers::pi_v<float>;
constexpr int kSamplesPerThread = 3;
constexpr float kMinCover = 1e-6f;       // below it is rounding
constexpr double kMaxSamples = 1 << 24;  // of one map; beyond, threads are sampled more sparsely

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
    out.of.push_back(
        thread_texture(cloth.yarns[static_cast<size_t>(body.yarn)], {}, body, system, own + thread, length));
    const ThreadTexture& t = out.of.back();
    // At the ridge, where the grooves appear widest.
    const float cycles = std::max(t.fibres * step / (kTwoPi * std::max(0.5f * body.width_mm, 1e-7f)),
                                  std::abs(static_cast<float>(t.advance)) * step_along / length);
    out.patterned.push_back(contrast_left(0.99f * cycles) > 0.0f);
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
      columns_(across(System::kWarp, x0, x1)),
      rows_(across(System::kWeft, y0, y1)) {
  column_steps_.reserve(columns_.size());
  for (int x = x0; x < x1; ++x)
    column_steps_.push_back(centre_step(cloth, System::kWeft, (static_cast<float>(x) + 0.5f) * dx_mm_));
  // More crossings on each side than the curves of the threads there and beside them read.
  lines_ = centre_lines(cloth, {columns_.front().thread - 3, columns_.back().thread + 5, rows_.front().thread - 3,
                                rows_.back().thread + 5});
  if (uneven_[0]) warp_sizes_ = crossing_sizes(System::kWarp);
  if (uneven_[1]) weft_sizes_ = crossing_sizes(System::kWeft);
  const int margin = uneven_[0] ? 1 : 0;
  first_end_ = columns_.front().thread - margin;
  warp_along_.resize(static_cast<size_t>(columns_.back().thread + margin - first_end_ + 1));
}

float SurfaceSampler::centre_of(System system, int thread) const {
  const auto& threads = threads_of(cloth_, system);
  const int count = static_cast<int>(threads.size()), t = wrap(thread, count);
  const float period = system == System::kWarp ? cloth_.width_mm : cloth_.depth_mm;
  return threads[static_cast<size_t>(t)].centre_mm + (thread < 0 ? -period : thread >= count ? period : 0.0f);
}

std::vector<SurfaceSampler::Across> SurfaceSampler::across(System system, int first, int last) const {
  const auto& threads = threads_of(cloth_, system);
  const float step = system == System::kWarp ? dx_mm_ : dy_mm_;
  std::vector<Across> out(static_cast<size_t>(last - first));
  int lowest = thread_at(threads, static_cast<float>(first) * step);
  for (int i = first; i < last; ++i) {
    Across& a = out[static_cast<size_t>(i - first)];
    a = across_at(system, i, lowest, [&](int t) -> Section {
      const ThreadBody& body = threads[static_cast<size_t>(wrap(t, static_cast<int>(threads.size())))];
      return {{0.5f * body.width_mm, 0.5f * body.height_mm}, 0, glm::vec2(0.5f * body.spacing_mm), body.squareness};
    });
    lowest = a.lowest;
  }
  return out;
}

/// The thread within whose borders a position lies; searched from `lowest` on.
template <class Sections>
int SurfaceSampler::thread_under(System system, float at_mm, int lowest, const Sections& sections) const {
  const auto& threads = threads_of(cloth_, system);
  const auto end_of = [&](int t) {
    return threads[static_cast<size_t>(t)].centre_mm + 0.5f * threads[static_cast<size_t>(t)].spacing_mm;
  };
  int t = lowest;
  while (t + 1 < static_cast<int>(threads.size()) && end_of(t) <= at_mm) ++t;
  if (!uneven_[system == System::kWarp ? 0 : 1]) return t;
  const Section own = sections(t);
  const float beyond = at_mm - centre_of(system, t) - own.aside;
  return beyond >= own.room.y ? t + 1 : beyond < -own.room.x ? t - 1 : t;
}

/// Cover and mean slope of the threads [first, last] within a sample.
template <class Sections>
void SurfaceSampler::add_cover(Across& a, System system, float from, float to, int first, int last,
                               const Sections& sections) const {
  float covered = 0, rise = 0;
  for (int t = first; t <= last; ++t) {
    const Section s = sections(t);
    const float centre = centre_of(system, t) + s.aside;
    const float lo = std::max(from, centre - s.half.x), hi = std::min(to, centre + s.half.x);
    if (hi <= lo) continue;
    covered += hi - lo;
    rise += section(centre, s.half, s.squareness, hi) - section(centre, s.half, s.squareness, lo);
  }
  const float step = to - from;
  if (covered > 1e-6f * step) a.slope = -rise / covered;
  a.cover = unit_or_less(covered / step);
}

template <class Sections>
SurfaceSampler::Across SurfaceSampler::across_at(System system, int sample, int lowest,
                                                 const Sections& sections) const {
  const auto& threads = threads_of(cloth_, system);
  const auto& textures = system == System::kWarp ? warp_texture_ : weft_texture_;
  const float step = system == System::kWarp ? dx_mm_ : dy_mm_;
  const float step_along = system == System::kWarp ? dy_mm_ : dx_mm_;
  const float length = system == System::kWarp ? cloth_.depth_mm : cloth_.width_mm;
  const float from = static_cast<float>(sample) * step, to = static_cast<float>(sample + 1) * step;
  const float middle = 0.5f * (from + to);
  const int count = static_cast<int>(threads.size());
  const auto side_of = [&](int t, float way) {
    return threads[static_cast<size_t>(t)].centre_mm + way * 0.5f * threads[static_cast<size_t>(t)].spacing_mm;
  };
  Across a;
  while (lowest + 1 < count && side_of(lowest, 1) <= from) ++lowest;
  a.lowest = lowest;
  a.thread = thread_under(system, middle, lowest, sections);
  const ThreadTexture& texture = textures.at(a.thread);
  const Section own = sections(a.thread);
  const float centre = centre_of(system, a.thread) + own.aside;
  const glm::vec2 size = own.half;
  if (from >= centre - own.room.x && to <= centre + own.room.y) {
    add_cover(a, system, from, to, a.thread, a.thread, sections);
  } else {
    int highest = lowest;
    while (highest + 1 < count && side_of(highest + 1, -1) < to) ++highest;
    const int margin = uneven_[system == System::kWarp ? 0 : 1] ? 1 : 0;
    add_cover(a, system, from, to, lowest - margin, highest + margin, sections);
  }
  const float half = std::max(size.x, 1e-7f);
  a.beyond_mm = std::max(0.0f, std::abs(middle - centre) - half);
  const float u0 = std::clamp((from - centre) / half, -1.0f, 1.0f);
  const float u1 = std::clamp((to - centre) / half, -1.0f, 1.0f);
  const float u = 0.5f * (u0 + u1);
  const float top = section_top(u, own.squareness);
  a.height_mm = size.y * top;
  const float around = std::atan2(u, top) / kTwoPi;
  a.turn = texture.fibres * around;
  a.ply_turn = static_cast<float>(texture.plies) * around;
  const float turn_per_sample = step / (kTwoPi * half) * turn_across(u, top, own.squareness);
  const auto cycles = [&](float patterns, int advance) {
    return std::max(patterns * turn_per_sample, std::abs(static_cast<float>(advance)) * step_along / length);
  };
  a.cycles = cycles(texture.fibres, texture.advance);
  a.ply_fade = contrast_left(cycles(static_cast<float>(texture.plies), texture.ply_advance));
  return a;
}

SurfaceSampler::CrossingSizes SurfaceSampler::crossing_sizes(System system) const {
  const bool warp = system == System::kWarp;
  const auto& threads = threads_of(cloth_, system);
  const std::vector<Across>& own = warp ? columns_ : rows_;
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
  const Textures& textures = warp ? warp_texture_ : weft_texture_;
  const ThreadTexture& texture = textures.at(thread);
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
  if (textures.has_pattern(thread)) a.turn += thread_formulas::wander(texture, a.node, a.blend);
  return a;
}

const std::vector<SurfaceSampler::Along>& SurfaceSampler::along_pick(int pick) {
  Pick& kept = picks_[static_cast<size_t>((pick + 3) % 3)];
  if (kept.pick == pick) return kept.along;
  kept.pick = pick;
  kept.along.resize(columns_.size());
  for (int x = x0_; x < x1_; ++x) {
    const size_t i = static_cast<size_t>(x - x0_);
    const float s_mm = (static_cast<float>(x) + 0.5f) * dx_mm_;
    kept.along[i] = along(System::kWeft, pick, moved_step(cloth_, System::kWeft, pick, s_mm, column_steps_[i]), s_mm);
  }
  return kept.along;
}

SurfaceSample SurfaceSampler::finish(System system, const Across& a, const Along& l, float cover) const {
  const bool warp = system == System::kWarp;
  const std::vector<ThreadBody>& threads = warp ? cloth_.ends : cloth_.picks;
  const int thread = wrap(a.thread, static_cast<int>(threads.size()));
  const ThreadTexture& texture = (warp ? warp_texture_ : weft_texture_).at(a.thread);
  const Texel texel = texture_at(
      texture, {a.turn + l.turn, a.ply_turn + l.ply_turn, a.turn / thread_formulas::kStraySpacing + l.stray_turn,
                l.node, l.blend, a.cycles, a.ply_fade});
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
  const Across& even_row = rows_[static_cast<size_t>(y - y0_)];
  const float s_mm = (static_cast<float>(y) + 0.5f) * dy_mm_;
  const CentreStep even = centre_step(cloth_, System::kWarp, s_mm);
  const auto end_step = [&](int end) { return moved_step(cloth_, System::kWarp, end, s_mm, even); };
  for (size_t e = 0; e < warp_along_.size(); ++e)
    warp_along_[e] =
        along(System::kWarp, first_end_ + static_cast<int>(e), end_step(first_end_ + static_cast<int>(e)), s_mm);
  beside.clear();
  for (size_t i = 0; i < out.size(); ++i) {
    // Uneven threads have another width at each position along them.
    const Across column = uneven_[0] ? across_at(System::kWarp, x0_ + static_cast<int>(i), columns_[i].lowest,
                                                 [&](int t) { return warp_sizes_.at(t, end_step(t)); })
                                     : columns_[i];
    const float x_mm = (static_cast<float>(x0_ + static_cast<int>(i)) + 0.5f) * dx_mm_;
    const auto pick_step = [&](int pick) { return moved_step(cloth_, System::kWeft, pick, x_mm, column_steps_[i]); };
    const Across across_row = uneven_[1] ? across_at(System::kWeft, y, even_row.lowest,
                                                     [&](int t) { return weft_sizes_.at(t, pick_step(t)); })
                                         : even_row;
    const Along& end = warp_along_[static_cast<size_t>(column.thread - first_end_)];
    const Along& pick = along_pick(across_row.thread)[i];
    // Coverage of each system: where both are present, one is on top.
    const float both = column.cover * across_row.cover;
    const bool over =
        end.centre_mm + column.height_mm * end.lengthened >= pick.centre_mm + across_row.height_mm * pick.lengthened;
    const float warp = column.cover - (over ? 0.0f : both), weft = across_row.cover - (over ? both : 0.0f);
    if (warp + weft <= 0.0f) {
      const bool near_warp = column.beyond_mm <= across_row.beyond_mm;
      out[i] = near_warp ? finish(System::kWarp, column, end, 0) : finish(System::kWeft, across_row, pick, 0);
      out[i].height_mm = floor_mm_, out[i].slope = {};
      continue;
    }
    const bool warp_first = warp >= weft;
    out[i] = warp_first ? finish(System::kWarp, column, end, warp) : finish(System::kWeft, across_row, pick, weft);
    if (std::min(warp, weft) > kMinCover)
      beside.push_back({static_cast<int>(i), warp_first ? finish(System::kWeft, across_row, pick, weft)
                                                        : finish(System::kWarp, column, end, warp)});
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
