#pragma once
// The dialog that is open, of the window or of the system, and what follows its answer. One is open at a time.

#include <deque>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "app/background_tasks.h"
#include "app/frame_schedule.h"
#include "app/messages.h"
#include "platform/desktop.h"
#include "session/session.h"
#include "views/dialogs/dialog.h"

namespace weftlight::app {

using platform::FileAsk;
using session::Session;
using views::Dialog, views::PanelContext, views::Question, views::update_dialog;

class Dialogs {
 public:
  Dialogs(Session& session, BackgroundTasks& tasks, Messages& messages, FrameSchedule& schedule)
      : session_(session), tasks_(tasks), messages_(messages), schedule_(schedule) {}

  /// Opens a dialog; `then` gets the pressed button and reads the rest by prompt().
  void ask(Dialog dialog, std::function<void(int button)> then);
  /// Asks for a path. `ending` of the file, such as ".wif"; before an existing file is replaced, it asks again.
  void ask_path(FileAsk what, const std::string& title, const std::string& start,
                std::function<void(const std::string&)> chosen, const std::string& ending = ".wif");

  /// Runs `then`; if one of the files exists, only after its question is answered by the first button. The files may be
  /// on a share that does not answer, which nobody waits for.
  void before_replacing(std::vector<std::string> files, std::function<Question(const std::string& there)> question,
                        std::function<void()> then);

  template <class Prompt>
  const Prompt& prompt() const {
    return std::get<Prompt>(dialog_);
  }
  template <class Prompt>
  bool shows() const {
    return std::holds_alternative<Prompt>(dialog_);
  }
  bool any() const { return !shows<std::monostate>(); }
  void close() { dialog_ = {}; }
  /// Runs `then` now, or by run_next() when the open dialog is closed.
  void when_none(std::function<void()> then);
  /// Runs what waits longest, if no dialog is open. True if there was anything.
  bool run_next();
  /// True while the system's file dialog is open.
  bool system_asks() const { return file_dialog_.waiting(); }
  /// True while an open dialog computes something, or the system's asks.
  bool busy() const { return busy_ || file_dialog_.waiting(); }

  /// Takes the answer of the system's file dialog.
  void poll() { file_dialog_.poll(); }
  /// Takes finished background work. True if there is something new to draw.
  bool update() { return update_dialog(dialog_, busy_); }
  void draw(PanelContext& c);

 private:
  void ask_path_in_window(FileAsk what, const std::string& title, const std::string& start,
                          std::function<void(const std::string&)> chosen, const std::string& ending);
  void with_ending(const std::string& typed, const std::string& ending,
                   const std::function<void(const std::string&)>& then);

  Session& session_;
  BackgroundTasks& tasks_;
  Messages& messages_;
  FrameSchedule& schedule_;
  Dialog dialog_;
  std::function<void(int)> answer_;
  std::deque<std::function<void()>> later_;  // when no dialog is open
  bool busy_ = false;
  platform::FileDialog file_dialog_;
};

}  // namespace weftlight::app
