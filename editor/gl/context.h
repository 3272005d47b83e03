#pragma once
// An OpenGL 3.3+ core context that draws into framebuffer objects and shows nothing: by EGL, which needs no display,
// else by a hidden window. The variable WEFTLIGHT_OFFSCREEN (egl, window, none) allows one of them alone, or neither.

#include <functional>
#include <memory>

#include "base/result.h"

namespace weftlight::gl {

class HeadlessContext {
 public:
  using Opened = base::Result<std::unique_ptr<HeadlessContext>>;

  /// Makes a context current on this thread, which must be the main one: a window may be opened there alone.
  static Opened create();
  /// The same on any thread. `hidden_window` is called where EGL fails; it has the main thread open_hidden_window().
  static Opened create(const std::function<Opened()>& hidden_window);

  /// Current on this thread; no other thread may have it then.
  virtual base::Result<void> make_current() = 0;
  /// Current on no thread; called on the one that has it.
  virtual void release() = 0;
  /// Released before, or current on this thread, which is the main one if the context may be a window's.
  virtual ~HeadlessContext() = default;
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 protected:
  HeadlessContext() = default;
};

}  // namespace weftlight::gl
