#include "upload/stages.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/loops.h"
#include "cloth/thread_scene.h"
#include "draft/repeat.h"
#include "drape/mesh.h"
#include "files/files.h"
#include "light/separable.h"
#include "upload/cloth_block.h"
#include "upload/engine_block.h"
#include "upload/response_block.h"
#include "upload/thread_block.h"

namespace weftlight::upload {
namespace {

constexpr int kAzimuths = 16;
constexpr int kFewAzimuths = 4;              // of a map whose texels are about as wide as a thread: it is nearly flat
constexpr double kFinePerHorizon = 3;        // texels across a thread, from which on threads shade each other
constexpr double kTexels = 1024.0 * 1024.0;  // of one face, where that gives each thread enough
constexpr double kMostTexels = 2048.0 * 2048.0;  // for drafts of many threads
constexpr double kLeastPerThread = 6;            // texels across a thread worth more than kTexels
constexpr double kMostPerThread = 64;            // beyond, fibres are smooth
constexpr double kFinePerThread = 14;            // a whole draft coarser than this gives way to its repeat
constexpr int kLongest = 8192;
constexpr int kQuickSamples = 256;
constexpr int kQuickShrink = 4;  // of a quick bake's sides

bool same_yarn_shape(Yarn a, Yarn b) {
  a.lobes = b.lobes = Lobes{};
  return a == b;
}

bool same_yarns(const std::vector<Yarn>& a, const std::vector<Yarn>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_yarn_shape);
}

bool same_threads(const Draft& a, const Draft& b) {
  return a.warp == b.warp && a.weft == b.weft && a.palette == b.palette;
}

bool same_bodies(const std::vector<ThreadBody>& a, const std::vector<ThreadBody>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ThreadBody& s, const ThreadBody& t) {
    return s.centre_mm == t.centre_mm && s.spacing_mm == t.spacing_mm && s.width_mm == t.width_mm &&
           s.height_mm == t.height_mm && s.yarn == t.yarn && s.colour.r == t.colour.r && s.colour.g == t.colour.g &&
           s.colour.b == t.colour.b;
  });
}

bool same_layout(const Cloth& a, const Cloth& b) {
  return a.width_mm == b.width_mm && a.depth_mm == b.depth_mm && same_bodies(a.ends, b.ends) &&
         same_bodies(a.picks, b.picks) && a.layers.empty() && b.layers.empty();
}

int power_of_two(double v) {
  const double floor2 = std::exp2(std::floor(std::log2(std::max(1.0, v)) + 0.5));
  return static_cast<int>(std::min<double>(kLongest, floor2));
}

/// Texels across one thread that the budget allows.
double per_thread(double crossings) {
  const double wanted = std::sqrt(kTexels / std::max(1.0, crossings));
  if (wanted >= kLeastPerThread) return std::min(wanted, kMostPerThread);
  return std::min(kLeastPerThread, std::sqrt(kMostTexels / std::max(1.0, crossings)));
}

/// Powers of two, so that every mip averages whole texels.
MapsSize maps_size(const Cloth& cloth, bool shadows) {
  const double ends = static_cast<double>(cloth.ends.size()), picks = static_cast<double>(cloth.picks.size());
  // Shadow maps are more than all other maps together: with them a large draft keeps to the smaller budget.
  const double fewer =
      shadows ? std::min(1.0, std::sqrt(kTexels / std::max(1.0, ends * picks)) / per_thread(ends * picks)) : 1.0;
  const double n = per_thread(ends * picks) * fewer;
  // Square texels in millimetres: the shorter side of the threads' mean decides.
  MapsSize size{power_of_two(ends * n), power_of_two(picks * n), n < kFinePerHorizon ? kFewAzimuths : kAzimuths};
  return size;
}

std::vector<float> cube_texels(const CubeMap& cube) {
  std::vector<float> texels;
  for (const std::vector<glm::vec3>& face : cube.faces) {
    for (const glm::vec3& c : face) texels.insert(texels.end(), {c.x, c.y, c.z});
  }
  return texels;
}

/// The average BRDF of rung vrst03.
void add_cubes(PackedFace& face, const Cloth& cloth) {
  const Separable separable = factorise(cloth_brdf(cloth), Split::kHalfDifference);
  face.cube_size = separable.first.size;
  face.half_cube = cube_texels(separable.first);
  face.difference_cube = cube_texels(separable.second);
}

ReadMesh find_mesh(const std::string& name) {
  ReadMesh read = load_drape(name);
  const std::vector<std::string>& shipped = drape_names();
  const bool is_shipped = std::find(shipped.begin(), shipped.end(), name) != shipped.end();
  if (!read.mesh && is_shipped) read = {simulate_drape(name), {}};
  if (read.mesh && is_shipped) read.mesh->name = name;
  return read;
}

