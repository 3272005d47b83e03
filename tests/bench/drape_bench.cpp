#include <benchmark/benchmark.h>

#include "drape/mesh.h"

namespace weftlight::drape {
namespace {

/// One simulated second of the four of the tablecloth, with setup: 10,201 particles, 1,920 substeps.
void tablecloth_second(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(simulate_drape("tablecloth", 0.25f));
}
BENCHMARK(tablecloth_second)->Unit(benchmark::kMillisecond)->Iterations(1);

void frames(benchmark::State& state) {
  Mesh mesh = simulate_drape("tablecloth", 0.002f);
  for (auto _ : state) compute_frames(mesh);
}
BENCHMARK(frames)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weftlight::drape
