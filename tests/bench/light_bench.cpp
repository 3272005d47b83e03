// Speed of tables, cube maps and evaluations of the lobes. VRST 2003 reports 140 s for BRDF and cube maps.

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "../unit/light/seed_brdfs.h"
#include "light/cloth_brdf.h"
#include "light/measure_response.h"
#include "light/separable.h"
#include "light/tables.h"
#include "light/yarn_lobes.h"

namespace weftlight::light {

using cloth::Cloth, cloth::Maps, cloth::Period, cloth::bake, cloth::lay_out;
using design::Design, design::Lobes;
using draft::BitMatrix, draft::Face, draft::blank_draft;

namespace {

void light_tables_of_all_cloths(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(make_light_tables());
}
BENCHMARK(light_tables_of_all_cloths)->Unit(benchmark::kMillisecond)->UseRealTime();

void brdf_tables_of_a_cloth(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(make_cloth_brdf(0.5f, 0.5f, 0.3f, 0.6f, {1, 0.2f, 0.1f}, {0.1f, 0.2f, 1}));
}
BENCHMARK(brdf_tables_of_a_cloth)->Unit(benchmark::kMillisecond);

/// The data of methods `cloth` and `repeat` for one face of a 2/2 twill.
void far_field_of(benchmark::State& state) {
  Design design;
  design.draft = blank_draft(4, 4, 4, 4);
  BitMatrix cells(4, 4);
  for (int p = 0; p < 4; ++p)
    for (int e = 0; e < 4; ++e) cells.set(p, e, (e + p) % 4 < 2);
  const Cloth cloth = lay_out(design, cells, Face::kFront, Period::kRepeat);
  const Maps maps = bake(cloth, {256, 256, 16, 0});
  for (auto _ : state) benchmark::DoNotOptimize(measure_response(cloth, maps));
}
BENCHMARK(far_field_of)->Unit(benchmark::kMillisecond)->UseRealTime();

void separable_cube_maps(benchmark::State& state) {
  const ClothBrdf brdf = preset_cloth_brdf("satin", {1, 0.2f, 0.1f}, {0.1f, 0.2f, 1});
  for (auto _ : state) benchmark::DoNotOptimize(factorise(brdf, Split::kHalfDifference));
}
BENCHMARK(separable_cube_maps)->Unit(benchmark::kMillisecond)->UseRealTime();

std::vector<glm::vec3> directions(int count, unsigned seed) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<float> u(0, 1);
  std::vector<glm::vec3> all;
  for (int k = 0; k < count; ++k) {
    const float z = 0.01f + 0.99f * u(rng), phi = 6.2831853f * u(rng), s = std::sqrt(1 - z * z);
    all.emplace_back(s * std::cos(phi), s * std::sin(phi), z);
  }
  return all;
}

/// Cotton with fuzz, evaluated one by one as in a shader; values that depend only on the directions are computed once.
void yarn_evaluations_one_by_one(benchmark::State& state) {
  const auto yarn = yarn_lobes(Lobes{}, {0.6f, 0.3f, 0.1f});
  const auto shared = formulas::lobe_shared(yarn);
  const std::vector<glm::vec3> wi = directions(4096, 1), wo = directions(4096, 2);
  for (auto _ : state)
    for (size_t k = 0; k < wi.size(); ++k)
      benchmark::DoNotOptimize(formulas::lobe_reflect(yarn, shared, formulas::lobe_side(yarn, shared, wi[k]),
                                                      formulas::lobe_side(yarn, shared, wo[k]), wi[k], wo[k]));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(wi.size()));
}
BENCHMARK(yarn_evaluations_one_by_one);

void yarn_evaluations(benchmark::State& state, bool fuzz, Vectors vectors) {
  Lobes lobes;
  if (!fuzz) lobes.fuzz = 0;
  const auto yarn = yarn_lobes(lobes, {0.6f, 0.3f, 0.1f});
  if (vectors > widest_vectors()) return state.SkipWithError("this processor has no AVX2");
  const std::vector<glm::vec3> wi = directions(4096, 1), wo = directions(4096, 2);
  std::vector<glm::vec3> out(wi.size());
  for (auto _ : state) {
    reflect(yarn, wi, wo, out, vectors);
    benchmark::DoNotOptimize(out.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(wi.size()));
}
BENCHMARK_CAPTURE(yarn_evaluations, cotton_baseline, true, Vectors::kBaseline);
BENCHMARK_CAPTURE(yarn_evaluations, cotton_avx2, true, Vectors::kAvx2);
BENCHMARK_CAPTURE(yarn_evaluations, bare_avx2, false, Vectors::kAvx2);

void seed_paper_evaluations(benchmark::State& state) {
  const ClothBrdf brdf = preset_cloth_brdf("satin", {1, 0.2f, 0.1f}, {0.1f, 0.2f, 1});
  const std::vector<glm::vec3> wi = directions(4096, 1), wo = directions(4096, 2);
  for (auto _ : state)
    for (size_t k = 0; k < wi.size(); ++k) benchmark::DoNotOptimize(evaluate(brdf, wi[k], wo[k]));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(wi.size()));
}
BENCHMARK(seed_paper_evaluations);

}  // namespace
}  // namespace weftlight::light
