#include "app/preview_pane.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/caught.h"
#include "base/text.h"
#include "gl/hidden_window.h"

namespace weftlight::app {

using base::arg, base::caught, base::fill, base::message, base::tr;
using gl::Pipeline;
using session::Compare, session::PictureComparison;

namespace {

using Clock = std::chrono::steady_clock;
constexpr size_t kMaxSubjects = 64;  // while no picture comes
constexpr double kAgainS = 1;        // delay before a failed picture is drawn again

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
  submitted_ = design;
  subject_ = subject;
  subjects_.emplace_back(design, subject);
  if (subjects_.size() > kMaxSubjects) subjects_.pop_front();
  {
    const std::lock_guard lock(mutex_);
    design_ = std::move(design);
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
  std::optional<Drawn> drawn;
  {
    const std::lock_guard lock(mutex_);
    drawn = std::exchange(drawn_, std::nullopt);
  }
  if (!drawn) return false;
  if (!drawn->pixels.empty()) {
    texture_.set(drawn->width, drawn->height, drawn->pixels);
    const auto is_of = [&](const auto& one) { return one.first == drawn->of; };
    const auto of = std::find_if(subjects_.begin(), subjects_.end(), is_of);
    if (of != subjects_.end()) {
      shown_subject_ = of->second;
      subjects_.erase(subjects_.begin(), of);  // earlier ones come no more
    }
  }
  if (!drawn->reference.empty())
    reference_texture_.set(drawn->reference_width, drawn->reference_height, drawn->reference);
  picture_ = std::move(drawn->picture);
  shown_ = std::move(drawn->made);
  return true;
}

PreviewPicture PreviewPane::picture() const {
  PreviewPicture p = picture_;
  p.texture = shown_subject_ == subject_ ? texture_.name() : 0;
  if (p.reference.texture != 0) p.reference.texture = reference_texture_.name();
  p.busy = p.problem.empty() && (p.busy || shown_ != submitted_);
  if (p.texture == 0 && p.problem.empty()) p.problem = tr("Weaving the cloth\xE2\x80\xA6");
  return p;
}

/// Starts the computation of the cloth before the GL context is created.
std::shared_ptr<const Design> PreviewPane::first_design(Pipeline& pipeline) {
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [this] { return leaving_ || new_design_; });
  if (leaving_) return nullptr;
  new_design_ = false;
  pipeline.submit(design_);
  return design_;
}

void PreviewPane::work() {
  const base::Result<void> ended = caught([this] { weave_and_draw(); });
  if (context_) context_->release();
  if (!ended) fail(ended.error());
}

void PreviewPane::weave_and_draw() {
  Pipeline pipeline;
  const std::shared_ptr<const Design> first = first_design(pipeline);
  if (!first) return;
  auto opened = HeadlessContext::create([this] { return ask_for_hidden_window(); });
  if (!opened) return fail(opened.error());
  context_ = std::move(*opened);
  PictureMaker maker(pipeline);
  maker.follow(first);
  if (const base::Result<void> done = caught([&] { hand_over(maker, {}, false); }); !done)
    fail(done.error()), failed_ = true;
  draw_until_left(maker);
}

void PreviewPane::draw_until_left(PictureMaker& maker) {
  double next_s = 0;
  std::unique_lock lock(mutex_);
  while (!leaving_) {
    const auto asked = [this] { return leaving_ || new_design_ || new_request_; };
    if (next_s < 0) wake_.wait(lock, asked);
    else wake_.wait_for(lock, std::chrono::duration<double>(next_s), asked);
    if (leaving_) return;
    const std::shared_ptr<const Design> design = std::exchange(new_design_, false) ? design_ : nullptr;
    new_request_ = false;
    const std::optional<PictureRequest> request = request_;
    const bool moving = moving_;
    lock.unlock();
    const base::Result<void> done = caught([&] {
      if (design) maker.submit(design);
      if (request) make(maker, *request, moving);
      failed_ = false;
      next_s = maker.next_s(seconds());
    });
    if (!done) {
      fail(done.error());
      failed_ = true;
      next_s = kAgainS;
    }
    lock.lock();
  }
}

void PreviewPane::fail(const base::Error& error) {
  caught([&] {
    {
      const std::lock_guard lock(mutex_);
      drawn_ = Drawn{};
      drawn_->picture.problem = fill(tr("The cloth cannot be shown: {problem}"), arg("problem", message(error)));
    }
    wake_window_();
  });
}

void PreviewPane::make(PictureMaker& maker, const PictureRequest& request, bool moving) {
  const bool told = maker.poll(), drawn = maker.draw(request, moving, seconds());
  if (told || drawn || failed_) hand_over(maker, request, drawn || failed_);
}

void PreviewPane::hand_over(const PictureMaker& maker, const PictureRequest& request, bool drawn) {
  Drawn made;
  if (drawn) {
    maker.read(made.width, made.height, made.pixels);
    made.of = maker.drawn_design();
  }
  const base::Result<PictureComparison>& traced = maker.comparison();
  const PictureComparison c = traced.value_or(PictureComparison{});
  const bool compared = request.compare != Compare::kOff && !c.reference.empty();
  if (compared) made.reference = request.compare == Compare::kSplit ? c.reference : c.difference;
  made.reference_width = c.width, made.reference_height = c.height;
  made.picture.stats = maker.stats();
  made.picture.tolerance = maker.tolerance();
  made.picture.budget_ms = request.budget_ms;
  made.picture.problem = maker.problem();
  made.picture.busy = maker.busy();
  made.picture.refining = maker.can_refine();
  made.picture.reference = {compared ? 1u : 0u, c.samples, c.relative_error, !c.finished, {}};
  if (!traced)
    made.picture.reference.problem =
        fill(tr("No ray-traced picture: {problem}"), arg("problem", message(traced.error())));
  if (!made.picture.busy) made.made = maker.design();
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
