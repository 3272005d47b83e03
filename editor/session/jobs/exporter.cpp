#include "session/jobs/exporter.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/text.h"
#include "files/design_drape.h"

namespace weftlight::session {

using base::arg, base::fill, base::message, base::tr, base::tr_n;
using files::drape_key, files::load_worn_drape;
using texture_set::ExportProgress, texture_set::SharedWork, texture_set::write_texture_set;

namespace {

constexpr float kStep = 0.01f;  // progress that is worth redrawing the window

}  // namespace

Exporter::Exporter(std::function<void()> wake) : wake_(std::move(wake)) {}

void Exporter::start(std::vector<ExportJob> jobs, std::shared_ptr<const Design> design) {
  {
    const std::lock_guard lock(mutex_);
    state_ = {};
    state_.busy = true, state_.sets = jobs.size();
  }
  base::Task task;
  task.work = [this, jobs = std::move(jobs), design = std::move(design)](const base::RunningTask& running) {
    run(jobs, *design, running.stop());
  };
  task.failed = [this](const base::Error& error, const base::RunningTask&) { fail(error); };
  runner_.start(std::move(task));
}

void Exporter::stop() {
  runner_.stop();
  const std::lock_guard lock(mutex_);
  if (!state_.busy) return;
  state_.busy = false, state_.stopped = true;
  message_ = tr("The export was stopped; the earlier set is unchanged");
}

Exporter::State Exporter::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

bool Exporter::busy() const { return state().busy; }

bool Exporter::began() const {
  const std::lock_guard lock(mutex_);
  return state_.sets > 0;
}

bool Exporter::take_change() {
  const std::lock_guard lock(mutex_);
  return std::exchange(changed_, false);
}

std::string Exporter::take_message() {
  const std::lock_guard lock(mutex_);
  return std::exchange(message_, {});
}

void Exporter::tell(size_t set, size_t sets, float share) {
  const float all = (static_cast<float>(set) + share) / static_cast<float>(std::max<size_t>(sets, 1));
  {
    const std::lock_guard lock(mutex_);
    const bool same = state_.set == set && state_.sets == sets && std::abs(all - state_.share) < kStep;
    state_.set = set, state_.sets = sets;
    if (same) return;
    state_.share = all, changed_ = true;
  }
  wake_();
}

bool Exporter::use_mesh(const std::vector<ExportJob>& jobs, const Design& design) {
  const bool wanted =
      std::any_of(jobs.begin(), jobs.end(), [](const ExportJob& j) { return j.options.target->wears_mesh; });
  if (!wanted || mesh_name_ == drape_key(design)) return true;
  base::Result<Mesh> read = load_worn_drape(design);
  if (!read) {
    const std::lock_guard lock(mutex_);
    state_.problems.push_back(message(read.error()));
    return false;
  }
  mesh_ = std::move(*read), mesh_name_ = drape_key(design);
  return true;
}

void Exporter::run(const std::vector<ExportJob>& jobs, const Design& design, const std::stop_token& stop) {
  const bool ready = use_mesh(jobs, design);
  SharedWork shared;
  for (size_t i = 0; ready && i < jobs.size() && !stop.stop_requested(); ++i) {
    tell(i, jobs.size(), 0);
    const ExportProgress progress{[this, i, &jobs](float share) { tell(i, jobs.size(), share); }, stop};
    const base::Result<void> done =
        write_texture_set(jobs[i].folder, design, mesh_, jobs[i].options, progress, &shared);
    // If it was stopped, stop() has set the message, or a newer run will.
    if (!done && done.error().kind == base::ErrorKind::kCancelled) return;
    const std::lock_guard lock(mutex_);
    (done ? state_.written : state_.problems).push_back(done ? jobs[i].folder : problem_of(done));
  }
  if (!stop.stop_requested()) end();
}

/// Handles exceptions outside of write_texture_set(), which reports its own.
void Exporter::fail(const base::Error& error) {
  {
    const std::lock_guard lock(mutex_);
    state_.problems.push_back(message(error));
  }
  end();
}

void Exporter::end() {
  {
    const std::lock_guard lock(mutex_);
    state_.busy = false, state_.share = 1, changed_ = true;
    const size_t count = state_.written.size();
    if (!state_.problems.empty())
      message_ = fill(tr("Not exported: {problem}"), arg("problem", state_.problems.front()));
    else if (count == 1)
      message_ = fill(tr("Exported the texture set to {folder}"), arg("folder", state_.written.front()));
    else if (count > 1)
      message_ = fill(
          tr_n("Exported {count} set to {folder}", "Exported {count} sets to {folder}", static_cast<long long>(count)),
          arg("count", count), arg("folder", std::filesystem::path(state_.written.front()).parent_path().string()));
  }
  wake_();
}

}  // namespace weftlight::session
