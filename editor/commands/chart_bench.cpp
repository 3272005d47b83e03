#include "commands/chart_bench.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>

#include "commands/chart_instructions.h"
#include "commands/commands.h"
#include "draft/drawdown.h"
#include "files/files.h"
#include "gl/shader_program.h"
#include "light/formulas.h"
#include "upload/light_rig.h"
#include "upload/rung_shares.h"
#include "upload/shipped_ladder.h"
#include "upload/stages.h"

namespace weftlight::commands {
namespace {

constexpr glm::vec3 kIrradiance{kKeyIrradiance};
constexpr glm::vec2 kCorner{0.37f, 0.61f};  // mm: no pixel begins where a thread does
constexpr int kTile = 1024;                 // of a finer picture

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

size_t scene_of(const ChartRow& cell) {
  for (size_t i = 0; i < kChartScenes.size(); ++i) {
    if (cell.scene == kChartScenes[i].name) return i;
  }
  return 0;
}

double textures(const PackedFace& face, const std::vector<PackedKind>& kinds) {
  double bytes = 0;
  for (const PackedKind kind : kinds) {
    for (const std::vector<uint8_t>& level : face.textures[static_cast<size_t>(kind)].levels)
      bytes += static_cast<double>(level.size());
  }
  return bytes;
}

std::vector<PackedKind> kinds_of(Method method) {
  switch (method) {
    case Method::kFlat:
      return {PackedKind::kColor};
    case Method::kVrst03:
      return {PackedKind::kColor, PackedKind::kShadow};
    case Method::kCloth:
      return {};
    case Method::kRepeat:
      return {PackedKind::kColor, PackedKind::kRelief};
    case Method::kCell:
    case Method::kEngine:
      return {PackedKind::kColor, PackedKind::kRelief, PackedKind::kHorizon};
    case Method::kYarn:
      return {PackedKind::kHorizon};  // the sky's share
    default:
      return {PackedKind::kColor, PackedKind::kRelief, PackedKind::kHorizon};
  }
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
  return picture;
}

}  // namespace

double method_bytes(const PackedCloth& cloth, Method method) {
  const std::vector<PackedKind> kinds = kinds_of(method);
  double bytes = textures(cloth.front, kinds) + textures(cloth.back, kinds);
  const auto floats = [](const auto& v) { return static_cast<double>(v.size() * sizeof(float)); };
  if (method == Method::kVrst03) {
    bytes += 2 * (floats(cloth.front.half_cube) + floats(cloth.front.difference_cube));
  } else if (method != Method::kFlat) {
    bytes += static_cast<double>(sizeof cloth.lobes.data + cloth.lobes.response.bytes());
  }
  if (method == Method::kYarn || method == Method::kAuto) {
    bytes += static_cast<double>(cloth.crossings.size() * sizeof(HalfCrossing) +
                                 cloth.lobes.threads.size() * sizeof(glm::uvec4));
  }
  return bytes;
}

std::unique_ptr<ChartBench> ChartBench::create(const ChartEffort& effort, int& code, std::string& error) {
  std::unique_ptr<ChartBench> bench(new ChartBench);
  bench->effort_ = effort;
  bench->context_ = HeadlessContext::create(error);
  if (bench->context_) bench->renderer_ = Renderer::create(error);
  if (!bench->renderer_) {
    code = kNoGraphics, error = "no graphics: " + error;
    return nullptr;
  }
  bench->use_ladder(shipped_ladder().ladder);
  return bench;
}

void ChartBench::use_ladder(const Ladder& ladder) {
  ladder_ = ladder;
  renderer_->set_ladder(ladder);
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
  uint64_t hash = 1469598103934665603u;  // FNV-1a
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  std::ostringstream out;
  out << "weftlight " << WEFTLIGHT_VERSION << "\nshaders " << std::hex << hash << std::dec << "\ndevice "
      << renderer_->device() << "\nbudget " << effort_.fine_budget << " x " << effort_.fine_samples << '\n';
  return out.str();
}

ChartBench::Loaded* ChartBench::load(size_t scene, std::string& error) {
  std::unique_ptr<Loaded>& slot = loaded_[scene];
  if (slot) return slot.get();
  OpenedDesign opened = open_design(presets_dir() + "/drafts/" + kChartScenes[scene].preset);
  if (!opened.ok) {
    error = std::string(kChartScenes[scene].preset) + ": the preset cannot be read";
    return nullptr;
  }
  auto made = std::make_unique<Loaded>();
  opened.design.look.method = Method::kVrst03;  // the only one that asks for maps of its own
  Stages stages;
  stages.update(std::make_shared<const Design>(opened.design));
  made->packed = stages.packed();
  const BitMatrix cells = drawdown(opened.design.draft);
  made->cloth = lay_out(opened.design, cells, Face::kFront, choose_period(opened.design, cells));
  TubeOptions options;
  options.around = effort_.tube_facets;
  made->tubes = TubeScene::build(made->cloth, options, error);
  if (!made->tubes) return nullptr;
  slot = std::move(made);
  return slot.get();
}

bool ChartBench::show(size_t scene, std::string& error) {
  const Loaded* loaded = load(scene, error);
  if (!loaded) return false;
  if (shown_ != scene) renderer_->upload(loaded->packed);
  shown_ = scene;
  return true;
}

Pixels ChartBench::draw(Method method, double view_deg, glm::vec2 corner, const PixelSteps& steps, int width,
                        int height, int samples) {
  FlatPatch patch;
  patch.samples = samples;
  patch.width = width, patch.height = height;
  patch.corner_mm = corner, patch.step_x_mm = steps.x, patch.step_y_mm = steps.y;
  patch.view = chart_view(view_deg);
  patch.light_towards = chart_light();
  patch.light_sine = kKeyRadius;
  patch.light_irradiance = kIrradiance;
  Look look;
  look.method = method;
  renderer_->draw_patch(patch, look);
  return colours(renderer_->read_patch());
}

std::vector<Method> ChartBench::methods() {
  std::vector<Method> offered;
  std::string error;
  if (!show(0, error)) return offered;
  for (const Method method : kChartMethods) {
    draw(method, 0, kCorner, pixel_steps(0, 1), 4, 4);
    if (renderer_->measure().method == method) offered.push_back(method);
  }
  return offered;
}

const Truth* ChartBench::truth(const ChartRow& cell, std::string& error) {
  Loaded* loaded = load(scene_of(cell), error);
  if (!loaded) return nullptr;
  Truth& truth = loaded->truths[{cell.view_deg, cell.yarns_per_pixel}];
  if (!truth.half.empty()) return &truth;
  const int pixels = patch_pixels(cell.yarns_per_pixel, effort_);
  const PixelSteps steps =
      pixel_steps(cell.view_deg, cell.yarns_per_pixel * static_cast<double>(loaded->packed.mean_spacing_mm));
  for (const uint64_t seed : {1u, 2u}) {
    const FlatPicture picture = flat_picture(cell.view_deg, kCorner, steps, pixels, effort_.truth_budget, seed);
    (seed == 1 ? truth.half : truth.other_half) = colours(trace_flat(*loaded->tubes, picture, {}));
  }
  return &truth;
}

double ChartBench::truth_noise(const ChartRow& cell, std::string& error) {
  const Truth* known = truth(cell, error);
  return known ? noise_of(known->half, known->other_half) : 0;
}

/// A thousand finer pixels or more make one.
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
  const Pixels truth = supersampled(cell, grid, pixel);
  return relative_rmse(draw(cell.method, cell.view_deg, kCorner, pixel, grid.pixels, grid.pixels), truth);
}

