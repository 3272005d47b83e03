#include "render_data/cloth_stages.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/text.h"
#include "cloth/thread_scene.h"
#include "design/repeat.h"
#include "light/separable.h"
#include "render_data/cloth_block.h"
#include "render_data/face_cloth.h"
#include "render_data/thread_block.h"

namespace weftlight::render_data {

using base::arg, base::fill, base::tr;
using cloth::Cloth, cloth::MapsSize, cloth::Period, cloth::TexelRect, cloth::bake, cloth::highest_thread, cloth::rebake,
    cloth::thread_crossings;
using design::Design, design::Repeat, design::design_repeat;
using draft::BitMatrix, draft::CellRect, draft::Draft, draft::drawdown, draft::update_drawdown;
using light::CubeMap, light::Separable, light::Split, light::cloth_brdf, light::factorise;

namespace {

/// An error if the cloth has too many crossings to lay out. 400 million take 27 s of CPU time (measured, two cores) and
/// hardly more memory than 25 million, since the maps have a maximum size.
base::Result<void> check_size(const Design& design, const BitMatrix& cells) {
  constexpr int64_t kMax = 400'000'000;
  if (int64_t{cells.cols()} * cells.rows() <= kMax) return {};
  const Repeat size = design_repeat(design, cells);
  const int64_t crossings = int64_t{size.ends} * size.picks;
  if (crossings <= kMax) return {};
  return base::failure(
      base::ErrorKind::kInput,
      fill(tr("{ends} ends by {picks} picks that do not repeat are {crossings:.0f} million crossings; at most "
              "{most:.0f} million are drawn: take a part of the draft"),
           arg("ends", size.ends), arg("picks", size.picks), arg("crossings", static_cast<double>(crossings) / 1e6),
           arg("most", static_cast<double>(kMax) / 1e6)));
}

/// The smallest rectangle with both.
CellRect united(const CellRect& a, const CellRect& b) {
  if (a.empty() || b.empty()) return a.empty() ? b : a;
  return {std::min(a.end0, b.end0), std::max(a.end1, b.end1), std::min(a.pick0, b.pick0), std::max(a.pick1, b.pick1)};
}

template <class T>
void append(std::vector<T>& to, std::vector<T> more) {
  to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<float> cube_texels(const CubeMap& cube) {
  std::vector<float> texels;
  for (const std::vector<glm::vec3>& face : cube.faces) {
    for (const glm::vec3& c : face) texels.insert(texels.end(), {c.x, c.y, c.z});
  }
  return texels;
}

/// Replaces a rectangle of the packed crossings.
void copy_into(PackedCloth& packed, const CrossingPatch& patch) {
  const CellRect& cells = patch.cells;
  const std::ptrdiff_t row = cells.end1 - cells.end0;
  const auto copy = [&](const std::vector<HalfCrossing>& from, std::vector<HalfCrossing>& to) {
    if (from.empty()) return;
    for (int p = cells.pick0; p < cells.pick1; ++p)
      std::copy_n(from.begin() + (p - cells.pick0) * row, row,
                  to.begin() + static_cast<std::ptrdiff_t>(p) * packed.ends + cells.end0);
  };
  copy(patch.texels, packed.crossings);
  copy(patch.asides, packed.asides);
}

}  // namespace

base::Result<Outcome> update_cells(StageWork& work, Change) {
  StageData& data = work.data;
  const Draft& now = work.design().draft;
  if (now.ends() == 0 || now.picks() == 0)
    return base::failure(base::ErrorKind::kInput,
                         tr("the draft has no threads: give it at least one end and one pick"));
  Change change = Change::kAll;
  if (data.drawn && data.drawn->draft.ends() == now.ends() && data.drawn->draft.picks() == now.picks()) {
    const CellRect painted = update_drawdown(data.cells, data.drawn->draft, now);
    data.painted = united(data.painted, painted);
    // vrst03 has no partial update.
    change = painted.empty() ? Change::kNone : work.input.shadows ? Change::kAll : Change::kPart;
  } else {
    data.cells = drawdown(now);
  }
  data.drawn = work.input.design;
  if (const base::Result<void> size = check_size(work.design(), data.cells); !size) return failed(size);
  return Outcome{change};
}

base::Result<Outcome> update_period(StageWork& work, Change input) {
  Period& period = work.data.period;
  // While its cells are painted, a whole draft stays whole, even if it comes to repeat.
  if (input == Change::kPart && period == Period::kWholeDraft) return Outcome{Change::kNone};
  const Period before = std::exchange(period, choose_period(work.design(), work.data.cells));
  return Outcome{period == before ? Change::kNone : Change::kAll, work.quick()};
}

base::Result<Outcome> update_threads(StageWork& work, Change input, Face face) {
  StageData& data = work.data;
  FaceData& f = work.face(face);
  Cloth after = face_cloth(work.design(), data.cells, face, data.period);
  const bool same = input == Change::kPart && same_layout(f.cloth, after);
  if (!same) f.mapped.reset();
  else if (!f.mapped) f.mapped = std::move(f.cloth);
  f.cloth = std::move(after);
  if (face == Face::kFront) {
    data.packed.width_mm = f.cloth.width_mm, data.packed.depth_mm = f.cloth.depth_mm;
    data.packed.mean_spacing_mm = mean_spacing_mm(f.cloth);
  }
  // 50 MB for 20,000 x 20,000, and each face has its own now.
  if (face == Face::kBack && work.effort == Effort::kOnce) data.cells = {};
  return Outcome{same ? Change::kPart : Change::kAll};
}

namespace {

constexpr int kMeansTexels = 512;  // a side of what is left of maps that are not kept

int sample_step(const MapsSize& size) { return std::max(1, std::max(size.width, size.height) / kMeansTexels); }

/// Maps of a large draft take more memory than all else of it.
bool keeps_maps(const StageWork& work, const FaceData& f) {
  return work.data.coarse || int64_t{f.cloth.up.cols()} * f.cloth.up.rows() <= work.input.fineness.kept_crossings;
}

/// Frees them, once they are packed.
void drop_maps(FaceData& f, const std::vector<TexelRect>& baked) {
  const int step = sample_step(f.size);
  if (baked.empty()) f.means = subsampled(f.maps, step);
  for (const TexelRect& r : baked) subsample_into(f.means, f.maps, step, r);
  f.maps = {};
}

}  // namespace

base::Result<Outcome> update_maps(StageWork& work, Change input, Face face) {
  FaceData& f = work.face(face);
  if (input == Change::kPart) {
    if (!f.mapped) return Outcome{Change::kNone};
    const bool kept = f.means.coverage.width == 0;
    append(f.rebaked, kept ? rebake(f.maps, *f.mapped, f.cloth) : bake_changed(f.maps, *f.mapped, f.cloth, f.size));
    f.mapped.reset();
    return Outcome{f.rebaked.empty() ? Change::kNone : Change::kPart};
  }
  f.mapped.reset(), f.rebaked.clear();
  // The back is as coarse as the front: they share textures.
  bool& coarse = work.data.coarse;
  if (face == Face::kFront) coarse = work.quick();
  MapsSize size = (coarse ? quick_maps_size : maps_size)(f.cloth, work.input.shadows);
  for (int* side : {&size.width, &size.height}) *side = std::max(1, *side / work.input.fineness.map_divisor);
  f.size = size, f.means = {};
  f.maps = coarse ? bake_quick(f.cloth, size, {0, 0, size.width, size.height}) : bake(f.cloth, size);
  return Outcome{Change::kAll, coarse};
}

base::Result<Outcome> update_mips(StageWork& work, Change input, Face face) {
  FaceData& f = work.face(face);
  PackedFace& packed = work.packed(face);
  const std::vector<TexelRect> rebaked = std::exchange(f.rebaked, {});
  if (input == Change::kPart) {
    append(work.result.patches.maps, repack(packed, face, f.maps, rebaked));
    if (!keeps_maps(work, f) && !rebaked.empty()) drop_maps(f, rebaked);
    return Outcome{Change::kPart};
  }
  packed.textures = pack(f.maps, work.input.shadows).textures;
  work.result.all_maps = true;
  if (!keeps_maps(work, f)) drop_maps(f, {});
  if (work.effort == Effort::kOnce) {  // not asked for again
    f.maps.horizon.clear();
    f.maps.height_mm = {}, f.maps.thread = {};
  }
  return {};
}

base::Result<Outcome> update_cube_maps(StageWork& work, Change) {
  if (!work.input.shadows) return Outcome{Change::kNone};
  for (const Face face : {Face::kFront, Face::kBack}) {
    const Separable separable = factorise(cloth_brdf(work.face(face).cloth), Split::kHalfDifference);
    PackedFace& packed = work.packed(face);
    packed.cube_size = separable.first.size;
    packed.half_cube = cube_texels(separable.first);
    packed.difference_cube = cube_texels(separable.second);
  }
  work.result.all_maps = true;
  return {};
}

namespace {

/// Of the threads whose cells changed.
base::Result<Outcome> update_strips(StageWork& work, const Cloth& cloth, const CellRect& painted) {
  StageData& data = work.data;
  for (StripPatch& patch : cell_strips(cloth.up, painted)) {
    std::ranges::copy(patch.strips, data.packed.strips.begin() + static_cast<std::ptrdiff_t>(patch.first));
    work.result.patches.strips.push_back(std::move(patch));
  }
  return Outcome{Change::kPart};
}

}  // namespace

base::Result<Outcome> update_crossings(StageWork& work, Change input) {
  StageData& data = work.data;
  PackedCloth& packed = data.packed;
  const Cloth& cloth = work.face(Face::kFront).cloth;
  const CellRect painted = std::exchange(data.painted, {});
  const CellRect all{0, static_cast<int>(cloth.ends.size()), 0, static_cast<int>(cloth.picks.size())};
  if (input == Change::kPart) {
    if (!packed.strips.empty()) return update_strips(work, cloth, data.period == Period::kRepeat ? all : painted);
    if (packed.crossings.empty()) return Outcome{Change::kNone};
    const CellRect cells = data.period == Period::kRepeat ? all : touched_crossings(cloth, painted);
    const std::vector<glm::vec4> crossings = thread_crossings(cloth, cells);
    data.top_mm = std::max(data.top_mm, highest_thread(cloth, crossings));
    CrossingPatch patch{cells, packed_crossings(crossings), packed_asides(cloth, cells)};
    copy_into(packed, patch);
    work.result.patches.crossings.push_back(std::move(patch));
    return Outcome{Change::kPart};
  }
  packed.ends = all.end1, packed.picks = all.pick1;
  packed.crossings = {}, packed.asides = {}, packed.strips = {};
  if (int64_t{packed.ends} * packed.picks > kMaxCrossings) {
    data.top_mm = highest_thread(cloth);
    packed.strips = cell_strips(cloth.up);
    return {};
  }
  const std::vector<glm::vec4> crossings = thread_crossings(cloth, all);
  data.top_mm = cloth.layers.empty() ? highest_thread(cloth, crossings) : 0;
  packed.crossings = packed_crossings(crossings);
  packed.asides = packed_asides(cloth, all);
  return {};
}

}  // namespace weftlight::render_data
