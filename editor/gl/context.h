#pragma once
// An OpenGL 3.3+ core context without a window, through EGL surfaceless (GPU or llvmpipe).

#include <memory>
#include <optional>

#include "base/result.h"

namespace weftlight::gl {

/// Whether the driver tells of the current context that it was lost, where it can.
class ResetWatch {
 public:
  /// Needs the context current.
  ResetWatch();
  bool is_lost() const;

 private:
  bool can_ask_;
};

class HeadlessContext {
 public:
  /// Makes a context current on this thread. An error without graphics.
  static base::Result<std::unique_ptr<HeadlessContext>> create();
  ~HeadlessContext();
  /// True once the driver was reset and has dropped all that was made in this context. Needs it current.
  bool is_lost() const;
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  HeadlessContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
  std::optional<ResetWatch> watch_;
};

}  // namespace weftlight::gl
