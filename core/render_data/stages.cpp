#include "render_data/stages.h"

#include <algorithm>
#include <cmath>

#include "base/loops.h"
#include "base/text.h"
#include "cloth/coarse_cloth.h"
#include "cloth/thread_scene.h"
#include "design/repeat.h"
#include "drape/mesh.h"
#include "files/design_drape.h"
#include "light/separable.h"
#include "render_data/cloth_block.h"
#include "render_data/engine_block.h"
#include "render_data/response_block.h"
#include "render_data/thread_block.h"

namespace weftlight::render_data {

using base::arg;
using base::fill;
using base::tr;

namespace {

constexpr int kAzimuths = 16;
constexpr int kFewAzimuths = 4;                 // of a map with about one texel a thread: it is nearly flat
constexpr double kFinePerHorizon = 3;           // texels across a thread from which on threads shade each other
constexpr double kTexels = 1024.0 * 1024.0;     // of one face, if that gives each thread enough
constexpr double kMaxTexels = 2048.0 * 2048.0;  // for drafts of many threads
constexpr double kMinPerThread = 6;             // texels across a thread that are worth more than kTexels
constexpr double kMaxPerThread = 64;            // beyond, fibres are smooth
constexpr double kFinePerThread = 14;           // a coarser whole draft is replaced by its repeat
constexpr double kUnevenPerThread = 5;          // the same, where no two threads are alike
constexpr int kLongest = 8192;
constexpr int kQuickSamples = 256;
constexpr int kQuickShrink = 4;        // divisor of a quick bake's sides
constexpr double kQuickThreads = 1.7;  // threads across a texel of it; beyond, some represent all
constexpr int kQuickThreadSamples = 1;
// Changed all over the cloth: updating the maps would take too long to be interactive.
constexpr int kManyCrossings = 2000;
constexpr int64_t kMaxVisible = 1 << 18;  // texels, or crossings, of a preview
constexpr int kPreviewLevels = 4,         // levels of a part of the maps, which is aligned to whole texels
    kPreviewStep = 1 << kPreviewLevels;   // levels of a part of the maps, aligned to whole texels

bool same_yarn_shape(Yarn a, Yarn b) {
  a.lobes = b.lobes = Lobes{};
  a.tex = b.tex = 0;  // weighs, and is not visible
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
           s.height_mm == t.height_mm && s.unevenness == t.unevenness && s.yarn == t.yarn && s.colour.r == t.colour.r &&
           s.colour.g == t.colour.g && s.colour.b == t.colour.b;
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

/// Texels across one thread within the budget.
double per_thread(double crossings) {
  const double wanted = std::sqrt(kTexels / std::max(1.0, crossings));
  if (wanted >= kMinPerThread) return std::min(wanted, kMaxPerThread);
  return std::min(kMinPerThread, std::sqrt(kMaxTexels / std::max(1.0, crossings)));
}

/// Powers of two, so that every mip averages whole texels.
MapsSize maps_size(const Cloth& cloth, bool shadows) {
  const double ends = static_cast<double>(cloth.ends.size()), picks = static_cast<double>(cloth.picks.size());
  // Shadow maps take more memory than all other maps together: with them a large draft keeps to the smaller budget.
  const double fewer =
      shadows ? std::min(1.0, std::sqrt(kTexels / std::max(1.0, ends * picks)) / per_thread(ends * picks)) : 1.0;
  const double n = per_thread(ends * picks) * fewer;
  // The number of texels follows the number of threads.
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

/// The average BRDF of method vrst03.
void add_cubes(PackedFace& face, const Cloth& cloth) {
  const Separable separable = factorise(cloth_brdf(cloth), Split::kHalfDifference);
  face.cube_size = separable.first.size;
  face.half_cube = cube_texels(separable.first);
  face.difference_cube = cube_texels(separable.second);
}

base::Result<Mesh> find_mesh(const Design& design) {
  const std::string& name = design.scene.mesh;
  base::Result<Mesh> read = load_design_drape(design);
  const std::vector<std::string>& shipped = drape_names();
  const bool is_shipped = std::find(shipped.begin(), shipped.end(), name) != shipped.end();
  if (!read && is_shipped) read = simulate_drape(name);
  if (read && is_shipped) read->name = name;
  return read;
}

/// Error if the cloth has too many crossings to lay out. 400 million take 27 s of CPU time (measured, two cores) and
/// hardly more memory than 25 million, since the maps have a maximum size.
std::string too_large(const Design& design, const BitMatrix& cells) {
  constexpr int64_t kMax = 400'000'000;
  if (int64_t{cells.cols()} * cells.rows() <= kMax) return {};
  const Repeat size = design_repeat(design, cells);
  const int64_t crossings = int64_t{size.ends} * size.picks;
  if (crossings <= kMax) return {};
  return fill(tr("{ends} ends by {picks} picks that do not repeat are {crossings:.0f} million crossings; at most "
                 "{most:.0f} million are drawn: take a part of the draft"),
              arg("ends", size.ends), arg("picks", size.picks), arg("crossings", static_cast<double>(crossings) / 1e6),
              arg("most", static_cast<double>(kMax) / 1e6));
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

bool is_uneven(const Design& design) {
  // Less is hardly visible, and a repeat shows everything else more sharply.
  constexpr float kBetween = 0.03f, kAlong = 15;
  return std::ranges::any_of(design.yarns,
                             [](const Yarn& y) { return y.irregularity >= kBetween || y.unevenness >= kAlong; });
}

Period choose_period(const Design& design, const BitMatrix& cells) {
  const double whole = per_thread(static_cast<double>(cells.cols()) * cells.rows());
  if (whole >= (is_uneven(design) ? kUnevenPerThread : kFinePerThread)) return Period::kWholeDraft;
  const Repeat size = design_repeat(design, cells);
  const double repeat = per_thread(static_cast<double>(size.ends) * size.picks);
  return repeat > 1.5 * whole ? Period::kRepeat : Period::kWholeDraft;
}

void Stages::bake_all(const Design& design, bool shadows, Effort effort) {
  coarse_ = effort == Effort::kQuick;
  old_back_ = false;
  period_ = choose_period(design, cells_);
  shadows_ = shadows;
  front_.cloth = face_cloth(design, cells_, Face::kFront, period_);
  back_.cloth = face_cloth(design, cells_, Face::kBack, period_);
  if (effort == Effort::kOnce) cells_ = {};  // 50 MB for 20,000 x 20,000, and each face has its own
  for (const Face face : {Face::kFront, Face::kBack}) {
    FaceState& state = face == Face::kFront ? front_ : back_;
    MapsSize size = maps_size(state.cloth, shadows);
    if (coarse_)
      size.width = std::max(1, size.width / kQuickShrink), size.height = std::max(1, size.height / kQuickShrink);
    const TexelRect all{0, 0, size.width, size.height};
    state.maps = coarse_ ? bake_quick(state.cloth, size, all) : bake(state.cloth, size);
    PackedFace& packed = face == Face::kFront ? packed_.front : packed_.back;
    packed = pack(state.maps, shadows);
    if (shadows) add_cubes(packed, state.cloth);
    if (effort == Effort::kOnce) {  // packed, and not asked for again
      state.maps.horizon.clear();
      state.maps.height_mm = {}, state.maps.thread = {};
    }
  }
  packed_.width_mm = front_.cloth.width_mm;
  packed_.depth_mm = front_.cloth.depth_mm;
  packed_.mean_spacing_mm = mean_spacing_mm(front_.cloth);
  update_threads();
}

/// Quick bake: where a texel holds many threads, some represent all.
Maps Stages::bake_quick(const Cloth& cloth, const MapsSize& size, const TexelRect& window) const {
  const auto group = [](size_t threads, int texels) {
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(threads) / texels / kQuickThreads)));
  };
  const int ends = group(cloth.ends.size(), size.width), picks = group(cloth.picks.size(), size.height);
  MapsSize fewer = size;
  fewer.samples_a_thread = kQuickThreadSamples;
  if (ends * picks == 1) return bake(cloth, fewer, window);
  return bake(coarse_cloth(cloth, ends, picks), fewer, window);
}

/// Whether an edit of many cells can be shown by a preview of the visible part: the maps exist, and only `up` changed.
bool Stages::can_bake_preview(const Design& design) const {
  if (!done_ || visible_.empty() || coarse_ || shadows_ || packed_.front.textures[0].width == 0) return false;
  if (period_ != Period::kWholeDraft || !front_.cloth.layers.empty()) return false;
  return done_->draft.ends() == design.draft.ends() && done_->draft.picks() == design.draft.picks() &&
         same_threads(done_->draft, design.draft) && done_->yarns == design.yarns && done_->finish == design.finish;
}

/// Bakes a preview of the visible part of the front, if too many cells changed to wait for. It is not kept: the next
/// full update starts from the state before. False: few cells changed.
bool Stages::preview_bake(const Design& design, StageResult& result) {
  if (!can_bake_preview(design) || (!previewed_ && done_->draft == design.draft)) return false;
  BitMatrix cells = cells_;
  update_drawdown(cells, done_->draft, design.draft);
  int64_t changed = 0;
  for (int p = 0; p < cells.rows(); ++p) changed += differences(cells.row(p), cells_.row(p));
  if (changed < kManyCrossings && !previewed_) return false;
  const Cloth cloth = face_cloth(design, cells, Face::kFront, period_);
  if (!same_layout(front_.cloth, cloth)) return false;
  bake_preview_maps(cloth, result);
  bake_preview_crossings(cloth, result);
  previewed_ = true;
  return true;
}

namespace {

/// The part of [from, to) within a period of `length`; all of it if that crosses the end.
struct Run {
  double from, to;
};
Run in_period(double from, double to, double length) {
  const double start = from - std::floor(from / length) * length;
  if (to - from >= length || start + (to - from) > length) return {0, length};
  return {start, start + (to - from)};
}

/// Moves the levels of a texture, from the finest on, into patches of the front's texture at `level` and above.
void append_levels(std::vector<PackedPatch>& to, PackedTexture& t, const TexelRect& window, int level, int levels) {
  for (int k = 0; k < std::min(levels, static_cast<int>(t.levels.size())); ++k)
    to.push_back({Face::kFront, t.kind, level + k, window.x0 >> k, window.y0 >> k, t.level_width(k), t.level_height(k),
                  std::move(t.levels[static_cast<size_t>(k)])});
}

}  // namespace

/// The level for the pixel size and those above it, or the finest one that can be baked at once.
void Stages::bake_preview_maps(const Cloth& cloth, StageResult& result) const {
  const PackedTexture& shown = packed_.front.textures[0];
  const double period[] = {static_cast<double>(cloth.width_mm), static_cast<double>(cloth.depth_mm)};
  const Run u = in_period(static_cast<double>(visible_.u0), static_cast<double>(visible_.u1), period[0]);
  const Run v = in_period(static_cast<double>(visible_.v0), static_cast<double>(visible_.v1), period[1]);
  for (int level = 0; level + kPreviewLevels < static_cast<int>(shown.levels.size()); ++level) {
    const int w = shown.level_width(level), h = shown.level_height(level);
    const auto texels = [](double from, double to, double length, int n) {
      const int low = static_cast<int>(from / length * n) / kPreviewStep * kPreviewStep;
      const int high = (static_cast<int>(std::ceil(to / length * n)) + kPreviewStep - 1) / kPreviewStep * kPreviewStep;
      return std::pair{std::min(low, n - 1), std::clamp(high, std::min(low, n - 1) + 1, n)};
    };
    const auto [x0, x1] = texels(u.from, u.to, period[0], w);
    const auto [y0, y1] = texels(v.from, v.to, period[1], h);
    const double texel_mm = std::min(period[0] / w, period[1] / h);
    if (2 * texel_mm <= static_cast<double>(visible_.pixel_mm) || int64_t{x1 - x0} * (y1 - y0) > kMaxVisible) continue;
    const MapsSize size{w, h, packed_.front.textures[static_cast<size_t>(PackedKind::kHorizon)].layers - 1};
    PackedFace part = pack(bake_quick(cloth, size, {x0, y0, x1, y1}), false);
    const bool whole = x1 - x0 == w && y1 - y0 == h;
    for (PackedTexture& t : part.textures) {
      if (t.layers == 0) continue;
      const bool half = t.kind == PackedKind::kHorizon;
      append_levels(result.patches.maps, t,
                    half ? TexelRect{x0 / 2, y0 / 2, x1 / 2, y1 / 2} : TexelRect{x0, y0, x1, y1}, level,
                    whole  ? static_cast<int>(t.levels.size())
                    : half ? kPreviewLevels - 1
                           : kPreviewLevels);
    }
    return;
  }
}

/// Crossings of the preview, if few enough are visible to be drawn thread by thread.
void Stages::bake_preview_crossings(const Cloth& cloth, StageResult& result) const {
  if (packed_.crossings.empty()) return;
  const auto visible = [](const std::vector<ThreadBody>& threads, const Run& run) {
    const auto at = [&](double mm) {
      return static_cast<int>(
          std::ranges::partition_point(threads,
                                       [mm](const ThreadBody& t) { return static_cast<double>(t.centre_mm) < mm; }) -
          threads.begin());
    };
    constexpr int kMargin = 2;
    const int n = static_cast<int>(threads.size());
    return std::pair{std::max(0, at(run.from) - kMargin), std::min(n, at(run.to) + kMargin)};
  };
  const double width = static_cast<double>(cloth.width_mm), depth = static_cast<double>(cloth.depth_mm);
  const auto [e0, e1] =
      visible(cloth.ends, in_period(static_cast<double>(visible_.u0), static_cast<double>(visible_.u1), width));
  const auto [p0, p1] =
      visible(cloth.picks, in_period(static_cast<double>(visible_.v0), static_cast<double>(visible_.v1), depth));
  const CellRect cells{e0, e1, p0, p1};
  if (cells.empty() || int64_t{e1 - e0} * (p1 - p0) > kMaxVisible) return;
  const std::vector<glm::vec4> crossings = thread_crossings(cloth, cells);
  result.patches.crossings.push_back({cells, packed_crossings(crossings)});
  const float top_mm = highest_thread(cloth, crossings);
  if (top_mm <= top_mm_) return;
  result.lobes = packed_.lobes;
  result.lobes->threads = thread_records(cloth, top_mm);
}

/// All threads and crossings of the front; the back has the same, turned over.
void Stages::update_threads() {
  const Cloth& cloth = front_.cloth;
  packed_.ends = static_cast<int>(cloth.ends.size()), packed_.picks = static_cast<int>(cloth.picks.size());
  packed_.crossings.clear(), packed_.lobes.threads.clear();
  if (int64_t{packed_.ends} * packed_.picks > kMaxCrossings) return;
  const std::vector<glm::vec4> crossings = thread_crossings(cloth, {0, packed_.ends, 0, packed_.picks});
  top_mm_ = cloth.layers.empty() ? highest_thread(cloth, crossings) : 0;
  packed_.crossings = packed_crossings(crossings);
}

void Stages::update_crossings(const CellRect& dirty, StageResult& result) {
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
  if (shadows_) return false;  // vrst03 has no partial update
  if (period_ == Period::kRepeat && choose_period(design, cells_) != period_) return false;
  for (const Face face : {Face::kFront, Face::kBack}) {
    if (face == Face::kBack) old_back_ = effort == Effort::kQuick;
    if (face == Face::kBack && old_back_) break;
    FaceState& state = face == Face::kFront ? front_ : back_;
    Cloth after = face_cloth(design, cells_, face, period_);
    if (!same_layout(state.cloth, after)) return false;
    const std::vector<TexelRect> rects = rebake(state.maps, state.cloth, after);
    state.cloth = std::move(after);
    if (face == Face::kFront && !dirty.empty()) update_crossings(dirty, result);
    PackedFace& packed = face == Face::kFront ? packed_.front : packed_.back;
    std::vector<PackedPatch> patches = repack(packed, face, state.maps, rects);
    result.patches.maps.insert(result.patches.maps.end(), std::make_move_iterator(patches.begin()),
                               std::make_move_iterator(patches.end()));
  }
  return true;
}

void Stages::update_lobes(const Design& design, Effort effort, StageResult& result) {
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
  if (!old_response_) lobes.errors = packed_.crossings.empty() ? ThreadErrors{} : thread_errors(front_.cloth);
  if (engine_ && !old_response_) {
    const BitMatrix cells = cells_.rows() > 0 ? cells_ : drawdown(design.draft);  // they may be given up already
    for_each_job(2, [&](int f) {
      const Face face = f == 0 ? Face::kFront : Face::kBack;
      const interop::SystemData *warp = &data.systems[2 * f], *weft = warp + 1;
      const float cover = std::max(warp->coverage + weft->coverage, 1e-6f);
      data.engine[f] = engine_block(face_cloth(design, cells, face, Period::kRepeat), weft->coverage / cover);
    });
  }
  lobes.data = data;
  result.lobes = lobes;
}

/// Mesh and lights. If one cannot be read the last good one stays.
void Stages::update_scene(const Design& design, Effort effort, StageResult& result) {
  const Scene& scene = design.scene;
  const bool more_rays = few_rays_ && effort != Effort::kQuick;
  if (const std::string key = drape_key(design); key != mesh_name_ || more_rays) {
    const base::Result<Mesh> read = find_mesh(design);
    few_rays_ = effort == Effort::kQuick;
    if (read) result.mesh = prepare_mesh(*read, few_rays_ ? SkyRays::kFew : SkyRays::kAll);
    mesh_problem_ = problem_of(read);
    mesh_name_ = key;
  }
  if (scene.lights != lights_name_) {
    base::Result<LightRig> read = load_light_rig(scene.lights);
    lights_problem_ = problem_of(read);
    if (read) result.lights = std::move(*read);
    lights_name_ = scene.lights;
  }
  result.problem = mesh_problem_.empty() ? lights_problem_ : mesh_problem_;
}

StageResult Stages::update(std::shared_ptr<const Design> design, Effort effort) {
  StageResult scene, result;
  // The two are independent.
  for_each_job(
      2, [&](int part) { part == 0 ? update_scene(*design, effort, scene) : update_cloth(design, effort, result); });
  result.mesh = std::move(scene.mesh), result.lights = std::move(scene.lights);
  if (result.problem.empty()) result.problem = std::move(scene.problem);
  if (effort == Effort::kOnce) front_ = back_ = {}, cells_ = {}, done_ = nullptr;
  return result;
}

void Stages::update_cloth(const std::shared_ptr<const Design>& design, Effort effort, StageResult& result) {
  const Draft& now = design->draft;
  if (now.ends() == 0 || now.picks() == 0) {
    result.problem = tr("the draft has no threads: give it at least one end and one pick");
    return;
  }
  if (effort == Effort::kQuick && preview_bake(*design, result)) return;
  const bool shadows = shadows_ || design->look.method == Method::kVrst03;
  // A comparison of methods asks for vrst03's maps, and gets those of engine, too.
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
    return;
  }
  const bool same_look = same_sizes && same_threads(done_->draft, now) && same_yarns(done_->yarns, design->yarns) &&
                         done_->finish == design->finish && shadows == shadows_;
  const bool too_coarse = coarse_ && effort != Effort::kQuick;
  if (!same_look || too_coarse || !bake_cells(*design, dirty, effort, result)) {
    result.patches = {};
    bake_all(*design, shadows, effort);
    result.all_maps = true;
  } else if (previewed_ && effort != Effort::kQuick) {
    // Replaces the preview.
    result.patches = {};
    result.all_maps = true;
  }
  engine_ = engine_ || new_engine;
  if (result.all_maps) previewed_ = false;
  const bool new_response = old_response_ && effort != Effort::kQuick;
  if (result.all_maps || !dirty.empty() || new_response || new_engine || done_->yarns != design->yarns)
    update_lobes(*design, effort, result);
  done_ = design;
}

}  // namespace weftlight::render_data
