#include "session/jobs/reference_tracer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/loops.h"

namespace weftlight::session {

using base::core_count;
using cloth::Linear, cloth::linear_from_srgb;
using reference::TubeOptions;
using render_data::ReferenceView, render_data::lay_over;

namespace {

constexpr int kMaxSamples = 256;           // per pixel: noise is then invisible
constexpr int kCoarse = 4;                 // the first picture is smaller by this factor in each direction
constexpr int64_t kTriangles = 3'000'000;  // 400 MB, to leave memory for other programs

uint32_t packed(const float* rgb) {
  uint32_t out = 0xFF000000u;
  for (int k = 0; k < 3; ++k)
    out |= static_cast<uint32_t>(std::lround(255 * std::clamp(rgb[k], 0.0f, 1.0f))) << (8 * k);
  return out;
}

float squared(float x) { return x * x; }

Linear linear_of(const float* rgb) { return linear_from_srgb({rgb[0], rgb[1], rgb[2]}); }

/// Updates the running mean, weighted by sample counts.
void add(TracedImage& mean, const TracedImage& more, int before, int samples) {
  const float share = static_cast<float>(samples) / static_cast<float>(before + samples);
  for (size_t i = 0; i < mean.pixels.size(); ++i) mean.pixels[i] += (more.pixels[i] - mean.pixels[i]) * share;
}

int threads_to_use() {
  return std::max(1, core_count() - 1);  // one core is left for the window
}

}  // namespace

PictureComparison compare(Image around, const Image& preview, const TracedImage& traced, float exposure_ev) {
  lay_over(around, traced, exposure_ev, false);
  PictureComparison c{around.width, around.height, 0, {}, {}, 0, false};
  const size_t pixels = static_cast<size_t>(around.width) * static_cast<size_t>(around.height);
  c.reference.reserve(pixels);
  c.difference.reserve(pixels);
  double apart = 0, whole = 0;
  for (size_t i = 0; i < pixels; ++i) {
    const float* truth = &around.texels[i * static_cast<size_t>(around.channels)];
    const float* shown = &preview.texels[i * static_cast<size_t>(preview.channels)];
    float gap[3];
    for (int k = 0; k < 3; ++k) gap[k] = kDifferenceScale * std::abs(truth[k] - shown[k]);
    c.reference.push_back(packed(truth));
    c.difference.push_back(packed(gap));
    if (traced.width != around.width || traced.pixels[i].a <= 0) continue;
    const Linear a = linear_of(truth), b = linear_of(shown);
    apart += static_cast<double>(squared(a.r - b.r) + squared(a.g - b.g) + squared(a.b - b.b));
    whole += static_cast<double>(squared(a.r) + squared(a.g) + squared(a.b));
  }
  c.relative_error = whole > 0 ? static_cast<float>(std::sqrt(apart / whole)) : 0.0f;
  return c;
}

void ReferenceTracer::start(TraceJob job) {
  base::Task task;
  task.work = [this, job = std::move(job)](const base::RunningTask& running) { trace(job, running.stop()); };
  task.failed = [this](const base::Error& error, const base::RunningTask& running) { fail(error, running.stop()); };
  const std::lock_guard lock(mutex_);
  runner_.start(std::move(task));
  made_.reset();
}

void ReferenceTracer::stop() {
  const std::lock_guard lock(mutex_);
  runner_.stop();
  made_.reset();
}

bool ReferenceTracer::busy() const {
  const std::lock_guard lock(mutex_);
  return made_.has_value() || runner_.busy();
}

std::optional<base::Result<PictureComparison>> ReferenceTracer::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(made_, std::nullopt);
}

void ReferenceTracer::trace(const TraceJob& job, const std::stop_token& stop) {
  TubeOptions options;
  options.max_triangles = kTriangles;
  if (const auto updated = scene_.update(*job.design, options); !updated) return fail(updated.error(), stop);
  ReferenceView view;
  view.scene = job.scene;
  view.threads = threads_to_use();
  view.stop = stop;
  view.width = std::max(1, job.around.width / kCoarse), view.height = std::max(1, job.around.height / kCoarse);
  view.spp = 1;
  publish(compare(job.around, job.preview, scene_.trace(view, {}), job.exposure_ev), stop);

  view.width = job.around.width, view.height = job.around.height;
  TracedImage mean{view.width, view.height, {}};
  mean.pixels.resize(static_cast<size_t>(view.width) * static_cast<size_t>(view.height));
  // Passes of 1, 1, 2, 4, 8... samples: each doubles the total.
  for (int done = 0; done < kMaxSamples && !stop.stop_requested();) {
    view.first_sample = done;
    view.spp = std::max(1, done);
    add(mean, scene_.trace(view, {}), done, view.spp);
    done += view.spp;
    if (stop.stop_requested()) return;
    PictureComparison made = compare(job.around, job.preview, mean, job.exposure_ev);
    made.samples = done;
    made.finished = done >= kMaxSamples;
    publish(std::move(made), stop);
  }
}

/// Resets the scene: after an exception it may be a mix of two designs.
void ReferenceTracer::fail(const base::Error& error, const std::stop_token& stop) {
  scene_ = ReferenceScene();
  publish(base::Failure(error), stop);
}

void ReferenceTracer::publish(base::Result<PictureComparison> made, const std::stop_token& stop) {
  const std::lock_guard lock(mutex_);
  if (!stop.stop_requested()) made_ = std::move(made);
}

}  // namespace weftlight::session
