#pragma once
// What the window has done beside it: reading and writing files, long searches. The status line shows what takes long.

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "app/window.h"
#include "base/tasks.h"
#include "views/common/panel.h"

namespace weftlight::app {

using views::PanelContext;

class BackgroundTasks {
 public:
  base::TaskRunner& reading() { return reading_; }
  /// Looks at files that may have changed; apart from `reading`, so that a disk that hangs keeps no other file.
  base::TaskRunner& looking() { return looking_; }
  base::TaskRunner& writing() { return writing_; }
  base::TaskRunner& computing() { return computing_; }
  bool busy() const { return looking_.busy() || reading_.busy() || writing_.busy() || computing_.busy(); }

  /// Takes up results; true if there were any. `may_change_draft`: also those that may change a draft or show another.
  bool take(bool may_change_draft);
  /// True if the status line is to be drawn again.
  bool update_shown();
  /// Draws what takes long into the status line, with a button that cancels it. `awaits`: what happens when it is done,
  /// or empty.
  void draw(PanelContext& c, const std::string& awaits);
  /// The task that the user cancelled, returned once.
  std::optional<base::ShownTask> take_cancelled() { return std::exchange(cancelled_, {}); }

 private:
  base::TaskRunner reading_{Window::wake}, looking_{Window::wake}, writing_{Window::wake}, computing_{Window::wake};
  std::optional<base::ShownTask> shown_, cancelled_;
};

}  // namespace weftlight::app
