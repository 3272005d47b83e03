#include "session/jobs/draper.h"

#include <cmath>
#include <utility>

#include "base/text.h"
#include "files/design_drape.h"

namespace weftlight::session {

using base::arg;
using base::fill;
using base::tr;

namespace {

constexpr float kStep = 0.01f;  // progress that is worth redrawing the window

}  // namespace

Edit simulated_drape_edit(bool own) {
  return {own ? tr("Simulate this fabric") : tr("Use the generic drape"), [own](Design d) {
            d.scene.simulated_drape = own;
            return d;
          }};
}

Draper::Draper(std::function<void()> wake) : wake_(std::move(wake)) {}

void Draper::follow(const std::shared_ptr<const Design>& design) {
  std::string wanted = design->scene.simulated_drape ? files::kept_drape_path(*design) : std::string();
  {
    const std::lock_guard lock(mutex_);
    if (wanted == wanted_) return;
    wanted_ = wanted;
    state_ = {wanted.empty() ? DrapeStage::kShipped : DrapeStage::kFalling, 0, {}};
    news_.any = true;
  }
  runner_.stop();
  if (wanted.empty()) return;
  base::Task task;
  task.work = [this, design, wanted = std::move(wanted)](const base::RunningTask& running) {
    run(*design, wanted, running.stop());
  };
  task.failed = [this](const std::string& why, const base::RunningTask&) { fail(why); };
  runner_.start(std::move(task));
}

void Draper::stop() {
  runner_.stop();
  const std::lock_guard lock(mutex_);
  if (state_.stage != DrapeStage::kFalling) return;
  state_ = {DrapeStage::kStopped, 0, {}};
  news_.any = true;
  news_.said = tr("Simulation stopped: the generic drape is shown");
}

void Draper::again(const std::shared_ptr<const Design>& design) {
  {
    const std::lock_guard lock(mutex_);
    wanted_.clear();
  }
  follow(design);
}

DrapeState Draper::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

Draper::News Draper::take_news() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, {});
}

void Draper::run(const Design& design, const std::string& wanted, const std::stop_token& stop) {
  if (files::is_draped(design)) return tell(wanted, {DrapeStage::kOwn, 1, {}});
  const base::Result<void> done = files::drape_cloth(design, [&](double share) {
    tell(wanted, {DrapeStage::kFalling, static_cast<float>(share), {}});
    return !stop.stop_requested();
  });
  if (stop.stop_requested()) return;
  if (!done) {
    std::string problem = message(done.error());
    std::string said = fill(tr("Not simulated: {problem}"), arg("problem", problem));
    return tell(wanted, {DrapeStage::kFailed, 0, std::move(problem)}, std::move(said));
  }
  tell(wanted, {DrapeStage::kOwn, 1, {}}, tr("Simulated: the drape is this fabric's own"));
}

void Draper::fail(const std::string& why) {
  const std::string wanted = [this] {
    const std::lock_guard lock(mutex_);
    return wanted_;
  }();
  tell(wanted, {DrapeStage::kFailed, 0, why}, fill(tr("Not simulated: {problem}"), arg("problem", why)));
}

void Draper::tell(const std::string& wanted, DrapeState state, std::string said) {
  {
    const std::lock_guard lock(mutex_);
    if (wanted != wanted_ || state_.stage != DrapeStage::kFalling) return;  // no longer wanted, or stopped
    const bool falls_on = state.stage == DrapeStage::kFalling;
    if (falls_on && std::abs(state.share - state_.share) < kStep) return;
    state_ = std::move(state);
    news_.any = true;
    news_.draped |= state_.stage == DrapeStage::kOwn;
    if (!said.empty()) news_.said = std::move(said);
  }
  wake_();
}

}  // namespace weftlight::session
