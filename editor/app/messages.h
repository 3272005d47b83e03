#pragma once
// What the window tells the user: the message in the status line, and the messages about a file.

#include <span>
#include <string>
#include <vector>

#include "views/common/panel.h"
#include "wif/wif.h"

namespace weftlight::app {

using views::PanelContext;
using wif::Diagnostic;

class Messages {
 public:
  /// Shows a message in the status line for a while.
  void say(std::string text);
  /// The message, while it is shown; else empty.
  std::string text() const;
  void clear() { text_.clear(); }

  /// Shows why a file could not be opened.
  void report(std::vector<Diagnostic> remarks, const std::string& path);
  /// Another document is shown: the messages about its file.
  void follow(std::vector<Diagnostic> remarks);
  std::span<const Diagnostic> remarks() const { return remarks_; }
  void show_remarks() { remarks_open_ = true; }
  void toggle_remarks() { remarks_open_ = !remarks_open_; }
  /// Draws their window.
  void draw_remarks(PanelContext& c);

 private:
  std::string text_;
  double said_at_s_ = 0;
  std::vector<Diagnostic> remarks_;  // about the document, or a file that could not be opened
  bool remarks_open_ = false;
};

}  // namespace weftlight::app
