#include "failing_new.h"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

// Of the thread that is tested alone: what others do meanwhile would make n another one at every run.
thread_local int t_left = 0;

}  // namespace

void* operator new(size_t bytes) {
  if (t_left > 0 && --t_left == 0) throw std::bad_alloc();
  void* there = std::malloc(bytes > 0 ? bytes : 1);
  if (there == nullptr) throw std::bad_alloc();
  return there;
}
void operator delete(void* there) noexcept { std::free(there); }
void operator delete(void* there, size_t) noexcept { std::free(there); }

namespace weftlight {

NthFails::NthFails(int n) { t_left = n; }
NthFails::~NthFails() { t_left = 0; }
bool NthFails::failed() { return t_left == 0; }

}  // namespace weftlight