/// Why a cloth is not drawn: what would be laid out has too many crossings. 400 million take 27 s of CPU time
/// (measured, two cores) and hardly more memory than 25 million: the maps have a largest size.
std::string too_large(const Design& design, const BitMatrix& cells) {
  constexpr int64_t kMost = 400'000'000;
  if (int64_t{cells.cols()} * cells.rows() <= kMost) return {};
  const Repeat size = design_repeat(design, cells);
  const int64_t crossings = int64_t{size.ends} * size.picks;
  if (crossings <= kMost) return {};
  char text[256];
  std::snprintf(
      text, sizeof text,
      "%d ends by %d picks that do not repeat are %.0f million crossings; at most %.0f million are drawn: take "
      "a part of the draft",
      size.ends, size.picks, static_cast<double>(crossings) / 1e6, static_cast<double>(kMost) / 1e6);
  return text;
}

}  // namespace

Cloth face_cloth(const Design& design, const BitMatrix& cells, Face face, Period period) {
  Cloth cloth = lay_out(design, cells, face, period);
  if (face == Face::kBack) {
    for (Yarn& yarn : cloth.yarns) {
      yarn.twist = yarn.twist == Twist::kS ? Twist::kZ : yarn.twist == Twist::kZ ? Twist::kS : Twist::kNone;
    }
  }
  return cloth;
}

Period choose_period(const Design& design, const BitMatrix& cells) {
  const double whole = per_thread(static_cast<double>(cells.cols()) * cells.rows());
  if (whole >= kFinePerThread) return Period::kWholeDraft;
  const Repeat size = design_repeat(design, cells);
  const double repeat = per_thread(static_cast<double>(size.ends) * size.picks);
  return repeat > 1.5 * whole ? Period::kRepeat : Period::kWholeDraft;
}

void Stages::bake_all(const Design& design, bool shadows, Effort effort) {
  coarse_ = effort == Effort::kQuick;
  old_back_ = false;
  period_ = choose_period(design, cells_);
  shadows_ = shadows;
  for (const Face face : {Face::kFront, Face::kBack}) {
    FaceState& state = face == Face::kFront ? front_ : back_;
    state.cloth = face_cloth(design, cells_, face, period_);
    MapsSize size = maps_size(state.cloth, shadows);
    if (coarse_)
      size.width = std::max(1, size.width / kQuickShrink), size.height = std::max(1, size.height / kQuickShrink);
    state.maps = bake(state.cloth, size);
    PackedFace& packed = face == Face::kFront ? packed_.front : packed_.back;
    packed = pack(state.maps, shadows);
    if (shadows) add_cubes(packed, state.cloth);
    if (effort == Effort::kOnce) state.maps.horizon.clear(), state.maps.thread = {};  // packed, and not asked for again
  }
  packed_.width_mm = front_.cloth.width_mm;
  packed_.depth_mm = front_.cloth.depth_mm;
  packed_.mean_spacing_mm = mean_spacing_mm(front_.cloth);
  take_threads();
}

/// All threads and crossings of the front; the back's are the same, turned over.
void Stages::take_threads() {
  const Cloth& cloth = front_.cloth;
  packed_.ends = static_cast<int>(cloth.ends.size()), packed_.picks = static_cast<int>(cloth.picks.size());
  packed_.crossings.clear(), packed_.lobes.threads.clear();
  if (int64_t{packed_.ends} * packed_.picks > kMostCrossings) return;
  const std::vector<glm::vec4> crossings = thread_crossings(cloth, {0, packed_.ends, 0, packed_.picks});
  top_mm_ = cloth.layers.empty() ? highest_thread(cloth, crossings) : 0;
  packed_.crossings = packed_crossings(crossings);
}

void Stages::take_crossings(const CellRect& dirty, StageResult& result) {
  if (packed_.crossings.empty()) return;
  const Cloth& cloth = front_.cloth;
  const CellRect all{0, packed_.ends, 0, packed_.picks};
  const CellRect cells = period_ == Period::kRepeat ? all : touched_crossings(cloth, dirty);
  const std::vector<glm::vec4> crossings = thread_crossings(cloth, cells);
  top_mm_ = std::max(top_mm_, highest_thread(cloth, crossings));
  std::vector<HalfCrossing> texels = packed_crossings(crossings);
  const std::ptrdiff_t row = cells.end1 - cells.end0;
  for (int p = cells.pick0; p < cells.pick1; ++p) {
    std::copy_n(texels.begin() + (p - cells.pick0) * row, row,
                packed_.crossings.begin() + static_cast<std::ptrdiff_t>(p) * packed_.ends + cells.end0);
  }
  result.patches.crossings.push_back({cells, std::move(texels)});
}

bool Stages::bake_cells(const Design& design, const CellRect& dirty, Effort effort, StageResult& result) {
  const bool catch_up = old_back_ && effort != Effort::kQuick;
  if (dirty.empty() && !catch_up) return true;
  if (shadows_) return false;  // vrst03 knows only the whole
  if (period_ == Period::kRepeat && choose_period(design, cells_) != period_) return false;
  for (const Face face : {Face::kFront, Face::kBack}) {
    if (face == Face::kBack) old_back_ = effort == Effort::kQuick;
    if (face == Face::kBack && old_back_) break;
    FaceState& state = face == Face::kFront ? front_ : back_;
    Cloth after = face_cloth(design, cells_, face, period_);
    if (!same_layout(state.cloth, after)) return false;
    const std::vector<TexelRect> rects = rebake(state.maps, state.cloth, after);
    state.cloth = std::move(after);
    if (face == Face::kFront && !dirty.empty()) take_crossings(dirty, result);
    PackedFace& packed = face == Face::kFront ? packed_.front : packed_.back;
    std::vector<PackedPatch> patches = repack(packed, face, state.maps, rects);
    result.patches.maps.insert(result.patches.maps.end(), std::make_move_iterator(patches.begin()),
                               std::make_move_iterator(patches.end()));
  }
  return true;
}

