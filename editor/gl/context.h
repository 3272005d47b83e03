#pragma once
// An OpenGL 3.3+ core context without a window, through EGL surfaceless (GPU or llvmpipe).

#include <memory>

#include "base/result.h"

namespace weftlight::gl {

class HeadlessContext {
 public:
  /// Makes a context current on this thread. An error without graphics.
  static base::Result<std::unique_ptr<HeadlessContext>> create();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  HeadlessContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace weftlight::gl
