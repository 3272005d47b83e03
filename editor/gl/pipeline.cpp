#include "gl/pipeline.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "base/tasks.h"
#include "base/text.h"
#include "render_data/stages.h"

namespace weftlight::gl {

using base::ErrorKind, base::failure, base::tr;
using render_data::ClothLobes, render_data::ClothPatches, render_data::Effort, render_data::PackedCloth,
    render_data::PreparedMesh, render_data::StageResult, render_data::Stages;
using scene::LightRig;

namespace {

template <class T>
void append(std::vector<T>& to, std::vector<T> more) {
  to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

struct Pipeline::Parts {
  // Guards everything below except `stages`, which belongs to the runner; its packed maps are read by the thread with
  // the GL context under `maps`.
  mutable std::mutex mutex;
  std::mutex maps;
  std::optional<PreparedMesh> mesh;
  std::optional<LightRig> lights;
  bool all_maps = false;                  // stages.packed() is new as a whole
  std::optional<PackedCloth> quick_maps;  // or these are; patches follow them
  ClothPatches patches;
  std::optional<ClothLobes> lobes;
  std::shared_ptr<const Design> handed, uploaded;  // the designs that those are of, and that the renderer has
  base::Result<void> made;                         // of the last design
  VisiblePart visible;
  bool quick_drawn = true;
  std::condition_variable_any drawn;
  Stages stages;
  uint64_t draft = 0;  // that `stages` are of; for the runner
  // Constructed last and destroyed first: its tasks use all of the above.
  base::TaskRunner runner;

  void begin_anew();
  void follow(uint64_t submitted);
  void fail(const base::Error& error);
  void compute(const std::shared_ptr<const Design>& design, Effort effort, const std::stop_token& stop = {});
  void wait_for_picture(const std::stop_token& stop);
  void hand_over(const std::shared_ptr<const Design>& design, StageResult result, std::optional<PackedCloth> copy);
  bool upload(Renderer& renderer, bool wait);
  bool has_updates() const { return mesh || lights || all_maps || quick_maps || !patches.empty() || lobes; }
};

/// Quick maps are small: a copy is handed over, so that they can be uploaded while the full ones are computed.
void Pipeline::Parts::compute(const std::shared_ptr<const Design>& design, Effort effort, const std::stop_token& stop) {
  // Held through the hand-over, so that maps and patches are uploaded in order.
  const std::lock_guard hold(maps);
  {
    const std::lock_guard lock(mutex);
    stages.set_visible_part(visible);
  }
  StageResult result = stages.update(design, effort, {stop, {}});
  if (result.stopped) return;
  std::optional<PackedCloth> copy;
  if (result.all_maps && effort == Effort::kQuick) copy = stages.packed();
  hand_over(design, std::move(result), std::move(copy));
}

/// The next design is computed from the start. Under both mutexes.
void Pipeline::Parts::begin_anew() {
  stages = Stages();
  all_maps = false;
  patches = {};
}

void Pipeline::Parts::follow(uint64_t submitted) {
  if (std::exchange(draft, submitted) == submitted) return;
  const std::lock_guard hold(maps);
  const std::lock_guard lock(mutex);
  begin_anew();
}

/// Stages that threw may hold half of the design.
void Pipeline::Parts::fail(const base::Error& error) {
  const std::lock_guard hold(maps);
  const std::lock_guard lock(mutex);
  begin_anew();
  made = base::failure(error.kind, base::fill(base::tr("The cloth cannot be computed: {problem}"),
                                              base::arg("problem", message(error))));
}

/// Waits until the quick result is drawn, since drawing may need the same cores.
void Pipeline::Parts::wait_for_picture(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kLongest{400};
  std::unique_lock lock(mutex);
  drawn.wait_for(lock, stop, kLongest, [this] { return quick_drawn; });
}

void Pipeline::Parts::hand_over(const std::shared_ptr<const Design>& design, StageResult result,
                                std::optional<PackedCloth> copy) {
  const std::lock_guard lock(mutex);
  handed = design;
  if (result.mesh) mesh = std::move(result.mesh);
  if (result.lights) lights = std::move(result.lights);
  if (result.all_maps) {
    quick_maps = std::move(copy);
    all_maps = !quick_maps;
    quick_drawn = !quick_maps;
    patches = {};
    lobes.reset();
  }
  if (!all_maps) {
    append(patches.maps, std::move(result.patches.maps));
    append(patches.crossings, std::move(result.patches.crossings));
    append(patches.strips, std::move(result.patches.strips));
    if (!result.all_maps && result.lobes) lobes = std::move(result.lobes);
  }
  made = std::move(result.made);
}

bool Pipeline::Parts::upload(Renderer& renderer, bool wait) {
  // The runner locks its maps while it computes: then the last good ones stay on screen.
  std::unique_lock hold(maps, std::defer_lock);
  if (wait) hold.lock();
  std::unique_lock lock(mutex);
  if (all_maps && !wait && !hold.try_lock()) return false;
  const bool changed = has_updates() || uploaded != handed;
  uploaded = handed;
  if (mesh) renderer.set_mesh(std::move(*mesh));
  mesh.reset();
  if (lights) renderer.set_lights(std::move(*lights));
  lights.reset();
  if (all_maps) renderer.upload(stages.packed());
  if (quick_maps) renderer.upload(*quick_maps);
  if (!patches.empty()) renderer.upload(patches);
  if (lobes) renderer.upload_lobes(*lobes);
  all_maps = false;
  quick_maps.reset();
  patches = {};
  lobes.reset();
  return changed;
}

Pipeline::Pipeline() : parts_(std::make_unique<Parts>()) {}
Pipeline::~Pipeline() = default;

void Pipeline::submit(std::shared_ptr<const Design> design, uint64_t draft) {
  base::Task task;
  task.work = [parts = parts_.get(), design = std::move(design), draft](const base::RunningTask& running) {
    parts->follow(draft);
    // A quick update is finished even if a newer design waits, so that a stroke shows while it is drawn.
    parts->compute(design, Effort::kQuick);
    parts->wait_for_picture(running.stop());
    if (!running.stopped()) parts->compute(design, Effort::kFull, running.stop());
  };
  task.failed = [parts = parts_.get()](const base::Error& error, const base::RunningTask&) { parts->fail(error); };
  parts_->runner.start(std::move(task));
}

void Pipeline::set_visible_part(const VisiblePart& visible) {
  const std::lock_guard lock(parts_->mutex);
  parts_->visible = visible;
  if (parts_->quick_drawn || parts_->quick_maps) return;
  parts_->quick_drawn = true;
  parts_->drawn.notify_all();
}

bool Pipeline::poll(Renderer& renderer) { return parts_->upload(renderer, false); }

void Pipeline::wait() const { parts_->runner.wait(); }

base::Result<void> Pipeline::finish(Renderer& renderer) {
  wait();
  parts_->upload(renderer, true);
  return made();
}

base::Result<void> Pipeline::made() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->made;
}

std::shared_ptr<const Design> Pipeline::uploaded() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->uploaded;
}

bool Pipeline::busy() const {
  if (parts_->runner.busy()) return true;
  const std::lock_guard lock(parts_->mutex);
  return parts_->has_updates();
}

base::Result<void> upload_once(std::shared_ptr<const Design> design, Renderer& renderer, const StageWatch& watch,
                               bool cloth) {
  // An open cloth lets light onto the ground, by the cover of its maps.
  constexpr render_data::Fineness kUnseen{.response_samples = 32};
  Stages stages(cloth ? render_data::Fineness() : kUnseen);
  StageResult result = stages.update(std::move(design), Effort::kOnce, watch);
  if (result.stopped) return failure(ErrorKind::kCancelled, tr("stopped"));
  if (result.mesh) renderer.set_mesh(std::move(*result.mesh));
  if (result.lights) renderer.set_lights(std::move(*result.lights));
  if (result.all_maps) renderer.upload(stages.release_packed());
  return result.made;
}

}  // namespace weftlight::gl