double ChartBench::flicker(const ChartRow& cell, const PixelSteps& pixel) {
  const int size = patch_pixels(cell.yarns_per_pixel, effort_);
  std::vector<Pixels> pans;
  for (int k = 0; k < effort_.pans; ++k) {
    const float part = static_cast<float>(k) / static_cast<float>(effort_.pans);
    pans.push_back(draw(cell.method, cell.view_deg, kCorner + part * pixel.x, pixel, size, size));
  }
  return flicker_of(pans);
}

double ChartBench::nanoseconds(const ChartRow& cell, const PixelSteps& pixel) {
  std::vector<double> times;
  double spent = 0;
  for (int k = 0; k < effort_.timing_repeats && spent < effort_.timing_enough_ns; ++k) {
    draw(cell.method, cell.view_deg, kCorner, pixel, effort_.timing_size, effort_.timing_size);
    const FrameStats stats = renderer_->measure();
    times.push_back(stats.gpu_ms * 1e6 / std::max(stats.shaded_pixels, 1.0));
    spent += stats.gpu_ms * 1e6;
  }
  // The least: whatever else the machine does only adds.
  return *std::min_element(times.begin(), times.end());
}

/// yarns: a pixel's, by the root of its area.
double ChartBench::rung_instructions(size_t scene, int view_deg, Method method, double yarns) {
  if (!effort_.count_everywhere) scene = 0, view_deg = 0;
  const int samples =
      method == Method::kYarn ? formulas::yarn_samples(static_cast<float>(yarns), formulas::kMostYarnSamples) : 1;
  const auto [at, fresh] = counted_.try_emplace({scene, view_deg, method}, 0.0);  // of a sample
  if (fresh) {
    // Single steps are slow, and samples are alike: a few stand for all.
    const int taken = method == Method::kYarn ? effort_.counted_samples : 1;
    const auto counted =
        formula_instructions(method, loaded_[scene]->cloth, chart_view(view_deg), chart_light(), taken);
    at->second = static_cast<double>(counted.value_or(0)) / taken;
  }
  return at->second * samples;
}

