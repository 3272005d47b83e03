#include "app/preview_pane.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/caught.h"
#include "base/text.h"
#include "gl/context.h"

namespace weftlight::app {

using base::arg, base::caught, base::fill, base::message, base::tr;
using gl::HeadlessContext, gl::Pipeline;
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

bool PreviewPane::poll() {
  std::optional<News> news;
  {
    const std::lock_guard lock(mutex_);
    news = std::exchange(news_, std::nullopt);
  }
  if (!news) return false;
  if (!news->pixels.empty()) {
    texture_.set(news->width, news->height, news->pixels);
    const auto is_of = [&](const auto& one) { return one.first == news->of; };
    const auto of = std::find_if(subjects_.begin(), subjects_.end(), is_of);
    if (of != subjects_.end()) {
      shown_subject_ = of->second;
      subjects_.erase(subjects_.begin(), of);  // earlier ones come no more
    }
  }
  if (!news->reference.empty()) reference_texture_.set(news->reference_width, news->reference_height, news->reference);
  picture_ = std::move(news->picture);
  shown_ = std::move(news->made);
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
  const std::string why = caught([this] {
    Pipeline pipeline;
    const std::shared_ptr<const Design> first = first_design(pipeline);
    if (!first) return;
    const auto context = HeadlessContext::create();
    if (!context) return fail(message(context.error()));
    PictureMaker maker(pipeline);
    maker.follow(first);
    if (const std::string thrown = caught([&] { hand_over(maker, {}, false); }); !thrown.empty())
      fail(thrown), failed_ = true;
    draw_until_left(maker);
  });
  if (!why.empty()) fail(why);
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
    const std::string thrown = caught([&] {
      if (design) maker.submit(design);
      if (request) make(maker, *request, moving);
      failed_ = false;
      next_s = maker.next_s(seconds());
    });
    if (!thrown.empty()) {
      fail(thrown);
      failed_ = true;
      next_s = kAgainS;
    }
    lock.lock();
  }
}

void PreviewPane::fail(const std::string& why) {
  caught([&] {
    {
      const std::lock_guard lock(mutex_);
      news_ = News{};
      news_->picture.problem = fill(tr("The cloth cannot be shown: {problem}"), arg("problem", why));
    }
    wake_window_();
  });
}

void PreviewPane::make(PictureMaker& maker, const PictureRequest& request, bool moving) {
  const bool told = maker.poll(), drawn = maker.draw(request, moving, seconds());
  if (told || drawn || failed_) hand_over(maker, request, drawn || failed_);
}

void PreviewPane::hand_over(const PictureMaker& maker, const PictureRequest& request, bool drawn) {
  News made;
  if (drawn) {
    maker.read(made.width, made.height, made.pixels);
    made.of = maker.drawn_design();
  }
  const PictureComparison& c = maker.comparison();
  const bool compared = request.compare != Compare::kOff && !c.reference.empty();
  if (compared) made.reference = request.compare == Compare::kSplit ? c.reference : c.difference;
  made.reference_width = c.width, made.reference_height = c.height;
  made.picture.stats = maker.stats();
  made.picture.tolerance = maker.tolerance();
  made.picture.budget_ms = request.budget_ms;
  made.picture.problem = maker.problem();
  made.picture.busy = maker.busy();
  made.picture.refining = maker.can_refine();
  made.picture.reference = {compared ? 1u : 0u, c.samples, c.relative_error, !c.finished, c.problem};
  if (!made.picture.busy) made.made = maker.design();
  {
    const std::lock_guard lock(mutex_);
    // Pixels that were not taken yet and are not replaced stay valid.
    if (news_ && made.pixels.empty())
      made.pixels = std::move(news_->pixels), made.width = news_->width, made.height = news_->height,
      made.of = std::move(news_->of);
    news_ = std::move(made);
  }
  wake_window_();
}

}  // namespace weftlight::app
