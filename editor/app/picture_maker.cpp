#include "app/picture_maker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "light/formulas.h"

namespace weftlight::app {

using base::arg, base::fill, base::message, base::tr;
using design::Method;
using session::PictureComparison;

namespace {

constexpr double kRestS = 0.15;         // rest before full resolution
constexpr double kBusyRestS = 2;        // the same while the pipeline works: its result replaces the picture soon
constexpr double kBusyPollS = 0.01;     // polling interval of the pipeline
constexpr double kTracePollS = 0.1;     // polling interval of the ray tracer
constexpr double kCompilePollS = 0.03;  // polling interval of the driver's compiler
constexpr double kMovingBudgetMs = 22;  // leaves room for the rest of a 33 ms frame
constexpr int kMaxAPass = 4;            // the lattice of 8 samples
// That of 2. Each sample stands for its part of the pixel: one alone, as wide as all of it, is 4 % too dark near
// threads.
constexpr int kMinAPass = 1;
constexpr double kPassMs = 30;   // below it the next pass has more samples, above twice it fewer
constexpr float kAsGood = 0.1f;  // relative; smaller differences of the tolerance are ignored
constexpr float kMinScale = 0.3f, kMaxMovingScale = 0.9f;

}  // namespace

PictureMaker::PictureMaker(Pipeline& pipeline, double refine_ms) : pipeline_(pipeline), refine_ms_(refine_ms) {
  auto made = Renderer::create();
  if (made) renderer_ = std::move(*made);
  else problem_ = fill(tr("The cloth cannot be shown: {problem}"), arg("problem", message(made.error())));
}

void PictureMaker::submit(std::shared_ptr<const Design> design, uint64_t draft) {
  pipeline_.submit(design, draft);
  follow(std::move(design));
}

void PictureMaker::follow(std::shared_ptr<const Design> design) {
  design_ = std::move(design);
  tracer_.stop();
  traced_ = false;
}

bool PictureMaker::poll() {
  if (!renderer_) return false;
  // Read before the upload, so that work finished in between is taken by the next poll.
  const bool busy = pipeline_.busy();
  const bool changed = pipeline_.poll(*renderer_);
  if (changed) has_cloth_ = dirty_ = true;
  if (std::optional<base::Result<PictureComparison>> made = tracer_.take()) {
    comparison_ = std::move(*made);
    return true;
  }
  return changed || std::exchange(busy_, busy) != busy;
}

float PictureMaker::moving_scale() const {
  constexpr float kFirstOnSoftware = 0.5f;  // nothing has been timed, and shaders are being compiled
  if (full_ms_ <= 0 && moving_ms_ <= 0 && renderer_->is_software()) return kFirstOnSoftware;
  // Moving pictures use cheaper shading methods: a third is a guess until one has been timed.
  const double all_pixels_ms = moving_ms_ > 0 ? moving_ms_ : full_ms_ / 3;
  if ((full_ms_ > 0 ? full_ms_ : all_pixels_ms) <= kMovingBudgetMs) return 1;
  return std::clamp(static_cast<float>(std::sqrt(kMovingBudgetMs / all_pixels_ms)), kMinScale, kMaxMovingScale);
}

Frame PictureMaker::frame_of(const PictureRequest& request) const {
  Frame frame;
  frame.width = request.width;
  frame.height = request.height;
  frame.false_color_methods = request.show_methods;
  frame.at_once = true;
  return frame;
}

bool PictureMaker::draw(const PictureRequest& request, bool moving, double now_s) {
  if (!renderer_ || !has_cloth_ || request.width < 8 || request.height < 8) return false;
  PictureRequest picture = request;
  picture.compare = drawn_.compare;  // does not change what is drawn
  const bool other = !(picture == drawn_);
  const bool changed = dirty_ || other;
  // The final result of the pipeline is drawn at full resolution at once.
  if (changed && (moving || other || pipeline_.busy())) moved_s_ = now_s;
  const bool resting = now_s - moved_s_ >= rest_s();
  const float scale = resting ? 1.0f : moving_scale();
  const bool anew = changed || stats_.compiling || drawn_scale_ < scale, finer = !anew && can_refine();
  if (anew) {
    begin_passes();
    held_used_ = false;
    draw_pass(request, scale);
    dirty_ = false;
  } else if (finer) {
    draw_pass(request, scale);
  }
  const bool other_comparison = drawn_.compare != request.compare;
  drawn_ = request;
  follow_reference(request, changed);
  return anew || finer || other_comparison;
}

double PictureMaker::rest_s() const { return pipeline_.busy() ? kBusyRestS : kRestS; }

bool PictureMaker::can_refine() const {
  const bool threads =
      stats_.method == Method::kYarn || (stats_.method == Method::kAuto && stats_.method_weights[0] > 0.005f);
  return threads && !stats_.compiling && drawn_scale_ == 1 && samples_ < all_samples_ && spent_ms_ < refine_ms_;
}

Look PictureMaker::look_for(const PictureRequest& request) {
  Look look = request.look;
  if (request.budget_ms > 0 && held_ > 0) look.tolerance = held_;
  tolerance_ = look.tolerance;
  return look;
}

void PictureMaker::begin_passes() {
  passes_ = samples_ = 0;
  spent_ms_ = 0;
}

/// Draws one more pass of a resting picture, or a moving picture.
void PictureMaker::draw_pass(const PictureRequest& request, float scale) {
  Frame frame = frame_of(request);
  frame.render_scale = scale;
  frame.timed = true;
  if (passes_ == 0 && ms_a_sample_ > 0)
    all_samples_ =
        static_cast<int>(std::clamp(refine_ms_ / ms_a_sample_, 1.0, static_cast<double>(formulas::kMaxYarnSamples)));
  const int samples = formulas::lattice_of(lattice_a_pass_).x;
  frame.samples = samples;
  frame.all_samples = all_samples_;
  if (scale == 1)
    frame.pass = passes_, frame.pass_weight = static_cast<float>(samples) / static_cast<float>(samples_ + samples);
  stats_ = renderer_->draw(request.scene, look_for(request), frame);
  pipeline_.set_visible_part(renderer_->visible_part());
  if (scale == 1) stats_ = renderer_->measure();
  if (stats_.compiling) {
    drawn_scale_ = scale;
    return;
  }
  // The time of the compiler would be taken for that of every pass, and the picture would get no further samples.
  if (scale == 1 && stats_.first_of_program) return draw_pass(request, scale);
  if (scale == 1 && passes_ == 0 && request.budget_ms > 0 && stats_.method == Method::kAuto) {
    const float held = renderer_->tolerance_within(request.budget_ms);
    // Once per picture: its cost gives the tolerance for the budget.
    const bool other = held > 0 && !held_used_ && std::abs(held - tolerance_) > kAsGood * tolerance_;
    if (held > 0) held_ = held;
    held_used_ = true;
    if (other) return draw_pass(request, scale);
  }
  if (stats_.gpu_ms > 0 && passes_ == 0 && !stats_.first_of_program)
    (scale < 1 ? moving_ms_ : full_ms_) = stats_.gpu_ms / static_cast<double>(scale * scale);
  drawn_scale_ = scale;
  if (scale < 1) return;
  constexpr float kMostlyThreads = 0.3f;
  const bool first_cost = ms_a_sample_ == 0;
  if (stats_.gpu_ms > 0 && stats_.method_weights[0] > kMostlyThreads) ms_a_sample_ = stats_.gpu_ms / samples;
  // Only now it is known how many samples there is time for.
  if (first_cost && ms_a_sample_ > 0) return begin_passes();
  ++passes_;
  samples_ += samples;
  spent_ms_ += stats_.gpu_ms;
  if (stats_.gpu_ms < kPassMs) lattice_a_pass_ = std::min(kMaxAPass, lattice_a_pass_ + 1);
  if (stats_.gpu_ms > 2 * kPassMs) lattice_a_pass_ = std::max(kMinAPass, lattice_a_pass_ - 1);
}

void PictureMaker::follow_reference(const PictureRequest& request, bool changed) {
  if (changed || request.compare == Compare::kOff) {
    if (traced_ || (comparison_ && !comparison_->reference.empty())) tracer_.stop();
    traced_ = false;
    comparison_ = session::PictureComparison{};
  }
  if (request.compare == Compare::kOff) return;
  if (!traced_ && drawn_scale_ == 1 && !can_refine() && !busy()) {
    tracer_.start(job_of(request));
    traced_ = true;
  }
}

/// Draws the shown picture again afterwards.
TraceJob PictureMaker::job_of(const PictureRequest& request) {
  TraceJob job{design_, request.scene, 0, {}, {}};
  Frame frame = frame_of(request);
  if (request.show_methods) {
    frame.false_color_methods = false;
    frame.samples = formulas::lattice_of(lattice_a_pass_).x, frame.all_samples = all_samples_;
    renderer_->draw(request.scene, request.look, frame);
  }
  job.preview = renderer_->read_back();
  frame.cloth = false;
  job.exposure_ev = renderer_->draw(request.scene, request.look, frame).exposure_ev;
  job.around = renderer_->read_back();
  begin_passes();
  draw_pass(request, 1);
  return job;
}

double PictureMaker::next_s(double now_s) const {
  if (!renderer_) return -1;
  double next = busy_ || pipeline_.busy() ? kBusyPollS : -1;
  const auto sooner = [&next](double s) { next = next < 0 ? s : std::min(next, s); };
  if (tracer_.busy()) sooner(kTracePollS);
  if (stats_.compiling) sooner(kCompilePollS);
  if (can_refine()) sooner(0);
  if (drawn_scale_ > 0 && drawn_scale_ < 1) {
    sooner(std::max(0.0, moved_s_ + rest_s() - now_s));
  }
  return next;
}

void PictureMaker::read(int& width, int& height, std::vector<uint32_t>& pixels) const {
  width = drawn_.width, height = drawn_.height;
  if (renderer_ && drawn_scale_ > 0) renderer_->read_pixels(pixels);
  else pixels.clear();
}

}  // namespace weftlight::app
