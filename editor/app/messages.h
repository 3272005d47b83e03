#pragma once
// What the window tells the user: the message in the status line, and the messages about a file.

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "views/common/panel.h"
#include "views/shell/status_bar.h"
#include "wif/wif.h"

namespace weftlight::app {

using views::PanelContext, views::StatusMessage;
using wif::Diagnostic;

class Messages {
 public:
  /// `seconds`: the time now; only differences count.
  explicit Messages(std::function<double()> seconds) : seconds_(std::move(seconds)) {}
  /// Shows a message in the status line until it is read: for some seconds, and on until the user's next action.
  void say(std::string text) { show({std::move(text), false}); }
  /// The same for what could not be done; it stands out.
  void refuse(std::string text) { show({std::move(text), true}); }
  /// The message, while it is shown; else without a text.
  const StatusMessage& shown() const { return shown_; }
  void clear() { shown_ = {}; }
  /// The user begins another action: what had the time to be read goes.
  void begin_action();

  /// Shows why a file could not be opened. Of several, each is told.
  void report(std::vector<Diagnostic> remarks, const std::string& path);
  /// Another document is shown: the messages about its file, after those about files that could not be opened while
  /// they are shown.
  void follow(std::vector<Diagnostic> remarks);
  std::span<const Diagnostic> remarks() const { return remarks_; }
  void show_remarks() { remarks_open_ = true; }
  void toggle_remarks() { remarks_open_ = !remarks_open_; }
  /// False if it was closed.
  bool close_remarks() { return std::exchange(remarks_open_, false); }
  /// Draws their window.
  void draw_remarks(PanelContext& c);

 private:
  void show(StatusMessage message);
  /// Leaves only what is shown about files that could not be opened.
  void keep_unopened();

  std::function<double()> seconds_;
  StatusMessage shown_;
  double said_at_s_ = 0;
  std::vector<Diagnostic> remarks_;    // about files that could not be opened, then about the document
  std::vector<std::string> unopened_;  // the names of these files
  size_t about_unopened_ = 0;          // so many of the remarks, the first ones
  bool remarks_open_ = false;
};

}  // namespace weftlight::app
