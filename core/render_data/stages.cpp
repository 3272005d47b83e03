#include "render_data/stages.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "base/loops.h"
#include "files/design_drape.h"
#include "render_data/cloth_stages.h"
#include "render_data/light_stages.h"
#include "render_data/scene_stages.h"
#include "render_data/visible_preview.h"

namespace weftlight::render_data {

using base::for_each_job;
using design::Lobes, design::Method, design::Yarn;
using draft::Draft, draft::Face;
using files::drape_key;

namespace {

/// A part of the design that stages read.
struct Part {
  Node node;
  bool (*same)(const StageInput& a, const StageInput& b);
};

bool same_draft(const StageInput& a, const StageInput& b) { return a.design->draft == b.design->draft; }

bool same_thread_table(const StageInput& a, const StageInput& b) {
  const Draft &s = a.design->draft, &t = b.design->draft;
  return s.warp == t.warp && s.weft == t.weft && s.palette == t.palette;
}

bool same_yarn_shapes(const StageInput& a, const StageInput& b) {
  return std::ranges::equal(a.design->yarns, b.design->yarns, [](Yarn s, Yarn t) {
    s.lobes = t.lobes = Lobes{};
    s.tex = t.tex = 0;  // weighs, and is not visible
    return s == t;
  });
}

bool same_yarn_lobes(const StageInput& a, const StageInput& b) {
  return std::ranges::equal(a.design->yarns, b.design->yarns, {}, &Yarn::lobes, &Yarn::lobes);
}

bool same_finish(const StageInput& a, const StageInput& b) {
  return a.design->finish == b.design->finish && same_shrinkage(a.design->plan, b.design->plan);
}
bool same_shadows(const StageInput& a, const StageInput& b) { return a.shadows == b.shadows; }
bool same_engine(const StageInput& a, const StageInput& b) { return a.engine == b.engine; }
bool same_drape(const StageInput& a, const StageInput& b) { return a.drape == b.drape; }
bool same_lights(const StageInput& a, const StageInput& b) { return a.design->scene.lights == b.design->scene.lights; }

using enum Node;
using enum WhenQuick;

constexpr std::array kParts = std::to_array<Part>({
    {kDraft, same_draft},
    {kThreadTable, same_thread_table},
    {kYarnShapes, same_yarn_shapes},
    {kYarnLobes, same_yarn_lobes},
    {kFinish, same_finish},
    {kShadows, same_shadows},
    {kEngine, same_engine},
    {kDrape, same_drape},
    {kLights, same_lights},
});

template <auto update, Face face>
base::Result<Outcome> of(StageWork& work, Change input) {
  return update(work, input, face);
}
constexpr auto kFront = Face::kFront, kBack = Face::kBack;

constexpr Nodes kLayout{kDrawdown, kPeriod, kThreadTable, kYarnShapes, kFinish};
constexpr Nodes kLobeData{kClothBlock, kResponse, kThreadErrors, kEngineBlock, kThreadRecords};

// The way of the data from the draft to what the renderer uploads. Each row: output, name, inputs, function, and what
// it does in a quick update. The outputs are in StageData. Maps are packed face by face, so that a single picture needs
// memory for the maps of one face only.
constexpr auto kClothStages = std::to_array<Stage>({
    // Threads in millimetres.
    {kDrawdown, "drawdown", {kDraft}, update_cells},
    {kPeriod, "period", {kDrawdown, kThreadTable, kYarnShapes, kFinish, kShadows}, update_period},
    {kFrontThreads, "front: threads", kLayout, of<update_threads, kFront>},
    {kBackThreads, "back: threads", {kFrontThreads}, of<update_threads, kBack>, kWaitsForWhole},  // reads kLayout, too
    // Their surface, in textures.
    {kFrontMaps, "front: maps", {kFrontThreads, kShadows}, of<update_maps, kFront>},
    {kFrontMips, "front: mips", {kFrontMaps, kShadows}, of<update_mips, kFront>},
    {kBackMaps, "back: maps", {kBackThreads, kShadows, kFrontMaps}, of<update_maps, kBack>, kWaitsForWhole},
    {kBackMips, "back: mips", {kBackMaps, kShadows}, of<update_mips, kBack>},
    {kCubeMaps, "cube maps", {kFrontThreads, kBackThreads, kShadows}, update_cube_maps},
    {kCrossings, "crossings", {kFrontThreads}, update_crossings},
    // The light that they send back, in uniform blocks and tables.
    {kLobes, "lobes", {kYarnLobes, kFrontThreads, kBackThreads}, update_lobes},
    {kClothBlock, "cloth block", {kLobes, kFrontMaps, kBackMaps, kFrontMips}, update_cloth_block},
    {kResponse, "response", {kLobes, kFrontMaps, kBackMaps, kClothBlock}, update_response, kWaitsOnceMade},
    {kThreadErrors, "thread errors", {kLobes, kCrossings}, update_thread_errors, kWaits},
    {kEngineBlock, "engine block", {kEngine, kLobes, kClothBlock}, update_engine_block, kWaits},
    {kThreadRecords, "thread records", {kLobes, kCrossings}, update_thread_records},
    {kClothLobes, "blocks and tables", kLobeData, hand_over_lobes},
});

// The scene around the cloth, on its own way.
constexpr auto kSceneStages = std::to_array<Stage>({
    {kLightRig, "lights", {kLights}, update_lights},
    {kMesh, "mesh", {kDrape}, update_mesh},
});

// A stage reads what stands above it.
constexpr bool is_in_order(std::span<const Stage> list) {
  std::array<bool, kNodes> made{};
  for (const Part& part : kParts) made[static_cast<size_t>(part.node)] = true;
  for (const Stage& stage : list) {
    for (const Node n : stage.inputs)
      if (!made[static_cast<size_t>(n)]) return false;
    if (std::exchange(made[static_cast<size_t>(stage.output)], true)) return false;
  }
  return true;
}
static_assert(is_in_order(kClothStages) && is_in_order(kSceneStages));

}  // namespace

StageInput Stages::next_input(std::shared_ptr<const Design> design) const {
  StageInput next;
  const Method method = design->look.method;
  next.fineness = fineness_;
  next.drape = drape_key(*design);
  next.shadows = input_.shadows || method == Method::kVrst03;
  // A comparison of methods asks for vrst03's maps, and gets those of engine, too.
  next.engine = input_.engine || next.shadows || method == Method::kEngine;
  next.design = std::move(design);
  return next;
}

bool Stages::preview(Effort effort) {
  // After a stop, packed() may already differ from what the renderer has.
  if (effort != Effort::kQuick || !done_ || result_.all_maps) return false;
  if (!preview_visible(data_, *done_, *input_.design, visible_, previewed_, result_)) return false;
  return previewed_ = true;
}

StageResult Stages::update(std::shared_ptr<const Design> design, Effort effort, const StageWatch& watch) {
  StageInput next = next_input(std::move(design));
  for (const Part& part : kParts)
    if (!input_.design || !part.same(input_, next)) keys_.changed(part.node);
  input_ = std::move(next);

  StageWork work{input_, effort, data_, result_};
  bool cloth = false, scene = false, preview_only = false;  // finished, or stopped before
  // A single picture whose drape or light cannot be read does not wait for its cloth.
  bool no_scene = false;
  std::stop_source given_up;
  const std::stop_callback asked(watch.stop, [&given_up] { given_up.request_stop(); });
  const StageWatch cloth_watch{given_up.get_token(), watch.starts};
  for_each_job(2, [&](int job) {
    if (job == 0) {
      scene = keys_.run(kSceneStages, work, effort, watch);
      no_scene = effort == Effort::kOnce && !keys_.made(kSceneStages);
      if (no_scene) given_up.request_stop();
    } else {
      cloth = (preview_only = preview(effort)) || keys_.run(kClothStages, work, effort, cloth_watch);
    }
  });
  if ((!cloth || !scene) && !no_scene) {
    StageResult nothing;
    nothing.stopped = true;
    return nothing;
  }
  return hand_over(preview_only, effort);
}

/// What changed, after all stages ran.
StageResult Stages::hand_over(bool preview_only, Effort effort) {
  StageResult& result = result_;
  result.made = keys_.made(kClothStages);
  if (!preview_only) {
    done_ = result.made ? input_.design : nullptr;
    // The whole maps replace a preview.
    if (previewed_ && effort != Effort::kQuick && done_) result.all_maps = true;
    if (result.all_maps) result.patches = {}, previewed_ = false;
  }
  if (result.made) result.made = keys_.made(kSceneStages);
  if (effort == Effort::kOnce) {
    StageData kept;
    kept.packed = std::move(data_.packed);
    data_ = std::move(kept);
    keys_ = {}, input_ = {}, done_ = nullptr;
  }
  return std::exchange(result_, {});
}

}  // namespace weftlight::render_data
