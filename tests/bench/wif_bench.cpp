// Reading and saving a WIF of about 130 KB, the size of a long draft with all rows; and files with very many sections
// or yarns.

#include <benchmark/benchmark.h>

#include "design/edits.h"
#include "wif/wif.h"

namespace weftlight::wif {

using design::Design, design::with_threading;
using draft::blank_draft;

namespace {

/// 2,600 ends and picks on 16 shafts, with all rows listed.
std::string long_draft() {
  constexpr int kThreads = 2600, kShafts = 16;
  Design design;
  design.title = "A long draft";
  design.draft = blank_draft(kThreads, kThreads, kShafts, kShafts);
  design.draft.palette.push_back({0.5f, 0.25f, 0.125f});
  for (int i = 0; i < kThreads; ++i) {
    design.draft.threading.set(i, (i * 5 + i / 40) % kShafts, true);
    design.draft.treadling.set(i, (i * 3 + i / 25) % kShafts, true);
    design.draft.warp.color[static_cast<size_t>(i)] = i % 3;
    design.draft.weft.color[static_cast<size_t>(i)] = (i / 7) % 3;
    design.draft.warp.spacing_mm[static_cast<size_t>(i)] = 1.0f + 0.25f * static_cast<float>(i % 5);
  }
  for (int t = 0; t < kShafts; ++t) {
    for (int s = 0; s < kShafts; ++s) design.draft.tieup.set(t, s, (t + s) % 4 < 2);
  }
  return write_new_wif(design);
}

void read_130_kb(benchmark::State& state) {
  const std::string bytes = long_draft();
  for (auto _ : state) benchmark::DoNotOptimize(read_wif(bytes));
  state.SetBytesProcessed(state.iterations() * static_cast<int64_t>(bytes.size()));
  state.SetLabel(std::to_string(bytes.size() / 1024) + " KB");
}
BENCHMARK(read_130_kb)->Unit(benchmark::kMillisecond);

std::string small_draft() {
  Design design;
  design.draft = blank_draft(4, 4, 4, 4);
  return write_new_wif(design);
}

/// Unrealistic files that must still be read in linear time.
void read_sections(benchmark::State& state) {
  std::string bytes = small_draft();
  for (int64_t i = 0; i < state.range(0); ++i) bytes += "[PRIVATE X " + std::to_string(i) + "]\r\nA=1\r\n";
  for (auto _ : state) benchmark::DoNotOptimize(read_wif(bytes));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(read_sections)->RangeMultiplier(4)->Range(1000, 64000)->Complexity()->Unit(benchmark::kMillisecond);

void read_yarns(benchmark::State& state) {
  std::string bytes = small_draft();
  bytes += "[PRIVATE WEFTLIGHT YARNS]\r\nYarns=" + std::to_string(state.range(0)) + "\r\n";
  for (int64_t i = 1; i <= state.range(0); ++i) bytes += std::to_string(i) + " Name=Y\r\n";
  for (auto _ : state) benchmark::DoNotOptimize(read_wif(bytes));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(read_yarns)->RangeMultiplier(4)->Range(64, 4096)->Complexity()->Unit(benchmark::kMillisecond);

void save_after_one_edit(benchmark::State& state) {
  const WifRead read = read_wif(long_draft());
  const Design now = with_threading(read.file->design, 1000, 3, true);
  for (auto _ : state) benchmark::DoNotOptimize(write_wif(*read.file, now));
}
BENCHMARK(save_after_one_edit)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weftlight::wif
