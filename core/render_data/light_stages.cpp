#include "render_data/light_stages.h"

#include <algorithm>

#include "base/loops.h"
#include "design/finish.h"
#include "render_data/cloth_block.h"
#include "render_data/engine_block.h"
#include "render_data/face_cloth.h"
#include "render_data/response_block.h"
#include "render_data/thread_block.h"

namespace weftlight::render_data {

using base::for_each_job;
using cloth::Cloth, cloth::Period;
using design::Design, design::Yarn, design::finished;
using draft::BitMatrix, draft::Face, draft::drawdown;
using light::ThreadErrors, light::thread_errors;

namespace {

constexpr int kQuickSamples = 256;

FaceInput face_input(const StageWork& work, Face face) {
  const FaceData& f = work.face(face);
  return {f.cloth, f.means.coverage.width > 0 ? f.means : f.maps};
}

}  // namespace

base::Result<Outcome> update_lobes(StageWork& work, Change) {
  const std::vector<Yarn> yarns = finished(work.design().yarns, work.design().finish);
  for (FaceData& face : work.data.faces) {
    const size_t n = std::min(face.cloth.yarns.size(), yarns.size());
    for (size_t i = 0; i < n; ++i) face.cloth.yarns[i].lobes = yarns[i].lobes;
  }
  return {};
}

base::Result<Outcome> update_cloth_block(StageWork& work, Change) {
  PackedCloth& packed = work.data.packed;
  interop::ClothData data = cloth_block(face_input(work, Face::kFront), face_input(work, Face::kBack));
  data.even_yarns = even_from_yarns(packed.front, packed.width_mm, packed.mean_spacing_mm);
  if (!packed.lobes.response.empty()) keep_response(data, packed.lobes.data);
  packed.lobes.data = data;
  return {};
}

base::Result<Outcome> update_response(StageWork& work, Change) {
  ClothLobes& lobes = work.data.packed.lobes;
  const int full = work.input.fineness.response_samples;
  lobes.response = response_tables(lobes.data, face_input(work, Face::kFront), face_input(work, Face::kBack),
                                   work.quick() ? std::min(kQuickSamples, full) : full);
  return Outcome{Change::kAll, work.quick()};
}

base::Result<Outcome> update_thread_errors(StageWork& work, Change) {
  PackedCloth& packed = work.data.packed;
  packed.lobes.errors = packed.has_threads() ? thread_errors(work.face(Face::kFront).cloth) : ThreadErrors{};
  return {};
}

base::Result<Outcome> update_engine_block(StageWork& work, Change) {
  if (!work.input.engine) return Outcome{Change::kNone};
  const Design& design = work.design();
  interop::ClothData& data = work.data.packed.lobes.data;
  // After a single picture they are given up already.
  const BitMatrix cells = work.data.cells.rows() > 0 ? work.data.cells : drawdown(design.draft);
  for_each_job(2, [&](int f) {
    const interop::SystemData *warp = &data.systems[2 * f], *weft = warp + 1;
    const float cover = std::max(warp->coverage + weft->coverage, 1e-6f);
    const Cloth repeat = face_cloth(design, cells, f == 0 ? Face::kFront : Face::kBack, Period::kRepeat);
    data.engine[f] = engine_block(repeat, weft->coverage / cover);
  });
  return {};
}

base::Result<Outcome> update_thread_records(StageWork& work, Change) {
  PackedCloth& packed = work.data.packed;
  packed.lobes.threads.clear();
  if (packed.has_threads()) packed.lobes.threads = thread_records(work.face(Face::kFront).cloth, work.data.top_mm);
  return {};
}

base::Result<Outcome> hand_over_lobes(StageWork& work, Change) {
  work.result.lobes = work.data.packed.lobes;
  return {};
}

}  // namespace weftlight::render_data
