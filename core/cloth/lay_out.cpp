// Lays a design out in millimetres: the position of each thread and its flattened section.
//
// Based on: F. T. Peirce, The Geometry of Cloth Structure, 1937, and A. Kemp, An Extension of Peirce's Cloth Geometry
// to the Treatment of Non-circular Threads, 1958.
// Differs: Kemp's race-track section is an ellipse of the same area here, fuller where a thread has too little room.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "cloth/cloth.h"
#include "cloth/layer_plan.h"
#include "cloth/layers.h"
#include "cloth/relief.h"
#include "cloth/thickness.h"
#include "cloth/thread_texture.h"
#include "cloth/washed_aside.h"
#include "design/dye.h"
#include "design/fibre.h"
#include "design/repeat.h"
#include "design/srgb.h"

namespace weftlight::cloth {

using cloth::thread_formulas::mix_bits, cloth::thread_formulas::unit_of;
using design::Design, design::Repeat, design::Yarn, design::design_repeat;
using design::srgb_decoded, design::srgb_encoded;
using draft::BitMatrix, draft::Face, draft::Rgb, draft::System, draft::Threads, draft::kFromYarn;

namespace {

// Spacing over width where the draft gives no spacing: a balanced cloth of touching threads is a few percent open (1 -
// 1/1.06 a system).
constexpr float kTouching = 1.06f;
// Where the room is narrower than a thread, its section first fills the corners of its room. Then fibres that no twist
// holds are pushed together, at the height that the thread has, up to this fraction of its section; then it gets
// taller, up to this height over width. Round fibres, packed as closely as they go, fill 0.91 of it, the yarns of
// presets 0.4 to 0.65 before they are woven; by eye.
constexpr float kDensest = 0.75f;
constexpr float kFirmTwist = 0.4f;  // tangent of the twist from which a yarn keeps its section; by eye
// Steps of squareness, as the threads' records hold it, to which a section fills its corners; by eye: squarer ones show
// edges where they bend.
constexpr int kSquarest = 12;
const float kTallest = thread_formulas::kTallestSection;
constexpr float kLargest_mm = 1.0e4f;
constexpr float kSmallestSpacing_mm = 1.0e-3f;

float channel_to_linear(float c) { return srgb_decoded(std::clamp(c, 0.0f, 1.0f)); }
float channel_to_srgb(float c) { return srgb_encoded(std::clamp(c, 0.0f, 1.0f)); }

template <class T>
T entry(const std::vector<T>& table, int i, T missing) {
  return i >= 0 && i < static_cast<int>(table.size()) ? table[static_cast<size_t>(i)] : missing;
}

/// Negative and NaN mean "take the yarn's".
bool is_given(float mm) { return mm >= 0.0f; }

/// Of a section that needs `jammed` times the area of the ellipse in its room.
float squareness_for(float jammed) {
  float nearest = 0;
  for (int step = 1; step <= kSquarest; ++step) {
    const float q = static_cast<float>(step) / thread_formulas::kSquareSteps;
    const auto off = [&](float of) { return std::abs(thread_formulas::section_fullness(of) - jammed); };
    if (off(q) < off(nearest)) nearest = q;
  }
  return nearest;
}

/// least: fraction of its section to which a thread can be pressed; it counts only for the height.
ThreadBody body_of(float diameter, float spacing, const Yarn& yarn, float least = 1) {
  ThreadBody body;
  diameter = std::clamp(diameter, 0.0f, kLargest_mm);
  const float flat = std::isnan(yarn.flattening) ? 1.0f : std::clamp(yarn.flattening, 0.3f, 1.0f);
  const float free_width = diameter / std::sqrt(flat);
  body.spacing_mm = spacing > 0.0f ? std::min(spacing, kLargest_mm) : kTouching * free_width;
  body.spacing_mm = std::max(body.spacing_mm, kSmallestSpacing_mm);
  // Threads with gaps between them are pressed less and stay rounder; the area stays.
  const float tightness = std::min(1.0f, diameter * kTouching / body.spacing_mm);
  const float section = 1.0f - (1.0f - flat) * tightness;
  const float wanted = diameter / std::sqrt(section);
  body.width_mm = std::min(wanted, body.spacing_mm);
  if (body.width_mm <= 0.0f) return body;
  const float jammed = wanted / body.width_mm;
  body.squareness = squareness_for(jammed);
  const float full = thread_formulas::section_fullness(body.squareness), left = std::clamp(full / jammed, least, 1.0f);
  body.height_mm = std::min(left * diameter * diameter / (full * body.width_mm), kTallest * body.width_mm);
  return body;
}

const Yarn& yarn_of(const Design& design, const Threads& threads, int i) {
  const int last = static_cast<int>(design.yarns.size()) - 1;
  return design.yarns[static_cast<size_t>(std::clamp(entry(threads.yarn, i, 0), 0, last))];
}

float diameter_of(const Design& design, const Threads& threads, int i) {
  const float thickness = entry(threads.thickness_mm, i, kFromYarn);
  return is_given(thickness) ? thickness : std::max(0.0f, yarn_of(design, threads, i).diameter_mm);
}

/// Thickness factor of each thread of an irregular spun yarn, 1/3 to 3; the same for the same thread.
float irregularity_factor(const Yarn& yarn, System system, int thread) {
  const float spread = std::isnan(yarn.irregularity) ? 0 : std::clamp(yarn.irregularity, 0.0f, 0.6f);
  if (spread <= 0) return 1;
  using thread_formulas::mix_bits, thread_formulas::unit_of;
  const uint32_t seed = mix_bits(static_cast<uint32_t>(thread), system == System::kWarp ? 0x7Bu : 0xC5u);
  // The sum of three uniform numbers is nearly normal, with standard deviation 1/2.
  const float sum = unit_of(mix_bits(seed, 1)) + unit_of(mix_bits(seed, 2)) + unit_of(mix_bits(seed, 3)) - 1.5f;
  return std::clamp(1 + 2 * spread * sum, 1 / 3.0f, 3.0f);
}

/// Raised finish: fibres bridge the gaps between threads and follow their relief only weakly. A thread then represents
/// its part of the nap's surface.
void cover_with_nap(ThreadBody& body, float raised) {
  body.width_mm += (body.spacing_mm - body.width_mm) * raised;
  body.height_mm *= 1 - kNapFlattening * raised;
}

/// Calendering: a thread spreads into the free space beside it; its section keeps its area.
void press(ThreadBody& body, float flattening, float calendered) {
  const float area = body.width_mm * body.height_mm;
  const float wide = std::min(std::sqrt(area / std::clamp(flattening, 0.3f, 1.0f)), body.spacing_mm);
  body.width_mm += std::max(wide - body.width_mm, 0.0f) * calendered;
  if (body.width_mm > 0) body.height_mm = std::min(body.height_mm, area / body.width_mm);
}

/// By yarn, the fraction of its section to which it can be pressed.
std::vector<float> least_sections(const std::vector<Yarn>& yarns) {
  std::vector<float> out;
  for (const Yarn& yarn : yarns) {
    const float tangent =
        yarn.twist == design::Twist::kNone ? 0 : std::numbers::pi_v<float> * yarn.diameter_mm * yarn.turns_per_m / 1000;
    const float soft = 1 - std::clamp(tangent / kFirmTwist, 0.0f, 1.0f);
    const float packing = static_cast<float>(design::packing_fraction(yarn));
    out.push_back(1 - soft * (1 - std::clamp(packing / kDensest, 0.0f, 1.0f)));
  }
  return out;
}

std::vector<std::vector<Linear>> linear_dyes(const design::DyedThreads& dyed) {
  std::vector<std::vector<Linear>> out;
  for (const std::vector<Rgb>& colors : dyed.tables()) {
    std::vector<Linear>& dye = out.emplace_back();
    for (const Rgb& c : colors) dye.push_back(linear_from_srgb(c));
  }
  return out;
}

std::vector<Linear> means_of(const std::vector<std::vector<Linear>>& dyes) {
  std::vector<Linear> out;
  for (const std::vector<Linear>& dye : dyes) {
    Linear sum;
    for (const Linear& c : dye) sum.r += c.r, sum.g += c.g, sum.b += c.b;
    const float n = static_cast<float>(dye.size());
    out.push_back({sum.r / n, sum.g / n, sum.b / n});
  }
  return out;
}

/// A design and its yarns after finishing.
struct Woven {
  const Design& design;
  std::vector<Yarn> finished;
  std::vector<float> least_section;  // by yarn
  design::DyedThreads dyed;
  std::vector<std::vector<Linear>> dyes;  // of `dyed`
  std::vector<Linear> dye_means;
  float unwashed;  // 0: washed

