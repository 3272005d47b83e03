#include "app/preview_pane.h"

#include <chrono>
#include <utility>

#include "base/caught.h"
#include "base/text.h"
#include "gl/hidden_window.h"
#include "gl/open_headless.h"

namespace weftlight::app {

using base::caught, base::tr;
using gl::Pipeline;

namespace {

using Clock = std::chrono::steady_clock;
constexpr double kAgainS = 1;  // delay before a failed picture is drawn again

double seconds() { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); }

}  // namespace

PreviewPane::PreviewPane(std::function<void()> wake) : wake_window_(std::move(wake)), thread_([this] { work(); }) {}

PreviewPane::~PreviewPane() {
  {
    const std::lock_guard lock(mutex_);
    leaving_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void PreviewPane::submit(std::shared_ptr<const Design> design, const ClothSubject& subject) {
  shown_.submit(design, subject);
  {
    const std::lock_guard lock(mutex_);
    design_ = std::move(design);
    draft_ = subject.document;
    new_design_ = true;
  }
  wake_.notify_one();
}

void PreviewPane::ask(const PictureRequest& request, bool moving) {
  {
    const std::lock_guard lock(mutex_);
    if (request_ == request && moving_ == moving) return;
    request_ = request;
    moving_ = moving;
    new_request_ = true;
  }
  wake_.notify_one();
}

void PreviewPane::open_hidden_window_if_asked() {
  {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(asks_for_window_, false)) return;
  }
  HeadlessContext::Opened opened = gl::open_hidden_window();
  {
    const std::lock_guard lock(mutex_);
    hidden_window_ = std::move(opened);
  }
  wake_.notify_one();
}

HeadlessContext::Opened PreviewPane::ask_for_hidden_window() {
  {
    const std::lock_guard lock(mutex_);
    asks_for_window_ = true;
  }
  wake_window_();
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [this] { return leaving_ || hidden_window_; });
  if (!hidden_window_) return base::failure(base::ErrorKind::kCancelled, tr("the window was closed"));
  return *std::exchange(hidden_window_, std::nullopt);
}

bool PreviewPane::poll() {
  open_hidden_window_if_asked();
  std::optional<DrawnPicture> drawn;
  {
    const std::lock_guard lock(mutex_);
    drawn = std::exchange(drawn_, std::nullopt);
  }
  if (!drawn) return false;
  shown_.take(std::move(*drawn));
  return true;
}

/// Starts the computation of the cloth before the GL context is created.
std::shared_ptr<const Design> PreviewPane::first_design(Pipeline& pipeline) {
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [this] { return leaving_ || new_design_; });
  if (leaving_) return nullptr;
  new_design_ = false;
  pipeline.submit(design_, draft_);
  return design_;
}

void PreviewPane::work() {
  const base::Result<void> ended = caught([this] { weave_and_draw(); });
  if (context_) context_->release();
  if (!ended) fail(ended.error());
}

void PreviewPane::weave_and_draw() {
  gl::LostContexts lost;
  for (double begun = seconds(); draw_in_context(); begun = seconds()) {
    context_->release();
    lost_.push_back(std::move(context_));
    if (!lost.may_begin_again(seconds() - begun)) return fail(gl::LostContexts::problem());
    const std::lock_guard lock(mutex_);
    new_design_ = true;
    new_request_ = request_.has_value();
  }
}

bool PreviewPane::draw_in_context() {
  Pipeline pipeline;
  const std::shared_ptr<const Design> first = first_design(pipeline);
  if (!first) return false;
  auto opened = gl::open_headless([this] { return ask_for_hidden_window(); });
  if (!opened) return fail(opened.error()), false;
  context_ = std::move(*opened);
  const gl::ResetWatch watch;
  PictureMaker maker(pipeline);
  maker.follow(first);
  if (const base::Result<void> done = caught([&] { hand_over(maker, {}, false); }); !done)
    fail(done.error()), failed_ = true;
  return draw_while_there(maker, watch);
}

bool PreviewPane::draw_while_there(PictureMaker& maker, const gl::ResetWatch& watch) {
  double next_s = 0;
  std::unique_lock lock(mutex_);
  while (!leaving_) {
    const auto asked = [this] { return leaving_ || new_design_ || new_request_; };
    if (next_s < 0) wake_.wait(lock, asked);
    else wake_.wait_for(lock, std::chrono::duration<double>(next_s), asked);
    if (leaving_) return false;
    const std::shared_ptr<const Design> design = std::exchange(new_design_, false) ? design_ : nullptr;
    const uint64_t draft = draft_;
    new_request_ = false;
    std::optional<PictureRequest> request;
    base::Result<void> done = caught([&] { request = request_; });
    const bool moving = moving_;
    lock.unlock();
    if (done)
      done = caught([&] {
        if (design) maker.submit(design, draft);
        if (request) make(maker, *request, moving);
        failed_ = false;
        next_s = maker.next_s(seconds());
      });
    if (!done) {
      fail(done.error());
      failed_ = true;
      next_s = kAgainS;
    }
    if (watch.is_lost()) return true;
    lock.lock();
  }
  return false;
}

void PreviewPane::fail(const base::Error& error) {
  caught([&] {
    {
      const std::lock_guard lock(mutex_);
      drawn_ = undrawn_picture(error);
    }
    wake_window_();
  });
}

void PreviewPane::make(PictureMaker& maker, const PictureRequest& request, bool moving) {
  const bool told = maker.poll(), drawn = maker.draw(request, moving, seconds());
  if (told || drawn || failed_) hand_over(maker, request, drawn || failed_);
}

void PreviewPane::hand_over(const PictureMaker& maker, const PictureRequest& request, bool drawn) {
  DrawnPicture made = drawn_picture(maker, request, drawn);
  {
    const std::lock_guard lock(mutex_);
    // Pixels that were not taken yet and are not replaced stay valid.
    if (drawn_ && made.pixels.empty()) {
      made.pixels = std::move(drawn_->pixels), made.width = drawn_->width, made.height = drawn_->height;
      made.of = std::move(drawn_->of);
    }
    drawn_ = std::move(made);
  }
  wake_window_();
}

}  // namespace weftlight::app
