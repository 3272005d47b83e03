#pragma once
// Whether the driver was reset and has dropped all that was made in a context.

#include "base/result.h"

namespace weftlight::gl {

/// Of the context that is current where it is made, and where it is asked.
class ResetWatch {
 public:
  ResetWatch();
  /// Whether all is lost that was made before the watch. Never true of a driver that does not tell.
  bool is_lost() const;
  /// Whether the same context can be drawn in again. A browser gives it back; a desktop's driver does not.
  bool is_back() const;

 private:
  bool can_ask_;
  int resets_;
};

/// Contexts that were lost one soon after the other.
class LostContexts {
 public:
  /// `lasted_s`: of the one that is lost now. False if it is not worth to begin again: what is drawn may be what resets
  /// the driver.
  bool may_begin_again(double lasted_s);
  /// What to say then.
  static base::Error problem();

 private:
  int count_ = 0;
};

}  // namespace weftlight::gl
