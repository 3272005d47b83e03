#include "app/preview_pane.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace weftlight {
namespace {

constexpr double kRestS = 0.15;         // still for so long: draw every pixel
constexpr double kBusyPollS = 0.01;     // how often the worker is asked
constexpr double kMovingBudgetMs = 22;  // leaves room for the rest of a 33 ms frame
constexpr float kLeastScale = 0.3f;

}  // namespace

PreviewPane::PreviewPane() : renderer_(Renderer::create(problem_)) {
  if (!renderer_) problem_ = "The cloth cannot be shown: " + problem_;
}

void PreviewPane::submit(std::shared_ptr<const Design> design) { pipeline_.submit(std::move(design)); }

bool PreviewPane::poll() {
  if (!renderer_) return false;
  // Asked before the upload: what is finished in between is taken up by the next poll.
  const bool busy = pipeline_.busy();
  const bool changed = pipeline_.poll(*renderer_);
  if (changed) has_cloth_ = dirty_ = true;
  return changed || std::exchange(busy_, busy) != busy;
}

float PreviewPane::moving_scale() const {
  if (full_ms_ <= kMovingBudgetMs) return 1;
  return std::clamp(static_cast<float>(std::sqrt(kMovingBudgetMs / full_ms_)), kLeastScale, 1.0f);
}

void PreviewPane::draw(const Scene& scene, const Look& look, int width, int height, bool moving, double now_s) {
  if (!renderer_ || !has_cloth_ || width < 8 || height < 8) return;
  Key key{scene, look, width, height};
  const bool changed = dirty_ || !(key == drawn_);
  if (changed && moving) moved_s_ = now_s;
  const bool resting = now_s - moved_s_ >= kRestS;
  const float scale = resting ? 1.0f : moving_scale();
  if (!changed && drawn_scale_ >= scale) return;
  Frame frame;
  frame.width = width;
  frame.height = height;
  frame.render_scale = scale;
  stats_ = renderer_->draw(scene, look, frame);
  if (stats_.gpu_ms > 0) full_ms_ = stats_.gpu_ms / static_cast<double>(scale * scale);
  drawn_ = std::move(key);
  drawn_scale_ = scale;
  dirty_ = false;
}

double PreviewPane::next_s(double now_s) const {
  if (!renderer_) return -1;
  double next = busy_ || pipeline_.busy() ? kBusyPollS : -1;
  if (drawn_scale_ > 0 && drawn_scale_ < 1) {
    const double rest = std::max(0.0, moved_s_ + kRestS - now_s);
    next = next < 0 ? rest : std::min(next, rest);
  }
  return next;
}

PreviewPicture PreviewPane::picture() const {
  PreviewPicture p;
  p.texture = renderer_ && drawn_scale_ > 0 ? renderer_->texture() : 0;
  p.stats = stats_;
  p.problem = !problem_.empty() ? problem_ : pipeline_.problem();
  p.busy = renderer_ && pipeline_.busy();
  if (p.texture == 0 && p.problem.empty()) p.problem = "Weaving the cloth\xE2\x80\xA6";
  return p;
}

}  // namespace weftlight
