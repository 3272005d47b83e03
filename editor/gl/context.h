#pragma once
// An OpenGL 3.3+ core context without a window, through EGL surfaceless (GPU or llvmpipe).

#include <memory>
#include <string>

#include "gl/names.h"

namespace weftlight::gl {

class HeadlessContext {
 public:
  /// Makes a context current on this thread. Null with `error` set without graphics.
  static std::unique_ptr<HeadlessContext> create(std::string& error);
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  HeadlessContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace weftlight::gl
