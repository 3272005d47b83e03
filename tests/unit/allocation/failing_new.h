#pragma once
// The nth piece of memory that cannot be had.

namespace weftlight {

/// While it stands, the nth call of operator new by this thread from here on fails; n counts from 1.
class NthFails {
 public:
  explicit NthFails(int n);
  ~NthFails();
  NthFails(const NthFails&) = delete;
  NthFails& operator=(const NthFails&) = delete;
  /// Whether so many pieces were asked for.
  static bool failed();
};

}  // namespace weftlight
