// Loaded before a program: no piece of memory above WEFTLIGHT_MOST_BYTES is to be had.

#include <cstdint>
#include <cstdlib>
#include <new>

void* operator new(size_t bytes) {
  static const char* const most = std::getenv("WEFTLIGHT_MOST_BYTES");
  static const size_t limit = most ? std::strtoull(most, nullptr, 10) : SIZE_MAX;
  void* there = bytes > limit ? nullptr : std::malloc(bytes > 0 ? bytes : 1);
  if (there == nullptr) throw std::bad_alloc();
  return there;
}
void operator delete(void* there) noexcept { std::free(there); }
void operator delete(void* there, size_t) noexcept { std::free(there); }
