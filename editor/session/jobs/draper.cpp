#include "session/jobs/draper.h"

#include <cmath>
#include <utility>

#include "base/text.h"
#include "files/design_drape.h"

namespace weftlight::session {

using base::arg, base::fill, base::message, base::tr;

namespace {

constexpr float kStep = 0.01f;  // progress that is worth redrawing the window

}  // namespace

Edit simulated_drape_edit(bool on) {
  return {on ? tr("Simulate this fabric") : tr("Use the generic drape"), [on](Design d) {
            d.scene.simulated_drape = on;
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
    state_ = {wanted.empty() ? DrapeStage::kGeneric : DrapeStage::kSimulating, 0, {}};
    update_.any = true;
  }
  runner_.stop();
  if (wanted.empty()) return;
  base::Task task;
  task.work = [this, design, wanted = std::move(wanted)](const base::RunningTask& running) {
    run(*design, wanted, running.stop());
  };
  task.failed = [this](const base::Error& error, const base::RunningTask&) { fail(error); };
  runner_.start(std::move(task));
}

void Draper::stop() {
  runner_.stop();
  const std::lock_guard lock(mutex_);
  if (state_.stage != DrapeStage::kSimulating) return;
  state_ = {DrapeStage::kStopped, 0, {}};
  update_.any = true;
  update_.message = tr("Simulation stopped: the generic drape is shown");
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

Draper::Update Draper::take_update() {
  const std::lock_guard lock(mutex_);
  return std::exchange(update_, {});
}

void Draper::run(const Design& design, const std::string& wanted, const std::stop_token& stop) {
  if (files::is_draped(design)) return tell(wanted, {DrapeStage::kSimulated, 1, {}});
  const base::Result<void> done = files::drape_cloth(design, [&](double share) {
    tell(wanted, {DrapeStage::kSimulating, static_cast<float>(share), {}});
    return !stop.stop_requested();
  });
  if (stop.stop_requested()) return;
  if (!done) return tell_failed(wanted, done.error());
  tell(wanted, {DrapeStage::kSimulated, 1, {}}, tr("Simulated: the drape is this fabric's own"));
}

void Draper::fail(const base::Error& error) {
  const std::string wanted = [this] {
    const std::lock_guard lock(mutex_);
    return wanted_;
  }();
  tell_failed(wanted, error);
}

void Draper::tell_failed(const std::string& wanted, const base::Error& error) {
  std::string problem = message(error);
  std::string said = fill(tr("Not simulated: {problem}"), arg("problem", problem));
  tell(wanted, {DrapeStage::kFailed, 0, std::move(problem)}, std::move(said));
}

void Draper::tell(const std::string& wanted, DrapeState state, std::string message) {
  {
    const std::lock_guard lock(mutex_);
    if (wanted != wanted_ || state_.stage != DrapeStage::kSimulating) return;  // no longer wanted, or stopped
    const bool goes_on = state.stage == DrapeStage::kSimulating;
    if (goes_on && std::abs(state.share - state_.share) < kStep) return;
    state_ = std::move(state);
    update_.any = true;
    update_.new_mesh |= state_.stage == DrapeStage::kSimulated;
    if (!message.empty()) update_.message = std::move(message);
  }
  wake_();
}

}  // namespace weftlight::session