  explicit Woven(const Design& d)
      : design(d),
        finished(design::finished(d.yarns, d.finish)),
        least_section(least_sections(d.yarns)),
        dyed(d),
        dyes(linear_dyes(dyed)),
        dye_means(means_of(dyes)),
        unwashed(1 - std::clamp(d.finish.washed, 0.0f, 1.0f)) {}
};

/// Room of thread i: that of the draft, else of its yarn as spun, since finishing does not change the sett; before
/// washing it is wider by what the cloth shrinks.
float spacing_of(const Woven& woven, System system, int i) {
  const Design& design = woven.design;
  const Threads& threads = design.draft.threads(system);
  const float spacing =
      body_of(diameter_of(design, threads, i), entry(threads.spacing_mm, i, kFromYarn), yarn_of(design, threads, i))
          .spacing_mm;
  if (woven.unwashed <= 0) return spacing;
  // Ends lie side by side in the width, which the weft draws in.
  const float shrinkage = system == System::kWarp ? design.plan.weft_shrinkage : design.plan.warp_shrinkage;
  return spacing / (1 - std::clamp(shrinkage, 0.0f, design::kMaxShrinkage) * woven.unwashed);
}

/// Thread i with the given spacing and its yarn's mean thickness: the reed does not know where a yarn is thick.
ThreadBody thread_in_room(const Woven& woven, System system, int i, float spacing) {
  const Design& design = woven.design;
  const Threads& threads = design.draft.threads(system);
  const Yarn& yarn = yarn_of(design, threads, i);
  const size_t index = static_cast<size_t>(&yarn - design.yarns.data());
  float even = diameter_of(design, threads, i);
  if (woven.unwashed > 0) even /= 1 + (design::bloom(yarn) - 1) * woven.unwashed;
  ThreadBody body = body_of(even, spacing, woven.finished[index], woven.least_section[index]);
  const float calendered = std::min(design.finish.calendered, 1.0f);
  if (calendered > 0) press(body, woven.finished[index].flattening, calendered);
  if (design.finish.raised > 0 && body.width_mm > 0) cover_with_nap(body, std::min(design.finish.raised, 1.0f));
  body.yarn = static_cast<int>(index);
  body.diameter_mm = even;
  body.unevenness = unevenness_of(yarn, design.finish);
  body.colour = linear_from_srgb(entry(design.draft.palette, entry(threads.color, i, 0), Rgb{}));
  body.place = i, body.dye = woven.dyed.table(system, i), body.dye_phase = woven.dyed.phase(system, i);
  if (body.dye >= 0) body.colour = woven.dye_means[static_cast<size_t>(body.dye)];
  return body;
}

/// Gives each thread of a row (by index in the draft) its own thickness.
void make_uneven(const Woven& woven, System system, std::span<ThreadBody> row, std::span<const int> threads) {
  std::vector<float> thickness;
  thickness.reserve(row.size());
  for (size_t k = 0; k < row.size(); ++k) {
    thickness.push_back(irregularity_factor(woven.design.yarns[static_cast<size_t>(row[k].yarn)], system, threads[k]));
    row[k].diameter_mm *= thickness.back();
  }
  give_way(row, thickness);
}

std::vector<ThreadBody> bodies(const Woven& woven, System system, int count, float& period) {
  std::vector<ThreadBody> out;
  out.reserve(static_cast<size_t>(count));
  double edge = 0;
  for (int i = 0; i < count; ++i) {
    ThreadBody body = thread_in_room(woven, system, i, spacing_of(woven, system, i));
    body.centre_mm = static_cast<float>(edge + 0.5 * static_cast<double>(body.spacing_mm));
    edge += static_cast<double>(body.spacing_mm);
    out.push_back(body);
  }
  period = static_cast<float>(edge);
  std::vector<int> order(out.size());
  std::iota(order.begin(), order.end(), 0);
  make_uneven(woven, system, out, order);
  return out;
}

/// Order of the threads that goes layer by layer.
std::vector<int> layer_order(const std::vector<uint8_t>& layer_of) {
  std::vector<int> order(layer_of.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int i) { return layer_of[static_cast<size_t>(i)]; });
  return order;
}

/// Ends of the smallest groups of threads in which each layer has its overall proportion.
std::vector<int> balanced_groups(const std::vector<uint8_t>& layer_of, int layers) {
  std::vector<int64_t> all(static_cast<size_t>(layers)), so_far(all);
  for (const uint8_t l : layer_of) ++all[l];
  std::vector<int> ends;
  for (size_t i = 0; i < layer_of.size(); ++i) {
    ++so_far[layer_of[i]];
    const auto even = [&](size_t l) { return so_far[l] * all[0] == so_far[0] * all[l]; };
    bool shared = true;
    for (size_t l = 1; l < all.size(); ++l) shared = shared && even(l);
    if (shared) ends.push_back(static_cast<int>(i) + 1);
  }
  return ends;
}

/// Threads ordered layer by layer; those of each layer fill the cloth. A group is as wide as the draft's spacings add
/// up to, or as its widest layer where the yarns alone decide.
std::vector<ThreadBody> layered_bodies(const Woven& woven, System system, const std::vector<uint8_t>& layer_of,
                                       int layers, float& period) {
  const Threads& threads = woven.design.draft.threads(system);
  std::vector<std::vector<ThreadBody>> by_layer(static_cast<size_t>(layers));
  std::vector<std::vector<int>> threads_by_layer(static_cast<size_t>(layers));
  double edge = 0;
  int first = 0;
  for (const int last : balanced_groups(layer_of, layers)) {
    std::vector<double> own(static_cast<size_t>(layers));
    double room = 0;
    bool given = false;
    for (int i = first; i < last; ++i) {
      given = given || entry(threads.spacing_mm, i, kFromYarn) > 0;
      own[layer_of[static_cast<size_t>(i)]] += static_cast<double>(spacing_of(woven, system, i));
    }
    for (const double sum : own) room = given ? room + sum : std::max(room, sum);
    std::vector<double> at(static_cast<size_t>(layers), edge);
    for (int i = first; i < last; ++i) {
      const size_t layer = layer_of[static_cast<size_t>(i)];
      const float alone = spacing_of(woven, system, i);
      const double mine = static_cast<double>(alone) * room / own[layer];
      ThreadBody body = thread_in_room(woven, system, i, static_cast<float>(mine));
      body.centre_mm = static_cast<float>(at[layer] + 0.5 * mine);
      at[layer] += mine;
      by_layer[layer].push_back(body);
      threads_by_layer[layer].push_back(i);
    }
    edge += room, first = last;
  }
  period = static_cast<float>(edge);
  std::vector<ThreadBody> out;
  for (size_t l = 0; l < by_layer.size(); ++l) {
    make_uneven(woven, system, by_layer[l], threads_by_layer[l]);
    out.insert(out.end(), by_layer[l].begin(), by_layer[l].end());
  }
  return out;
}

BitMatrix top_left(const BitMatrix& cells, int picks, int ends, bool flip) {
  BitMatrix out(picks, ends);
  for (int p = 0; p < picks; ++p) {
    const auto from = cells.row(p);
    const auto to = out.row(p);
    for (size_t w = 0; w < to.size(); ++w) to[w] = flip ? ~from[w] : from[w];
    if (!to.empty()) to.back() &= out.last_word_mask();
  }
  return out;
}

void turn_over(Cloth& cloth) {
  cloth.up = top_left(cloth.up, cloth.up.rows(), cloth.up.cols(), true);
  for (float& level : cloth.warp_level_mm) level = -level;
  for (float& level : cloth.weft_level_mm) level = -level;
}

}  // namespace

