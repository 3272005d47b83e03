// The formulas of shaders/lobes.glsl over blocks of direction pairs of one yarn, stage by stage (coordinates,
// look-ups, sides, reflection); each stage is a loop that the compiler vectorises.

#include <algorithm>
#include <array>
#include <cassert>

#include "light/tables.h"
#include "light/yarn_lobes.h"

namespace weftlight::light {
namespace {

constexpr size_t kBlock = 64;  // pairs; all stages of a block fit the L1 cache
constexpr size_t kMaxFuzzOpenings = 64;

template <class T>
struct alignas(32) Lanes : std::array<T, kBlock> {};  // one value of every pair

struct Directions {
  Lanes<float> x, y, z;
  glm::vec3 at(size_t k) const { return {x[k], y[k], z[k]}; }
};

/// LobeCoords, the table values there, and the rest of LobeSide, for one direction of every pair.
struct Sides {
  Lanes<float> mu, area, rim, opening, along, across, mixed;
  Lanes<int> entry;                           // of the albedo table: first float of the cell
  Lanes<float> opening_t, along_t, across_t;  // weights within the cell
  Lanes<float> loss, cosine, fuzz_loss;
  Lanes<float> enters_x, enters_y, enters_z, clear;
};

/// Values common to all pairs.
struct Shared {
  formulas::YarnLobes yarn;
  formulas::LobeShared lobes;
  const Table& albedo;
  std::array<float, kMaxFuzzOpenings> fuzz_loss{};  // fuzz_table(.., depth of the yarn).y
  int fuzz_openings = 2;
  float fuzz_mean = 0;  // fuzz_table(.., depth of the yarn).w
};

Shared shared_of(const formulas::YarnLobes& yarn) {
  Shared s{yarn, formulas::lobe_shared(yarn), light_tables().albedo};
  s.fuzz_openings = light_tables().fuzz.nx;
  assert(s.fuzz_openings <= static_cast<int>(kMaxFuzzOpenings));
  if (yarn.fuzz <= 0) return s;
  const float depth = formulas::fuzz_coords(yarn, 1).y;
  for (int i = 0; i < s.fuzz_openings; ++i) {
    const glm::vec4 f = formulas::fuzz_table(static_cast<float>(i) / static_cast<float>(s.fuzz_openings - 1), depth);
    s.fuzz_loss[static_cast<size_t>(i)] = f.y;
    s.fuzz_mean = f.w;
  }
  return s;
}

/// Lanes past the end get the normal.
void load(std::span<const glm::vec3> from, Directions& to) {
  for (size_t k = 0; k < from.size(); ++k) to.x[k] = from[k].x, to.y[k] = from[k].y, to.z[k] = from[k].z;
  for (size_t k = from.size(); k < kBlock; ++k) to.x[k] = to.y[k] = 0, to.z[k] = 1;
}

void find_coords(const Shared& shared, const Directions& w, Sides& s) {
  for (size_t k = 0; k < kBlock; ++k) {
    const formulas::LobeCoords p = formulas::lobe_coords(shared.lobes, w.at(k));
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

inline float between(float a, float b, float t) { return a + t * (b - a); }

/// Trilinear: an entry's four channels and those of the next along the opening, which follow them, are one vector. The
/// loops over channels end in arrays of the whole block, since compilers vectorise what is stored, not what is used.
void look_up_albedo(const Table& t, Sides& s) {
  constexpr size_t kChannels = 4;
  const size_t row = static_cast<size_t>(t.nx) * kChannels, plane = row * static_cast<size_t>(t.ny);
  Lanes<std::array<float, 2 * kChannels>> pairs;  // of entries along the opening
  Lanes<std::array<float, kChannels>> stored;
  for (size_t k = 0; k < kBlock; ++k) {
    const float* p = t.values.data() + s.entry[k];
    const float *q = p + row, *r = p + plane, *u = q + plane;
    const float along = s.along_t[k], across = s.across_t[k], opening = s.opening_t[k];
    auto& pair = pairs[k];
    for (size_t c = 0; c < pair.size(); ++c)
      pair[c] = between(between(p[c], q[c], along), between(r[c], u[c], along), across);
    for (size_t c = 0; c < kChannels; ++c) stored[k][c] = between(pair[c], pair[c + kChannels], opening);
  }
  for (size_t k = 0; k < kBlock; ++k) {
    const auto& [loss, cosine, correlated_loss, correlated_cosine] = stored[k];
    s.loss[k] = between(loss, correlated_loss, s.mixed[k]);
    s.cosine[k] = between(cosine, correlated_cosine, s.mixed[k]);
  }
}

void look_up_fuzz(const Shared& shared, Sides& s) {
  for (size_t k = 0; k < kBlock; ++k) {
    const TableCell cell = cell_of(formulas::fuzz_coords(shared.yarn, s.mu[k]).x, shared.fuzz_openings);
    const float* p = shared.fuzz_loss.data() + cell.i;
    s.fuzz_loss[k] = p[0] + cell.t * (p[1] - p[0]);
  }
}

formulas::LobeSide finished(const formulas::YarnLobes& yarn, const Shared& shared, const Sides& s, size_t k) {
  const formulas::LobeCoords p{s.mu[k], s.area[k], s.rim[k], s.opening[k], s.along[k], s.across[k], s.mixed[k]};
  // Reflection needs only the loss of the fuzz and its mean.
  return formulas::lobe_finish(yarn, shared.lobes, p, {s.loss[k], s.cosine[k]},
                               {0, s.fuzz_loss[k], 0, shared.fuzz_mean});
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
  bare.fuzz = 0;  // known to the compiler: this loop has no fuzz
  Directions in, seen, f;
  Sides i, o;
  i.fuzz_loss.fill(0), o.fuzz_loss.fill(0);
  for (size_t first = 0; first < out.size(); first += kBlock) {
    const size_t count = std::min(kBlock, out.size() - first);
    load(wi.subspan(first, count), in);
    load(wo.subspan(first, count), seen);
    find_coords(shared, in, i);
    find_coords(shared, seen, o);
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

}  // namespace

void reflect(const formulas::YarnLobes& yarn, std::span<const glm::vec3> wi, std::span<const glm::vec3> wo,
             std::span<glm::vec3> out, Vectors vectors) {
  assert(wi.size() == wo.size() && wi.size() == out.size());
  const Shared shared = shared_of(yarn);
  platform::with_vectors(vectors, [&] { reflect_all(shared, wi, wo, out); });
}

}  // namespace weftlight::light
