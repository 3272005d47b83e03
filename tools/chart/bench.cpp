#include "chart/bench.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <thread>

#include "base/hash.h"
#include "base/text.h"
#include "base/version.h"
#include "base/whole_files.h"
#include "chart/charted_methods.h"
#include "chart/flip.h"
#include "draft/drawdown.h"
#include "files/files.h"
#include "gl/open_headless.h"
#include "gl/shader_program.h"
#include "light/formulas.h"
#include "platform/clock.h"
#include "render_data/face_cloth.h"
#include "render_data/method_weights.h"
#include "render_data/shipped_lod_table.h"
#include "render_data/stages.h"
#include "scene/light_rig.h"
#include "wif/other_formats.h"

namespace weftlight::chart {

using base::arg, base::fill, base::message, base::presets_dir, base::read_file, base::shaders_dir, base::tr;
using cloth::lay_out;
using design::Design;
using draft::BitMatrix, draft::Face, draft::drawdown;
using reference::Colours, reference::FlatPicture, reference::TubeOptions, reference::trace_flat;
using render_data::HalfCrossing, render_data::PackedFace, render_data::PackedTexture, render_data::StageResult,
    render_data::Stages, render_data::choose_period, render_data::shipped_lod_table;
using scene::kKeyIrradiance, scene::kKeyRadius;
using wif::WifRead, wif::read_draft;

namespace {

constexpr glm::vec3 kIrradiance{kKeyIrradiance};
constexpr glm::vec2 kCorner{0.37f, 0.61f};  // mm; pixels do not align with threads
constexpr int kTile = 1024;                 // pixels along a side of a tile of a supersampled picture

size_t scene_of(const ChartRow& cell) { return scene_named(cell.scene); }

double textures(const PackedFace& face, unsigned read) {
  double bytes = 0;
  for (const PackedTexture& texture : face.textures) {
    if ((read & reads(texture.kind)) == 0) continue;
    for (const std::vector<uint8_t>& level : texture.levels) bytes += static_cast<double>(level.size());
  }
  return bytes;
}

FlatPicture flat_picture(double view_deg, glm::vec2 corner, const PixelSteps& steps, int pixels, int rays,
                         uint64_t seed) {
  FlatPicture picture;
  picture.width = picture.height = pixels;
  picture.spp = std::max(4, rays / (pixels * pixels));
  picture.corner_mm = corner, picture.step_x_mm = steps.x, picture.step_y_mm = steps.y;
  picture.view = chart_view(view_deg);
  picture.around.light_towards = chart_light();
  picture.around.light_radius_rad = std::asin(kKeyRadius);
  picture.around.light_irradiance = kIrradiance;
  picture.seed = seed;
  picture.bounces = 2, picture.colours = Colours::kOfTheCloth;
  picture.fibre_detail = true;
  return picture;
}

}  // namespace

Pixels colours(const Image& image) {
  Pixels pixels;
  pixels.reserve(image.texels.size() / 4);
  for (size_t i = 0; i + 3 < image.texels.size(); i += 4)
    pixels.emplace_back(image.texels[i], image.texels[i + 1], image.texels[i + 2]);
  return pixels;
}

Pixels colours(const TracedImage& image) {
  Pixels pixels;
  pixels.reserve(image.pixels.size());
  for (const glm::vec4& p : image.pixels) pixels.emplace_back(p);
  return pixels;
}

glm::vec2 chart_corner() { return kCorner; }

double cores() { return std::max(1u, std::thread::hardware_concurrency()); }

size_t scene_named(const std::string& name) {
  for (size_t i = 0; i < kChartScenes.size(); ++i) {
    if (name == kChartScenes[i].name) return i;
  }
  return 0;
}

Pixels mean_of(const Truth& truth) {
  Pixels mean = truth.half;
  for (size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5f * (mean[i] + truth.other_half[i]);
  return mean;
}

double method_bytes(const PackedCloth& cloth, Method method) {
  const unsigned read = chart_method(method).reads;
  double bytes = textures(cloth.front, read) + textures(cloth.back, read);
  const auto floats = [](const auto& v) { return static_cast<double>(v.size() * sizeof(float)); };
  if (read & kReadsCubes) bytes += 2 * (floats(cloth.front.half_cube) + floats(cloth.front.difference_cube));
  if (read & kReadsLobes) bytes += static_cast<double>(sizeof cloth.lobes.data + cloth.lobes.response.bytes());
  if (read & kReadsThreads) {
    bytes += static_cast<double>(cloth.crossings.size() * sizeof(HalfCrossing) +
                                 cloth.lobes.threads.size() * sizeof(glm::uvec4));
  }
  return bytes;
}

base::Result<std::unique_ptr<ChartBench>> ChartBench::create(const ChartEffort& effort,
                                                             std::unique_ptr<DrawCounter> counter) {
  std::unique_ptr<ChartBench> bench(new ChartBench);
  bench->effort_ = effort;
  bench->counter_ = std::move(counter);
  const auto none = [](const base::Error& why) {
    return base::failure(base::ErrorKind::kGraphics, fill(tr("no graphics: {problem}"), arg("problem", message(why))));
  };
  auto context = gl::open_headless();
  if (!context) return none(context.error());
  bench->context_ = std::move(*context);
  auto renderer = Renderer::create();
  if (!renderer) return none(renderer.error());
  bench->renderer_ = std::move(*renderer);
  bench->lod_table_ = shipped_lod_table().lod_table;
  bench->renderer_->set_lod_table(bench->lod_table_);
  return bench;
}

std::string ChartBench::fingerprint() const {
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(shaders_dir(), ignored)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::string text;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    text += std::string(std::istreambuf_iterator<char>(in), {});
  }
  std::ostringstream out;
  out << "weftlight " << base::version() << "\nshaders " << std::hex << base::content_hash(text) << std::dec
      << "\ndevice " << renderer_->device() << "\nbudget " << effort_.fine_budget << " x " << effort_.fine_samples
      << '\n';
  return out.str();
}

base::Result<ChartBench::Loaded*> ChartBench::load(size_t scene) {
  std::unique_ptr<Loaded>& slot = loaded_[scene];
  if (slot) return slot.get();
  const WifRead read = read_draft(read_file(presets_dir() + "/drafts/" + kChartScenes[scene].preset).value_or(""));
  if (!read.file)
    return base::failure(base::ErrorKind::kInput, tr("the preset cannot be read"), kChartScenes[scene].preset);
  auto made = std::make_unique<Loaded>();
  Design design = in_scene_colours(read.file->design, kChartScenes[scene]);
  design.look.method = Method::kVrst03;  // the only method with maps of its own
  design.scene = drape_scene(ChartLight::kKey);
  Stages stages;
  StageResult result = stages.update(std::make_shared<const Design>(design));
  if (result.mesh) made->mesh = std::move(*result.mesh);
  made->packed = stages.packed();
  const BitMatrix cells = drawdown(design.draft);
  made->cloth = lay_out(design, cells, Face::kFront, choose_period(design, cells));
  slot = std::move(made);
  return slot.get();
}

base::Result<const TubeScene*> ChartBench::tubes(Loaded& loaded) {
  if (loaded.tubes) return loaded.tubes.get();
  TubeOptions options;
  options.around = effort_.tube_facets;
  auto built = TubeScene::build(loaded.cloth, options);
  if (!built) return failed(built);
  loaded.tubes = std::move(*built);
  return loaded.tubes.get();
}

base::Result<ChartBench::Loaded*> ChartBench::show(size_t scene) {
  base::Result<Loaded*> loaded = load(scene);
  if (!loaded) return loaded;
  if (shown_ != scene) renderer_->upload((*loaded)->packed);
  shown_ = scene;
  return loaded;
}

FlatPicture ChartBench::traced_patch(double view_deg, const PixelSteps& steps, int pixels, uint64_t seed) const {
  return flat_picture(view_deg, kCorner, steps, pixels, effort_.truth_budget, seed);
}

FlatPatch ChartBench::patch_of(double view_deg, glm::vec2 corner, const PixelSteps& steps, int width, int height,
                               int samples) const {
  FlatPatch patch;
  patch.samples = samples;
  patch.width = width, patch.height = height;
  patch.corner_mm = corner, patch.step_x_mm = steps.x, patch.step_y_mm = steps.y;
  patch.view = chart_view(view_deg);
  patch.light_towards = chart_light();
  patch.light_sine = kKeyRadius;
  patch.light_irradiance = kIrradiance;
  return patch;
}

Pixels ChartBench::draw(Method method, double view_deg, glm::vec2 corner, const PixelSteps& steps, int width,
                        int height, int samples) {
  Look look;
  look.method = method;
  renderer_->draw_patch(patch_of(view_deg, corner, steps, width, height, samples), look);
  return colours(renderer_->read_patch());
}

PixelSteps ChartBench::pixel_of(const ChartRow& cell) const {
  const double spacing = static_cast<double>(loaded_[scene_of(cell)]->packed.mean_spacing_mm);
  return pixel_steps(cell.view_deg, cell.yarns_per_pixel * spacing);
}

base::Result<void> ChartBench::draw_counted(const CountedDraw& what, const LodTable& lod_table, int pixels) {
  if (const auto shown = show(what.scene); !shown) return failed(shown);
  renderer_->set_lod_table(lod_table);
  ChartRow cell;
  cell.scene = kChartScenes[what.scene].name, cell.view_deg = what.view_deg;
  cell.yarns_per_pixel = what.yarns_per_pixel;
  Look look;
  look.method = what.method;
  renderer_->draw_patch(patch_of(what.view_deg, kCorner, pixel_of(cell), pixels, pixels, what.samples), look);
  return {};
}

base::Result<std::vector<Method>> ChartBench::methods() {
  if (const auto shown = show(0); !shown) return failed(shown);
  std::vector<Method> offered;
  for (const ChartMethod& m : kChartMethods) {
    draw(m.method, 0, kCorner, pixel_steps(0, 1), 4, 4);
    if (renderer_->measure().method == m.method) offered.push_back(m.method);
  }
  return offered;
}

base::Result<const Truth*> ChartBench::truth(const ChartRow& cell) {
  const base::Result<Loaded*> loaded = load(scene_of(cell));
  if (!loaded) return failed(loaded);
  Truth& truth = (*loaded)->truths[{cell.view_deg, cell.yarns_per_pixel}];
  if (!truth.half.empty()) return &truth;
  const int pixels = patch_pixels(cell.yarns_per_pixel, effort_);
  const base::Result<const TubeScene*> traced = tubes(**loaded);
  if (!traced) return failed(traced);
  for (const uint64_t seed : {1u, 2u}) {
    const FlatPicture picture = traced_patch(cell.view_deg, pixel_of(cell), pixels, seed);
    (seed == 1 ? truth.half : truth.other_half) = colours(trace_flat(**traced, picture, {}));
  }
  return &truth;
}

base::Result<double> ChartBench::truth_noise(const ChartRow& cell) {
  return truth(cell).map([](const Truth* known) { return noise_of(known->half, known->other_half); });
}

/// Averages at least a thousand finer pixels for each pixel.
Pixels ChartBench::supersampled(const ChartRow& cell, const FineGrid& grid, const PixelSteps& pixel) {
  const PixelSteps fine{pixel.x / static_cast<float>(grid.nx), pixel.y / static_cast<float>(grid.ny)};
  const int across = std::clamp(kTile / grid.nx, 1, grid.pixels), down = std::clamp(kTile / grid.ny, 1, grid.pixels);
  Pixels all(static_cast<size_t>(grid.pixels) * static_cast<size_t>(grid.pixels));
  for (int y = 0; y < grid.pixels; y += down) {
    for (int x = 0; x < grid.pixels; x += across) {
      const int w = std::min(across, grid.pixels - x), h = std::min(down, grid.pixels - y);
      const glm::vec2 corner = kCorner + static_cast<float>(x) * pixel.x + static_cast<float>(y) * pixel.y;
      const Pixels tile =
          box_average(draw(cell.method, cell.view_deg, corner, fine, w * grid.nx, h * grid.ny, effort_.fine_samples),
                      w * grid.nx, h * grid.ny, grid.nx, grid.ny);
      for (int row = 0; row < h; ++row) {
        std::copy_n(tile.begin() + row * w, w, all.begin() + (y + row) * grid.pixels + x);
      }
    }
  }
  return all;
}

double ChartBench::filtering_error(const ChartRow& cell, const PixelSteps& pixel) {
  const FineGrid grid = fine_grid(cell.view_deg, cell.yarns_per_pixel, effort_);
  // For method yarn the reference does not depend on the number of samples.
  Pixels own;
  Pixels& truth =
      cell.method == Method::kYarn ? loaded_[scene_of(cell)]->fine[{cell.view_deg, cell.yarns_per_pixel}] : own;
  if (truth.empty()) truth = supersampled(cell, grid, pixel);
  return relative_rmse(draw(cell.method, cell.view_deg, kCorner, pixel, grid.pixels, grid.pixels, cell.samples), truth);
}

double ChartBench::flicker(const ChartRow& cell, const PixelSteps& pixel) {
  const int size = patch_pixels(cell.yarns_per_pixel, effort_);
  std::vector<Pixels> pans;
  for (int k = 0; k < effort_.pans; ++k) {
    const float part = static_cast<float>(k) / static_cast<float>(effort_.pans);
    pans.push_back(draw(cell.method, cell.view_deg, kCorner + part * pixel.x, pixel, size, size, cell.samples));
  }
  return flicker_of(pans);
}

/// Nanoseconds of a draw: on a graphics card by its timer; for a software renderer the processor time divided by the
/// number of cores, which excludes other processes.
double ChartBench::patch_ns(const FlatPatch& patch, const Look& look) {
  const double before = platform::processor_ns();
  renderer_->draw_patch(patch, look);
  const FrameStats stats = renderer_->measure();
  if (!renderer_->is_software()) return stats.gpu_ms * 1e6;
  return (platform::processor_ns() - before) / cores();
}

int ChartBench::timing_size(Method method) const {
  if (renderer_->is_software()) return method == Method::kYarn ? effort_.yarn_timing_size : effort_.timing_size;
  return method == Method::kYarn ? effort_.card_yarn_timing_size : effort_.card_timing_size;
}

double ChartBench::nanoseconds(const ChartRow& cell, const PixelSteps& pixel) {
  const int size = timing_size(cell.method);
  const FlatPatch patch = patch_of(cell.view_deg, kCorner, pixel, size, size, cell.samples);
  Look look;
  look.method = cell.method;
  patch_ns(patch, look);  // compiles the programs
  std::vector<double> times;
  double spent = 0;
  for (int k = 0; k < effort_.timing_repeats && spent < effort_.timing_enough_ns; ++k) {
    const double ns = patch_ns(patch, look);
    times.push_back(ns / (static_cast<double>(size) * size));
    spent += ns;
  }
  // The minimum, since other load on the machine only adds time.
  return *std::min_element(times.begin(), times.end());
}

base::Result<double> ChartBench::frame_ms(size_t scene, const Look& look, double yarns_per_pixel,
                                          std::array<int, 2> size) {
  if (const auto shown = show(scene); !shown) return failed(shown);
  const bool whole = !renderer_->is_software();
  const double pixels = static_cast<double>(size[0]) * size[1];
  double& known = frame_ns_[{scene, look.method, look.tolerance, yarns_per_pixel}];  // per pixel
  if (!whole && known > 0) return known * pixels * 1e-6;
  const int width = whole ? size[0] : effort_.frame_size, height = whole ? size[1] : effort_.frame_size;
  const PixelSteps steps =
      pixel_steps(0, yarns_per_pixel * static_cast<double>(loaded_[scene]->packed.mean_spacing_mm));
  const FlatPatch patch = patch_of(0, kCorner, steps, width, height, 0);
  patch_ns(patch, look);
  known = std::min(patch_ns(patch, look), patch_ns(patch, look)) / (static_cast<double>(width) * height);
  return known * pixels * 1e-6;
}

base::Result<LightRow> ChartBench::measure_under(ChartLight light, const ChartRow& cell) {
  const base::Result<Loaded*> shown = show(scene_of(cell));
  if (!shown) return failed(shown);
  const base::Result<const TubeScene*> traced = tubes(**shown);
  if (!traced) return failed(traced);
  const PixelSteps pixel = pixel_of(cell);
  const int size = patch_pixels(cell.yarns_per_pixel, effort_);
  FlatPatch patch = patch_of(cell.view_deg, kCorner, pixel, size, size, cell.samples);
  if (light == ChartLight::kBehind) patch.light_towards.z *= -1;
  if (light == ChartLight::kSky) patch.light_irradiance = glm::vec3(0), patch.sky = 1;
  Truth truth;
  for (const uint64_t seed : {1u, 2u}) {
    FlatPicture picture = traced_patch(cell.view_deg, pixel, size, seed);
    picture.around.light_towards = patch.light_towards, picture.around.light_irradiance = patch.light_irradiance;
    if (light == ChartLight::kSky) picture.around.sky = [](glm::vec3 d) { return glm::vec3(0.5f + 0.5f * d.z); };
    (seed == 1 ? truth.half : truth.other_half) = colours(trace_flat(**traced, picture, {}));
  }
  Look look;
  look.method = cell.method;
  renderer_->draw_patch(patch, look);
  const Pixels drawn = colours(renderer_->read_patch());
  LightRow row{cell, light};
  row.cell.model_error = relative_rmse(drawn, truth.half, truth.other_half);
  row.cell.energy_ratio = 0.5 * (mean_ratio(drawn, truth.half) + mean_ratio(drawn, truth.other_half));
  return row;
}

/// 0 if they cannot be counted.
double ChartBench::instructions(const ChartRow& cell) {
  if (!counter_) return 0;
  CountedDraw what{scene_of(cell), cell.view_deg, cell.yarns_per_pixel, cell.method, cell.samples};
  // Single steps are slow, so the cost of many samples is extrapolated linearly from that of a few.
  constexpr int kFew = 3;
  const auto count = [&](int samples) {
    what.samples = samples;
    const auto [at, fresh] =
        counted_.try_emplace({what.scene, what.view_deg, what.yarns_per_pixel, what.method, samples}, 0.0);
    if (fresh) at->second = counter_->per_pixel(what, lod_table_).value_or(0);
    return at->second;
  };
  if (cell.samples <= kFew) return count(cell.samples);
  const double one = count(1), few = count(kFew);
  return one + (few - one) / (kFew - 1) * (cell.samples - 1);
}

base::Result<ChartRow> ChartBench::measure(const ChartRow& cell) {
  const base::Result<Loaded*> shown = show(scene_of(cell));
  if (!shown) return failed(shown);
  const base::Result<const Truth*> traced = truth(cell);
  if (!traced) return failed(traced);
  const Truth& known = **traced;
  const PixelSteps pixel = pixel_of(cell);
  const int size = patch_pixels(cell.yarns_per_pixel, effort_);
  const Pixels drawn = draw(cell.method, cell.view_deg, kCorner, pixel, size, size, cell.samples);
  ChartRow row = cell;
  row.model_error = relative_rmse(drawn, known.half, known.other_half);
  row.energy_ratio = 0.5 * (mean_ratio(drawn, known.half) + mean_ratio(drawn, known.other_half));
  row.flip = flip_error(drawn, mean_of(known), size, size);
  row.filtering_error = filtering_error(cell, pixel);
  row.flicker = flicker(cell, pixel);
  row.ns_per_pixel = nanoseconds(cell, pixel);
  row.instructions_per_pixel = instructions(cell);
  row.bytes = method_bytes((*shown)->packed, cell.method);
  return as_written(row);
}

base::Result<double> ChartBench::brightness(size_t scene, double view_deg, std::optional<Method> method) {
  const base::Result<Loaded*> shown = show(scene);
  if (!shown) return failed(shown);
  constexpr int kPixels = 16;
  constexpr double kYarns = 4;  // per pixel, so that the patch contains whole repeats
  Loaded& loaded = **shown;
  const PixelSteps steps = pixel_steps(view_deg, kYarns * static_cast<double>(loaded.packed.mean_spacing_mm));
  const double white = static_cast<double>(kIrradiance.x * chart_light().z) / 3.141592653589793;
  if (method) return mean_value(draw(*method, view_deg, kCorner, steps, kPixels, kPixels)) / white;
  const base::Result<const TubeScene*> traced = tubes(loaded);
  if (!traced) return failed(traced);
  return mean_value(colours(trace_flat(**traced, traced_patch(view_deg, steps, kPixels, 3), {}))) / white;
}

}  // namespace weftlight::chart
