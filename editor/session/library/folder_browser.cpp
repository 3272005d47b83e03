#include "session/library/folder_browser.h"

#include <utility>

#include "base/text.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr, base::tr_n;
using collection::FolderIndex, collection::found_drafts, collection::look_through;

namespace {

std::string remark_on(const FolderIndex& index) {
  if (index.left_out > 0)
    return fill(tr_n("{count} more draft is not listed; choose a subfolder.",
                     "{count} more drafts are not listed; choose a subfolder.", static_cast<long long>(index.left_out)),
                arg("count", index.left_out));
  if (index.unread.empty()) return {};
  return fill(tr("Cannot be read: {folder}"), arg("folder", index.unread.front()));
}

}  // namespace

FolderBrowser::FolderBrowser(std::string index_folder, std::function<void()> wake)
    : index_folder_(std::move(index_folder)),
      latest_(std::make_shared<const Entries>()),
      shown_(latest_),
      reading_(wake),
      searching_(std::move(wake)) {}

void FolderBrowser::open(const std::string& folder) {
  if (folder != folder_) {
    searching_.stop();
    latest_ = shown_ = std::make_shared<const Entries>();
    found_.clear();
  }
  folder_ = folder;
  remark_.clear();
  fresh_ = true;
  base::Task task;
  task.work = [this, folder, cache = index_folder_](const base::RunningTask& running) {
    const FolderIndex index = look_through(folder, cache, running, [&](std::shared_ptr<const Entries> so_far) {
      running.deliver([this, so_far = std::move(so_far)] { take_entries(so_far); });
    });
    running.deliver([this, entries = index.entries, remark = remark_on(index)] {
      remark_ = remark;
      take_entries(entries);
    });
  };
  task.failed = [this](const base::Error& error, const base::RunningTask& running) {
    running.deliver([this, text = message(error)] {
      remark_ = text;
      fresh_ = true;
    });
  };
  task.kind = "folder";
  task.name = folder;
  task.may_be_left = true;
  reading_.start(std::move(task));
}

void FolderBrowser::stop() {
  if (!reading_.busy()) return;
  reading_.stop();
  remark_ = tr("Stopped: not all drafts are listed.");
  fresh_ = true;
}

void FolderBrowser::search(const DraftQuery& query) {
  if (query == query_) return;
  query_ = query;
  start_search();
}

void FolderBrowser::take_entries(std::shared_ptr<const Entries> entries) {
  latest_ = std::move(entries);
  start_search();
}

void FolderBrowser::start_search() {
  base::Task task = base::task_with_result(
      [entries = latest_, query = query_](const base::RunningTask&) {
        return Found{entries, found_drafts(*entries, query)};
      },
      [this](base::Result<Found> found) {
        if (!found) return;
        shown_ = std::move(found->entries);
        found_ = std::move(found->indices);
        fresh_ = true;
      });
  task.kind = "search";
  searching_.start(std::move(task));
}

bool FolderBrowser::poll() {
  reading_.take();
  searching_.take();
  return std::exchange(fresh_, false);
}

std::string FolderBrowser::said() const {
  for (const base::ShownTask& task : reading_.shown())
    return task.sentence.empty() ? std::string(tr("Searching for drafts\xE2\x80\xA6")) : task.sentence;
  return remark_;
}

}  // namespace weftlight::session