ThreadSize thread_size(const Design& design, System system, int thread) {
  const Threads& threads = design.draft.threads(system);
  const float diameter = diameter_of(design, threads, thread);
  const Yarn& yarn = yarn_of(design, threads, thread);
  return {diameter, body_of(diameter, entry(threads.spacing_mm, thread, kFromYarn), yarn).spacing_mm};
}

Linear linear_from_srgb(Rgb c) { return {channel_to_linear(c.r), channel_to_linear(c.g), channel_to_linear(c.b)}; }

Rgb srgb_from_linear(Linear c) { return {channel_to_srgb(c.r), channel_to_srgb(c.g), channel_to_srgb(c.b)}; }

Cloth lay_out(const Design& design, const BitMatrix& cells, Face face, Period period) {
  Repeat size{cells.cols(), cells.rows()};
  if (period == Period::kRepeat && size.ends > 0 && size.picks > 0) size = design_repeat(design, cells);
  Cloth cloth;
  const Woven woven(design);
  cloth.yarns = woven.finished.empty() ? std::vector<Yarn>{Yarn{}} : woven.finished;
  cloth.dyes = woven.dyes;
  cloth.up = top_left(cells, size.picks, size.ends, false);
  const LayerPlan plan = find_layers(cloth.up);
  if (plan.layers > 1) {
    cloth.ends = layered_bodies(woven, System::kWarp, plan.end_layer, plan.layers, cloth.width_mm);
    cloth.picks = layered_bodies(woven, System::kWeft, plan.pick_layer, plan.layers, cloth.depth_mm);
    put_in_layers(cloth, plan, layer_order(plan.end_layer), layer_order(plan.pick_layer));
  } else {
    cloth.ends = bodies(woven, System::kWarp, size.ends, cloth.width_mm);
    cloth.picks = bodies(woven, System::kWeft, size.picks, cloth.depth_mm);
    cloth.warp_level_mm =
        washed_relief(cloth, 1 - woven.unwashed, 0.5f * (design.plan.warp_shrinkage + design.plan.weft_shrinkage));
    cloth.weft_level_mm = cloth.warp_level_mm;
    WashedAside aside = washed_aside(cloth, 1 - woven.unwashed);
    cloth.warp_aside_mm = std::move(aside.warp_mm), cloth.weft_aside_mm = std::move(aside.weft_mm);
  }
  if (face == Face::kBack) turn_over(cloth);
  return cloth;
}

}  // namespace weftlight::cloth