double ChartBench::instructions(const ChartRow& cell) {
  const size_t scene = scene_of(cell);
  const double yarns = cell.yarns_per_pixel / std::sqrt(std::cos(cell.view_deg * 0.017453292519943295));
  if (cell.method != Method::kAuto) return rung_instructions(scene, cell.view_deg, cell.method, yarns);
  // The rungs that it mixes where a pixel is so large.
  const std::array<float, 3> edges = rung_edges(ladder_, Look{}.tolerance);
  const glm::vec4 weights = formulas::rung_weights(static_cast<float>(yarns), glm::vec3(edges[0], edges[1], edges[2]));
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    if (weights[k] > kUnseenWeight)
      sum += rung_instructions(scene, cell.view_deg, kRungs[static_cast<size_t>(k)], yarns);
  }
  return sum;
}

std::optional<ChartRow> ChartBench::measure(const ChartRow& cell, std::string& error) {
  const size_t scene = scene_of(cell);
  if (!show(scene, error)) return std::nullopt;
  const Truth* known = truth(cell, error);
  if (!known) return std::nullopt;
  const PixelSteps pixel =
      pixel_steps(cell.view_deg, cell.yarns_per_pixel * static_cast<double>(loaded_[scene]->packed.mean_spacing_mm));
  const int size = patch_pixels(cell.yarns_per_pixel, effort_);
  const Pixels drawn = draw(cell.method, cell.view_deg, kCorner, pixel, size, size);
  ChartRow row = cell;
  row.model_error = relative_rmse(drawn, known->half, known->other_half);
  row.energy_ratio = 0.5 * (mean_ratio(drawn, known->half) + mean_ratio(drawn, known->other_half));
  row.filtering_error = filtering_error(cell, pixel);
  row.flicker = flicker(cell, pixel);
  row.ns_per_pixel = nanoseconds(cell, pixel);
  row.instructions_per_pixel = instructions(cell);
  row.bytes = method_bytes(loaded_[scene]->packed, cell.method);
  return as_written(row);
}

std::optional<double> ChartBench::brightness(size_t scene, double view_deg, std::optional<Method> method,
                                             std::string& error) {
  if (!show(scene, error)) return std::nullopt;
  constexpr int kPixels = 16;
  constexpr double kYarns = 4;  // a pixel: the patch holds whole figures
  Loaded& loaded = *loaded_[scene];
  const PixelSteps steps = pixel_steps(view_deg, kYarns * static_cast<double>(loaded.packed.mean_spacing_mm));
  const double white = static_cast<double>(kIrradiance.x * chart_light().z) / 3.141592653589793;
  if (method) return mean_value(draw(*method, view_deg, kCorner, steps, kPixels, kPixels)) / white;
  return mean_value(colours(
             trace_flat(*loaded.tubes, flat_picture(view_deg, kCorner, steps, kPixels, effort_.truth_budget, 3), {}))) /
         white;
}

}  // namespace weftlight::commands
