#pragma once
// Memory that cannot be had. A test program that links scarce_memory.cpp has its operator new.

#include <cstddef>

namespace weftlight {

/// While it stands, no piece of memory above so many bytes is to be had, but by the thread that made it.
class Scarce {
 public:
  explicit Scarce(size_t most);
  ~Scarce();
  /// How often memory was refused since the last one was made.
  static int refusals();
  Scarce(const Scarce&) = delete;
  Scarce& operator=(const Scarce&) = delete;
};

// Calls from within tinygltf never fail and are not counted by the two below: see scarce_memory.cpp.

/// While it stands, the nth call of operator new by this thread from here on fails; n counts from 1.
class NthFails {
 public:
  explicit NthFails(int n);
  ~NthFails();
  NthFails(const NthFails&) = delete;
  NthFails& operator=(const NthFails&) = delete;
  /// Whether so many pieces were asked for.
  static bool failed();
  /// Calls that are still to come until one fails.
  static int left();
};

/// While it stands, the nth call of operator new by any other thread from here on fails; n counts from 1.
class NthFailsElsewhere {
 public:
  explicit NthFailsElsewhere(int n);
  ~NthFailsElsewhere();
  NthFailsElsewhere(const NthFailsElsewhere&) = delete;
  NthFailsElsewhere& operator=(const NthFailsElsewhere&) = delete;
  /// Whether so many pieces were asked for.
  static bool failed();
};

}  // namespace weftlight
