#include "session/saver.h"

#include <algorithm>
#include <filesystem>

#include "base/text.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr;

void Saver::save(uint64_t document, const std::string& path, bool over_changes, Then then) {
  Request request{session_.save_job(document, path), {}};
  request.job.over_changes = over_changes;
  const auto same = [&](const Request& other) { return other.job.document == document && other.job.path == path; };
  const auto waiting = requests_.empty() ? requests_.end() : std::find_if(requests_.begin() + 1, requests_.end(), same);
  if (waiting != requests_.end()) {
    request.then = std::move(waiting->then);
    request.then.push_back(std::move(then));
    *waiting = std::move(request);
    return;
  }
  request.then.push_back(std::move(then));
  requests_.push_back(std::move(request));
  if (requests_.size() == 1) start();
}

void Saver::start() {
  Request& request = requests_.front();
  session_.tell_files(request.job);  // as the last save left them
  base::Task task = base::task_with_result([job = request.job](const base::RunningTask&) { return write(job); },
                                           [this](const SaveResult& result) { finish(result); });
  const std::string file = std::filesystem::path(request.job.path).filename().string();
  task.name = fill(tr("Saving {file}"), arg("file", file));
  task.kind = "save";
  task.finishes = true;
  runner_.start(std::move(task));
}

void Saver::finish(const SaveResult& result) {
  const Request done = std::move(requests_.front());
  requests_.erase(requests_.begin());
  session_.take_saved(done.job, result);
  if (!requests_.empty()) start();
  if (!is_written(result))
    std::erase_if(after_, [&](const auto& a) { return a.first == 0 || a.first == done.job.document; });
  for (const Then& then : done.then)
    if (then) then(result);
  // `then` may have asked for another save.
  std::vector<std::function<void()>> due;
  std::erase_if(after_, [&](auto& a) {
    if (saving(a.first)) return false;
    due.push_back(std::move(a.second));
    return true;
  });
  for (const auto& follow : due) follow();
}

bool Saver::saving(uint64_t document) const {
  return std::ranges::any_of(requests_, [&](const Request& r) { return document == 0 || r.job.document == document; });
}

bool Saver::takes(const std::string& path, uint64_t but_for) const {
  return std::ranges::any_of(
      requests_, [&](const Request& r) { return r.job.document != but_for && is_same_name(r.job.path, path); });
}

void Saver::after(uint64_t document, std::function<void()> then) {
  if (!saving(document)) return then();
  std::erase_if(after_, [&](const auto& a) { return a.first == document; });
  after_.emplace_back(document, std::move(then));
}

bool Saver::awaited(uint64_t document) const {
  return std::ranges::any_of(after_, [&](const auto& a) { return a.first == document; });
}

}  // namespace weftlight::session
