#include "render_data/thread_block.h"

#include <algorithm>
#include <bit>
#include <glm/gtc/packing.hpp>

#include "base/loops.h"
#include "cloth/centre_line.h"
#include "cloth/relief.h"
#include "cloth/thread_scene.h"
#include "cloth/washed_aside.h"
#include "cloth/wrap.h"
#include "light/yarn_lobes.h"
#include "shaders/interop.h"

namespace weftlight::render_data {

namespace thread_formulas = cloth::thread_formulas;

using base::for_each_job;
using cloth::Linear, cloth::ThreadBody, cloth::ThreadHead, cloth::ThreadRecord, cloth::ThreadTables, cloth::kFloatReach,
    cloth::kReliefReach, cloth::kAsideReach, cloth::thread_tables, cloth::thread_texture, cloth::wrap;
using design::FibreFacts, design::Yarn;
using draft::System;
using light::yarn_data;

namespace {

/// Appends a record as texels.
template <class Record>
void append(std::vector<glm::uvec4>& to, const Record& record) {
  const auto texels = std::bit_cast<std::array<glm::uvec4, sizeof(Record) / sizeof(glm::uvec4)>>(record);
  to.insert(to.end(), texels.begin(), texels.end());
}

void append_threads(std::vector<glm::uvec4>& to, const Cloth& cloth, System system,
                    const std::vector<glm::uvec4>& bodies, const std::vector<int>& dyes) {
  const auto& threads = system == System::kWarp ? cloth.ends : cloth.picks;
  const float length_mm = system == System::kWarp ? cloth.depth_mm : cloth.width_mm;
  const std::vector<FibreFacts> facts = cloth::fibre_facts(cloth);
  for (size_t i = 0; i < threads.size(); ++i) {
    const ThreadBody& body = threads[i];
    const size_t yarn = static_cast<size_t>(body.yarn);
    ThreadRecord record{};
    record.body = bodies[i];
    record.color = {body.colour.r, body.colour.g, body.colour.b};
    record.yarn = body.yarn;
    record.pattern = thread_texture(cloth.yarns[yarn], facts[yarn], body, system, static_cast<int>(i), length_mm);
    record.dye.w = body.place;
    if (body.dye >= 0) {
      const size_t dye = static_cast<size_t>(body.dye);
      record.dye = {dyes[dye], static_cast<int>(cloth.dyes[dye].size()), body.dye_phase, body.place};
    }
    append(to, record);
  }
}

/// The first texel of each.
std::vector<int> append_dyes(std::vector<glm::uvec4>& to, const Cloth& cloth) {
  std::vector<int> first;
  for (const std::vector<Linear>& dye : cloth.dyes) {
    first.push_back(static_cast<int>(to.size()));
    for (const Linear& c : dye) append(to, glm::vec4(c.r, c.g, c.b, 0));
  }
  return first;
}

void append_bins(std::vector<glm::uvec4>& to, const std::vector<int>& first) {
  for (size_t i = 0; i < first.size(); i += 4) {
    glm::uvec4 four(0);
    for (size_t k = 0; k < 4 && i + k < first.size(); ++k)
      four[static_cast<int>(k)] = static_cast<uint32_t>(first[i + k]);
    to.push_back(four);
  }
}

}  // namespace

std::vector<glm::uvec4> thread_records(const Cloth& cloth, float top_mm) {
  ThreadTables t = thread_tables(cloth, top_mm);
  std::vector<glm::uvec4> to(THREAD_HEAD_TEXELS * t.layers.size());
  ThreadHead head{};
  const std::vector<int> dyes = append_dyes(to, cloth);
  for (const System s : {System::kWarp, System::kWeft}) {
    const int k = s == System::kWarp ? 0 : 1;
    head.threads[k] = static_cast<int>(to.size());
    append_threads(to, cloth, s, t.bodies[static_cast<size_t>(k)], dyes);
    head.bins[k] = static_cast<int>(to.size());
    append_bins(to, t.first[static_cast<size_t>(k)]);
  }
  head.yarns = static_cast<int>(to.size());
  for (const Yarn& yarn : cloth.yarns) append(to, yarn_data(yarn.lobes));
  const int ends = static_cast<int>(cloth.ends.size());
  std::vector<glm::uvec4> heads;
  for (ThreadHead& layer : t.layers) {
    layer.threads = head.threads, layer.bins = head.bins, layer.yarns = head.yarns;
    layer.crossing_blocks = (ends + CROSSING_BLOCK - 1) / CROSSING_BLOCK;
    append(heads, layer);
  }
  std::copy(heads.begin(), heads.end(), to.begin());
  to.resize((to.size() + THREAD_MAP_WIDTH - 1) / THREAD_MAP_WIDTH * THREAD_MAP_WIDTH, glm::uvec4(0));
  return to;
}

namespace {

/// Whether that holds for each thread of a system: holds(its record). Records lie between the offsets of the threads
/// and of the bins.
template <class Holds>
bool all_threads(const std::vector<glm::uvec4>& records, const thread_formulas::ThreadHead& head, int system,
                 Holds holds) {
  for (int at = head.threads[system]; at + THREAD_TEXELS <= head.bins[system]; at += THREAD_TEXELS) {
    if (static_cast<size_t>(at + THREAD_TEXELS) > records.size()) return false;
    if (!holds(records.data() + at)) return false;
  }
  return true;
}

template <class Holds>
bool all_threads(const std::vector<glm::uvec4>& records, const thread_formulas::ThreadHead& head, Holds holds) {
  return all_threads(records, head, 0, holds) && all_threads(records, head, 1, holds);
}

bool is_even(const glm::uvec4* record) {
  const auto section = thread_formulas::record_body(record[THREAD_BODY]);
  return !is_uneven(section) && section.aside == glm::vec2(0);
}

/// A thread that fills its room at one place fills it everywhere (shaders/thread_thickness.glsl).
bool fills_its_room(const glm::uvec4* record) {
  const auto section = thread_formulas::record_body(record[THREAD_BODY]);
  const float room = section.half_room + 0.5f * (section.aside.y - section.aside.x);
  return section.half_width >= room * (1 - 1e-6f);
}

bool has_one_color(const glm::uvec4* record) { return record[THREAD_DYE].y == 0; }

}  // namespace

ThreadKind thread_kind(const std::vector<glm::uvec4>& records) {
  using Texels = std::array<glm::uvec4, THREAD_HEAD_TEXELS>;
  ThreadKind kind;
  for (size_t i = 0, layers = 1; i < layers && records.size() >= (i + 1) * THREAD_HEAD_TEXELS; ++i) {
    Texels texels;
    std::copy_n(records.begin() + static_cast<std::ptrdiff_t>(i * THREAD_HEAD_TEXELS), texels.size(), texels.begin());
    const auto head = std::bit_cast<thread_formulas::ThreadHead>(texels);
    layers = static_cast<size_t>(std::max(head.layers, 1));
    kind.one_layer = layers == 1;
    kind.even = (i == 0 || kind.even) && head.even.x > 0 && head.even.y > 0;
    if (i > 0) continue;
    kind.straight = head.aside == 0;
    kind.closed = kind.one_layer && kind.straight &&
                  (all_threads(records, head, 0, fills_its_room) || all_threads(records, head, 1, fills_its_room));
    kind.smooth = all_threads(records, head, is_even);
    kind.dyed = !all_threads(records, head, has_one_color);
  }
  return kind;
}

std::vector<HalfCrossing> packed_crossings(const std::vector<glm::vec4>& crossings) {
  std::vector<HalfCrossing> out;
  out.reserve(crossings.size());
  for (const glm::vec4& c : crossings)
    out.push_back({glm::packHalf1x16(c.x), glm::packHalf1x16(c.y), glm::packHalf1x16(c.z), glm::packHalf1x16(c.w)});
  return out;
}

std::vector<HalfCrossing> packed_asides(const Cloth& cloth, const CellRect& window) {
  std::vector<HalfCrossing> out;
  for (const glm::vec2& mm : cloth::thread_asides(cloth, window))
    out.push_back({glm::packHalf1x16(mm.x), glm::packHalf1x16(mm.y), 0, 0});
  return out;
}

namespace {

constexpr int kStripBits = STRIP_CELLS + 2 * STRIP_MARGIN;
static_assert(kStripBits == 32 && STRIP_MARGIN > kFloatReach);

int strips_of(int cells) { return (cells + STRIP_CELLS - 1) / STRIP_CELLS; }

/// Strips along a pick.
void fill_pick(const BitMatrix& up, int pick, uint32_t* to) {
  const auto words = up.row(pick);
  const int n = up.cols();
  for (int k = 0; k < strips_of(n); ++k) {
    const int first = k * STRIP_CELLS - STRIP_MARGIN;
    uint32_t strip = 0;
    if (first >= 0 && first + kStripBits <= n) {
      const size_t word = static_cast<size_t>(first) / 64;
      const int shift = first % 64;
      uint64_t bits = words[word] >> shift;
      if (shift > kStripBits) bits |= words[word + 1] << (64 - shift);
      strip = static_cast<uint32_t>(bits);
    } else {
      for (int bit = 0; bit < kStripBits; ++bit) {
        const int e = wrap(first + bit, n);
        strip |= static_cast<uint32_t>((words[static_cast<size_t>(e) / 64] >> (e % 64)) & 1u) << bit;
      }
    }
    to[k] = strip;
  }
}

/// Strip k along each of the ends [end0, end1), `stride` apart.
void fill_ends(const BitMatrix& up, int k, int end0, int end1, uint32_t* to, size_t stride) {
  std::vector<uint32_t> strips(static_cast<size_t>(end1 - end0), 0);
  for (int bit = 0; bit < kStripBits; ++bit) {
    const auto words = up.row(wrap(k * STRIP_CELLS - STRIP_MARGIN + bit, up.rows()));
    for (int e = end0; e < end1; ++e) {
      const uint64_t cell = (words[static_cast<size_t>(e) / 64] >> (e % 64)) & 1u;
      strips[static_cast<size_t>(e - end0)] |= static_cast<uint32_t>(cell) << bit;
    }
  }
  for (size_t i = 0; i < strips.size(); ++i) to[i * stride] = strips[i];
}

void fill_picks(const BitMatrix& up, int pick0, int pick1, uint32_t* to) {
  const size_t stride = static_cast<size_t>(strips_of(up.cols()));
  constexpr int kPicks = 64;  // of a job
  for_each_job((pick1 - pick0 + kPicks - 1) / kPicks, [&](int job) {
    const int first = pick0 + job * kPicks;
    for (int p = first; p < std::min(first + kPicks, pick1); ++p)
      fill_pick(up, p, to + static_cast<size_t>(p - pick0) * stride);
  });
}

void fill_ends(const BitMatrix& up, int end0, int end1, uint32_t* to) {
  const int strips = strips_of(up.rows());
  for_each_job(strips, [&](int k) { fill_ends(up, k, end0, end1, to + k, static_cast<size_t>(strips)); });
}

/// Strips of all picks, before those of the ends.
size_t pick_strips(const BitMatrix& up) {
  return static_cast<size_t>(up.rows()) * static_cast<size_t>(strips_of(up.cols()));
}

}  // namespace

std::vector<uint32_t> cell_strips(const BitMatrix& up) {
  const size_t of_picks = pick_strips(up);
  std::vector<uint32_t> strips(of_picks + static_cast<size_t>(up.cols()) * static_cast<size_t>(strips_of(up.rows())));
  fill_picks(up, 0, up.rows(), strips.data());
  fill_ends(up, 0, up.cols(), strips.data() + of_picks);
  return strips;
}

std::array<StripPatch, 2> cell_strips(const BitMatrix& up, const CellRect& cells) {
  const size_t along_pick = static_cast<size_t>(strips_of(up.cols())),
               along_end = static_cast<size_t>(strips_of(up.rows()));
  std::array<StripPatch, 2> patches;
  auto& [picks, ends] = patches;
  picks.first = static_cast<size_t>(cells.pick0) * along_pick;
  picks.strips.resize(static_cast<size_t>(cells.pick1 - cells.pick0) * along_pick);
  fill_picks(up, cells.pick0, cells.pick1, picks.strips.data());
  ends.first = pick_strips(up) + static_cast<size_t>(cells.end0) * along_end;
  ends.strips.resize(static_cast<size_t>(cells.end1 - cells.end0) * along_end);
  fill_ends(up, cells.end0, cells.end1, ends.strips.data());
  return patches;
}

CellRect touched_crossings(const Cloth& cloth, const CellRect& dirty) {
  constexpr int kMargin =
      std::max({kFloatReach, kReliefReach, kAsideReach}) + 1;  // of heights, and one more for their slopes
  const int ends = static_cast<int>(cloth.ends.size()), picks = static_cast<int>(cloth.picks.size());
  CellRect r{dirty.end0 - kMargin, dirty.end1 + kMargin, dirty.pick0 - kMargin, dirty.pick1 + kMargin};
  // A range that leaves the period wraps around: then the whole axis.
  if (r.end0 < 0 || r.end1 > ends) r.end0 = 0, r.end1 = ends;
  if (r.pick0 < 0 || r.pick1 > picks) r.pick0 = 0, r.pick1 = picks;
  return r;
}

}  // namespace weftlight::render_data
