#pragma once
// An OpenGL 3.3+ core context that draws into framebuffer objects and shows nothing.

#include <memory>

#include "base/result.h"

namespace weftlight::gl {

class HeadlessContext {
 public:
  using Opened = base::Result<std::unique_ptr<HeadlessContext>>;

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