void Stages::take_lobes(const Design& design, Effort effort, StageResult& result) {
  const std::vector<Yarn> yarns = finished(design.yarns, design.finish);
  for (FaceState* state : {&front_, &back_}) {
    for (size_t i = 0; i < state->cloth.yarns.size() && i < yarns.size(); ++i) {
      state->cloth.yarns[i].lobes = yarns[i].lobes;
    }
  }
  const FaceInput front{front_.cloth, front_.maps}, back{back_.cloth, back_.maps};
  ClothLobes& lobes = packed_.lobes;
  if (!packed_.crossings.empty()) lobes.threads = thread_records(front_.cloth, top_mm_);
  interop::ClothData data = cloth_block(front, back);
  data.even_yarns = even_from_yarns(packed_.front, packed_.width_mm, packed_.mean_spacing_mm);
  old_response_ = effort == Effort::kQuick;
  if (old_response_ && !lobes.response.empty()) keep_response(data, lobes.data);
  else lobes.response = response_tables(data, front, back, old_response_ ? kQuickSamples : kResponseSamples);
  if (engine_ && !old_response_) {
    for_each_job(2, [&](int f) {
      const Face face = f == 0 ? Face::kFront : Face::kBack;
      const interop::SystemData *warp = &data.systems[2 * f], *weft = warp + 1;
      const float cover = std::max(warp->coverage + weft->coverage, 1e-6f);
      data.engine[f] = engine_block(face_cloth(design, cells_, face, Period::kRepeat), weft->coverage / cover);
    });
  }
  lobes.data = data;
  result.lobes = lobes;
}

/// What the cloth hangs on, and the light. Of what cannot be read the last good one stays.
void Stages::take_scene(const Scene& scene, StageResult& result) {
  if (scene.mesh != mesh_name_) {
    ReadMesh read = find_mesh(scene.mesh);
    if (read.mesh) result.mesh = prepare_mesh(*read.mesh);
    mesh_problem_ = read.mesh ? std::string() : read.error;
    mesh_name_ = scene.mesh;
  }
  if (scene.lights != lights_name_) {
    lights_problem_.clear();
    LightRig read = load_light_rig(scene.lights, lights_problem_);
    if (lights_problem_.empty()) result.lights = std::move(read);
    lights_name_ = scene.lights;
  }
  result.problem = mesh_problem_.empty() ? lights_problem_ : mesh_problem_;
}

StageResult Stages::update(std::shared_ptr<const Design> design, Effort effort) {
  StageResult result;
  take_scene(design->scene, result);
  const Draft& now = design->draft;
  if (now.ends() == 0 || now.picks() == 0) {
    result.problem = "the draft has no threads: give it at least one end and one pick";
    return result;
  }
  const bool shadows = shadows_ || design->look.method == Method::kVrst03;
  // Who compares rungs asks for vrst03's maps, and gets what is engine's too.
  const bool engine = engine_ || shadows || design->look.method == Method::kEngine;
  const bool new_engine = engine && !engine_ && effort != Effort::kQuick;
  const bool first = !done_;
  const bool same_sizes = !first && done_->draft.ends() == now.ends() && done_->draft.picks() == now.picks();
  const CellRect all{0, now.ends(), 0, now.picks()};
  CellRect dirty = all;
  if (same_sizes) {
    if (done_->draft == now) dirty = {};
    else dirty = update_drawdown(cells_, done_->draft, now);
  } else {
    cells_ = drawdown(now);
  }
  if (std::string refused = too_large(*design, cells_); !refused.empty()) {
    done_ = nullptr;
    result.problem = std::move(refused);
    return result;
  }
  const bool same_look = same_sizes && same_threads(done_->draft, now) && same_yarns(done_->yarns, design->yarns) &&
                         done_->finish == design->finish && shadows == shadows_;
  const bool too_coarse = coarse_ && effort != Effort::kQuick;
  if (!same_look || too_coarse || !bake_cells(*design, dirty, effort, result)) {
    result.patches = {};
    bake_all(*design, shadows, effort);
    result.all_maps = true;
  }
  engine_ = engine_ || new_engine;
  const bool new_answer = old_response_ && effort != Effort::kQuick;
  if (result.all_maps || !dirty.empty() || new_answer || new_engine || done_->yarns != design->yarns)
    take_lobes(*design, effort, result);
  done_ = std::move(design);
  if (effort == Effort::kOnce) front_ = back_ = {}, cells_ = {}, done_ = nullptr;
  return result;
}

}  // namespace weftlight::upload
