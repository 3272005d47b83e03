// Many pairs of directions of one yarn: the formulas of shaders/lobes.glsl over blocks of pairs, stage by
// stage (places, look-ups, sides, reflection), each stage a loop that the compiler turns into vectors.

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>

#include "light/tables.h"
#include "light/yarn_lobes.h"

namespace weftlight::light {
namespace {

constexpr size_t kBlock = 64;  // pairs; all stages of a block stay in the first cache
constexpr size_t kMaxFuzzOpenings = 64;

template <class T>
struct alignas(32) Lanes : std::array<T, kBlock> {};  // one number of every pair

struct Directions {
  Lanes<float> x, y, z;
  glm::vec3 at(size_t k) const { return {x[k], y[k], z[k]}; }
};

/// LobePlace, what is stored there, and the rest of LobeSide, of one direction of every pair.
struct Sides {
  Lanes<float> mu, area, rim, opening, along, across, mixed;
  Lanes<int> entry;                           // of the albedo table: first float of the cell
  Lanes<float> opening_t, along_t, across_t;  // shares within the cell
  Lanes<float> lost, cosine, fuzz_lost;
  Lanes<float> enters_x, enters_y, enters_z, clear;
};

/// What all pairs share.
struct Shared {
  formulas::YarnLobes yarn;
  formulas::LobeShared lobes;
  const Table& albedo;
  std::array<float, kMaxFuzzOpenings> fuzz_lost{};  // fuzz_table(.., depth of the yarn).y
  int fuzz_openings = 2;
  float fuzz_mean = 0;  // fuzz_table(.., depth of the yarn).w
};

Shared shared_of(const formulas::YarnLobes& yarn) {
  Shared s{yarn, formulas::lobe_shared(yarn), light_tables().albedo};
  s.fuzz_openings = light_tables().fuzz.nx;
  assert(s.fuzz_openings <= static_cast<int>(kMaxFuzzOpenings));
  if (yarn.fuzz <= 0) return s;
  const float depth = formulas::fuzz_place(yarn, 1).y;
  for (int i = 0; i < s.fuzz_openings; ++i) {
    const glm::vec4 f = formulas::fuzz_table(static_cast<float>(i) / static_cast<float>(s.fuzz_openings - 1), depth);
    s.fuzz_lost[static_cast<size_t>(i)] = f.y;
    s.fuzz_mean = f.w;
  }
  return s;
}

/// Lanes past the end look along the normal.
void load(std::span<const glm::vec3> from, Directions& to) {
  for (size_t k = 0; k < from.size(); ++k) to.x[k] = from[k].x, to.y[k] = from[k].y, to.z[k] = from[k].z;
  for (size_t k = from.size(); k < kBlock; ++k) to.x[k] = to.y[k] = 0, to.z[k] = 1;
}

void find_places(const Shared& shared, const Directions& w, Sides& s) {
  for (size_t k = 0; k < kBlock; ++k) {
    const formulas::LobePlace p = formulas::lobe_place(shared.lobes, w.at(k));
    s.mu[k] = p.mu, s.area[k] = p.area, s.rim[k] = p.rim, s.mixed[k] = p.mixed;
    s.opening[k] = p.opening, s.along[k] = p.along, s.across[k] = p.across;
  }
}

void find_cells(const Table& t, Sides& s) {
  for (size_t k = 0; k < kBlock; ++k) {
    const TableCell x = cell_of(s.opening[k], t.nx), y = cell_of(s.along[k], t.ny), z = cell_of(s.across[k], t.nz);
    s.entry[k] = ((z.i * t.ny + y.i) * t.nx + x.i) * 4;
    s.opening_t[k] = x.t, s.along_t[k] = y.t, s.across_t[k] = z.t;
  }
}

using Four = float __attribute__((vector_size(16)));

Four entry_at(const float* p) {
  Four v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

/// Between two rows, at an entry and at the next along the opening.
struct Pair {
  Four low, high;
};
Pair between(const float* p, const float* q, float t) {
  const Four low = entry_at(p), high = entry_at(p + 4);
  return {low + t * (entry_at(q) - low), high + t * (entry_at(q + 4) - high)};
}

/// Trilinear, all four channels at once.
void look_up_albedo(const Table& t, Sides& s) {
  const int row = t.nx * 4, plane = row * t.ny;
  for (size_t k = 0; k < kBlock; ++k) {
    const float* p = t.values.data() + s.entry[k];
    const Pair near = between(p, p + row, s.along_t[k]), far = between(p + plane, p + plane + row, s.along_t[k]);
    const Four low = near.low + s.across_t[k] * (far.low - near.low);
    const Four high = near.high + s.across_t[k] * (far.high - near.high);
    const Four stored = low + s.opening_t[k] * (high - low);
    s.lost[k] = stored[0] + s.mixed[k] * (stored[2] - stored[0]);
    s.cosine[k] = stored[1] + s.mixed[k] * (stored[3] - stored[1]);
  }
}

void look_up_fuzz(const Shared& shared, Sides& s) {
  for (size_t k = 0; k < kBlock; ++k) {
    const TableCell cell = cell_of(formulas::fuzz_place(shared.yarn, s.mu[k]).x, shared.fuzz_openings);
    const float* p = shared.fuzz_lost.data() + cell.i;
    s.fuzz_lost[k] = p[0] + cell.t * (p[1] - p[0]);
  }
}

formulas::LobeSide finished(const formulas::YarnLobes& yarn, const Shared& shared, const Sides& s, size_t k) {
  const formulas::LobePlace p{s.mu[k], s.area[k], s.rim[k], s.opening[k], s.along[k], s.across[k], s.mixed[k]};
  // Reflection asks for what the fuzz loses, and for the mean of it.
  return formulas::lobe_finish(yarn, shared.lobes, p, {s.lost[k], s.cosine[k]},
                               {0, s.fuzz_lost[k], 0, shared.fuzz_mean});
}

void reflect_block(const formulas::YarnLobes& yarn, const Shared& shared, const Directions& wi, const Directions& wo,
                   const Sides& i, const Sides& o, Directions& out) {
  for (size_t k = 0; k < kBlock; ++k) {
    const glm::vec3 f = formulas::lobe_reflect(yarn, shared.lobes, finished(yarn, shared, i, k),
                                               finished(yarn, shared, o, k), wi.at(k), wo.at(k));
    const bool lit = wi.z[k] > 0 && wo.z[k] > 0;
    out.x[k] = lit ? f.x : 0, out.y[k] = lit ? f.y : 0, out.z[k] = lit ? f.z : 0;
  }
}

inline void reflect_all(const Shared& shared, std::span<const glm::vec3> wi, std::span<const glm::vec3> wo,
                        std::span<glm::vec3> out) {
  formulas::YarnLobes bare = shared.yarn;
  bare.fuzz = 0;  // known to the compiler: that loop has no fuzz at all
  Directions in, seen, f;
  Sides i, o;
  i.fuzz_lost.fill(0), o.fuzz_lost.fill(0);
  for (size_t first = 0; first < out.size(); first += kBlock) {
    const size_t count = std::min(kBlock, out.size() - first);
    load(wi.subspan(first, count), in);
    load(wo.subspan(first, count), seen);
    find_places(shared, in, i);
    find_places(shared, seen, o);
    find_cells(shared.albedo, i);
    find_cells(shared.albedo, o);
    look_up_albedo(shared.albedo, i);
    look_up_albedo(shared.albedo, o);
    if (shared.yarn.fuzz > 0) {
      look_up_fuzz(shared, i);
      look_up_fuzz(shared, o);
      reflect_block(shared.yarn, shared, in, seen, i, o, f);
    } else {
      reflect_block(bare, shared, in, seen, i, o, f);
    }
    for (size_t k = 0; k < count; ++k) out[first + k] = f.at(k);
  }
}

// The same text for each kind of vectors: `flatten` draws every formula into it.
[[gnu::flatten]] void reflect_baseline(const Shared& shared, std::span<const glm::vec3> wi,
                                       std::span<const glm::vec3> wo, std::span<glm::vec3> out) {
  reflect_all(shared, wi, wo, out);
}

#if defined(__x86_64__)
[[gnu::flatten, gnu::target("avx2,fma")]] void reflect_avx2(const Shared& shared, std::span<const glm::vec3> wi,
                                                            std::span<const glm::vec3> wo, std::span<glm::vec3> out) {
  reflect_all(shared, wi, wo, out);
}
#endif

}  // namespace

Vectors widest_vectors() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return Vectors::kAvx2;
#endif
  return Vectors::kBaseline;
}

void reflect(const formulas::YarnLobes& yarn, std::span<const glm::vec3> wi, std::span<const glm::vec3> wo,
             std::span<glm::vec3> out, [[maybe_unused]] Vectors vectors) {
  assert(wi.size() == wo.size() && wi.size() == out.size());
  const Shared shared = shared_of(yarn);
#if defined(__x86_64__)
  if (vectors == Vectors::kAvx2) return reflect_avx2(shared, wi, wo, out);
#endif
  reflect_baseline(shared, wi, wo, out);
}

}  // namespace weftlight::light
