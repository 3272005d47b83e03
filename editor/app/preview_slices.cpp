#include "app/preview_slices.h"

#include <chrono>
#include <utility>

#include "base/caught.h"

namespace weftlight::app {

using base::caught;

namespace {

constexpr double kAgainS = 1;  // delay before a failed picture is drawn again

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

PreviewSlices::PreviewSlices(const std::function<void()>& /*wake*/) : begun_s_(seconds()) { pipeline_.emplace(); }

void PreviewSlices::submit(std::shared_ptr<const Design> design, const ClothSubject& subject) {
  shown_.submit(design, subject);
  // The cloth is computed while the first frames are drawn.
  if (!maker_) pipeline_->submit(design, subject.document);
  draft_ = subject.document;
  design_ = std::move(design);
  new_design_ = true;
}

void PreviewSlices::ask(const PictureRequest& request, bool moving) {
  if (request_ == request && moving_ == moving) return;
  request_ = request;
  moving_ = moving;
  new_request_ = true;
}

bool PreviewSlices::begin_anew() {
  maker_.reset();
  pipeline_.emplace();
  given_up_ = !lost_.may_begin_again(seconds() - begun_s_);
  if (given_up_) return false;
  watch_ = gl::ResetWatch();
  begun_s_ = seconds();
  if (design_) pipeline_->submit(design_, draft_);
  new_request_ = request_.has_value();
  return true;
}

bool PreviewSlices::poll() {
  if (given_up_) return false;
  if (watch_.is_lost() && !begin_anew()) {
    shown_.take(undrawn_picture(gl::LostContexts::problem()));
    return true;
  }
  // The first request comes with the first frame: the window is seen before shaders are compiled.
  if (!design_ || !request_) return false;
  if (!new_design_ && !new_request_ && (next_s_ < 0 || seconds() < next_s_)) return false;
  bool told = false;
  const base::Result<void> done = caught([&] { told = make(); });
  failed_ = !done;
  if (done) return told;
  next_s_ = seconds() + kAgainS;
  shown_.take(undrawn_picture(done.error()));
  return true;
}

/// True if there is something to show.
bool PreviewSlices::make() {
  if (!maker_) {
    maker_ = std::make_unique<PictureMaker>(*pipeline_);
    maker_->follow(design_);
    new_design_ = false;
  }
  if (std::exchange(new_design_, false)) maker_->submit(design_, draft_);
  new_request_ = false;
  const bool told = maker_->poll(), drawn = maker_->draw(*request_, moving_, seconds());
  const double next = maker_->next_s(seconds());
  next_s_ = next < 0 ? next : seconds() + next;
  if (!told && !drawn && !failed_) return false;
  shown_.take(drawn_picture(*maker_, *request_, drawn || failed_));
  return true;
}

}  // namespace weftlight::app
