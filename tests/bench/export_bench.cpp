// The cost of the parts of an export at 1024^2.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "cloth/cloth.h"
#include "files/files.h"
#include "texture_set/texture_set.h"
#include "weaves/weaves.h"

namespace weftlight::texture_set {

using base::problem_of;
using cloth::Cloth, cloth::Maps, cloth::Period, cloth::bake, cloth::lay_out;
using design::Design;
using draft::Face, draft::drawdown;
using drape::Mesh, drape::simulate_drape;
using files::Image, files::PixelType, files::read_mesh, files::write_image, files::write_mesh;
using weaves::Lean, weaves::twill;

namespace {

Cloth sample_cloth() {
  const Design design = twill({2, 2}, Lean::kRight, {16, 16});
  return lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
}

Image sample_image(int channels) {
  Image image{1024, 1024, channels, std::vector<float>(size_t{1024} * 1024 * static_cast<size_t>(channels))};
  for (size_t i = 0; i < image.texels.size(); ++i)
    image.texels[i] = static_cast<float>((i * 2654435761u) >> 24 & 63) / 255.0f;
  return image;
}

std::string scratch(const char* name) { return (std::filesystem::temp_directory_path() / name).string(); }

void SurfaceFromMaps(benchmark::State& state) {
  const Cloth cloth = sample_cloth();
  const Maps maps = bake(cloth, {2048, 2048, 0});
  for (auto _ : state) benchmark::DoNotOptimize(make_surface(cloth, maps, 1024, 1024));
}
BENCHMARK(SurfaceFromMaps)->Unit(benchmark::kMillisecond);

void PackOrm(benchmark::State& state) {
  const Cloth cloth = sample_cloth();
  const SurfaceTexels surface = make_surface(cloth, bake(cloth, {1024, 1024, 0}), 1024, 1024);
  for (auto _ : state) benchmark::DoNotOptimize(pack(targets::kGltf.images[1], surface));
}
BENCHMARK(PackOrm)->Unit(benchmark::kMillisecond);

void WritePng8(benchmark::State& state) {
  const Image image = sample_image(4);
  for (auto _ : state) benchmark::DoNotOptimize(write_image(scratch("weftlight_bench.png"), image, PixelType::kU8));
}
BENCHMARK(WritePng8)->Unit(benchmark::kMillisecond);

void WriteExrHalf(benchmark::State& state) {
  const Image image = sample_image(4);
  for (auto _ : state) benchmark::DoNotOptimize(write_image(scratch("weftlight_bench.exr"), image, PixelType::kHalf));
}
BENCHMARK(WriteExrHalf)->Unit(benchmark::kMillisecond);

void WholeSet(benchmark::State& state, const ExportTarget* target) {
  const Design design = twill({2, 2}, Lean::kRight, {16, 16});
  const Mesh mesh = simulate_drape("plane");
  const std::string folder = scratch("weftlight_bench_set");
  TextureSetOptions options;
  options.target = target, options.name = "bench", options.source = "bench.wif";
  for (auto _ : state) {
    benchmark::DoNotOptimize(write_texture_set(folder, design, mesh, options));
  }
  std::filesystem::remove_all(folder);
}
BENCHMARK_CAPTURE(WholeSet, gltf, &targets::kGltf)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(WholeSet, raw, &targets::kRaw)->Unit(benchmark::kMillisecond);

void ReadMeshFile(benchmark::State& state) {
  const std::string path = scratch("weftlight_bench.glb");
  const std::string problem = problem_of(write_mesh(path, simulate_drape("plane"), nullptr));
  if (!problem.empty()) state.SkipWithError(problem.c_str());
  for (auto _ : state) benchmark::DoNotOptimize(read_mesh(path));
}
BENCHMARK(ReadMeshFile)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace weftlight::texture_set
