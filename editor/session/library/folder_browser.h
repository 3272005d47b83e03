#pragma once
// The drafts of a folder that the user browses, and those that a search finds. Folder and files are read, and lists are
// searched, on threads of their own; a window asks and takes.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/tasks.h"
#include "collection/folder_index.h"
#include "collection/query.h"

namespace weftlight::session {

using collection::DraftQuery, collection::Entries;

class FolderBrowser {
 public:
  /// `index_folder`: of the cache; empty: none. `wake`: called on another thread when there is something to take.
  FolderBrowser(std::string index_folder, std::function<void()> wake);

  /// Shows another folder, or looks through the same one again. What is known of it comes at once.
  void open(const std::string& folder);
  /// Stops looking through it; what is known by then stays, and is kept.
  void stop();
  /// Searches what there is, and again when there is more.
  void search(const DraftQuery& query);
  /// Takes results; true if there is anything new to show.
  bool poll();

  const std::string& folder() const { return folder_; }
  const DraftQuery& query() const { return query_; }
  /// Never null; `found()` are indices of it.
  const std::shared_ptr<const Entries>& entries() const { return shown_; }
  const std::vector<int>& found() const { return found_; }
  /// How far the reading is; after it what could not be read, or empty.
  std::string said() const;
  bool is_reading() const { return reading_.busy(); }
  bool busy() const { return reading_.busy() || searching_.busy(); }

 private:
  struct Found {
    std::shared_ptr<const Entries> entries;
    std::vector<int> indices;
  };
  void take_entries(std::shared_ptr<const Entries> entries);
  void start_search();

  std::string index_folder_;
  std::string folder_, remark_;
  DraftQuery query_;
  std::shared_ptr<const Entries> latest_, shown_;  // of which shown_ was searched
  std::vector<int> found_;
  bool fresh_ = false;  // there is something new to show since the last poll()
  base::TaskRunner reading_, searching_;
};

}  // namespace weftlight::session
