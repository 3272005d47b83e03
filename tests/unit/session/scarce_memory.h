#pragma once
// Memory that cannot be had.

#include <cstddef>

namespace weftlight {

/// While it stands, no piece of memory above so many bytes is to be had, but by the thread that made it.
class Scarce {
 public:
  explicit Scarce(size_t most);
  ~Scarce();
  Scarce(const Scarce&) = delete;
  Scarce& operator=(const Scarce&) = delete;
};

}  // namespace weftlight
