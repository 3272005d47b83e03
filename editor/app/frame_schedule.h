#pragma once
// When the next frame is due: some frames after every event, and one when a tooltip appears.

#include <algorithm>

namespace weftlight::app {

class FrameSchedule {
 public:
  /// At least so many frames are drawn from now on.
  void draw(int frames) { due_ = std::max(due_, frames); }
  /// An event came: enough frames for a press, its release, and the layout of what a click opened.
  void draw_after_event() { draw(kAfterEvent); }
  /// The user did something, at a time in seconds.
  void input(double now_s) {
    draw_after_event();
    moved_at_s_ = now_s;
    tip_at_s_ = now_s + kTipS;
  }
  /// Seconds since the user last did something.
  double rest_s(double now_s) const { return now_s - moved_at_s_; }

  bool is_due() const { return due_ > 0; }
  bool is_tip_due(double now_s) const { return tip_at_s_ >= 0 && now_s >= tip_at_s_; }
  /// Seconds until the tooltip, 0 if a frame is due, negative if none is.
  double wait_s(double now_s) const {
    if (is_due()) return 0;
    return tip_at_s_ >= 0 ? std::max(0.0, tip_at_s_ - now_s) : -1;
  }
  /// A frame is being drawn.
  void drawn(double now_s) {
    if (is_tip_due(now_s)) tip_at_s_ = -1;
    due_ = std::max(0, due_ - 1);
  }

 private:
  static constexpr int kAfterEvent = 4;
  static constexpr double kTipS = 0.5;  // delay of a tooltip

  int due_ = 5;
  double moved_at_s_ = 0, tip_at_s_ = -1;
};

}  // namespace weftlight::app
