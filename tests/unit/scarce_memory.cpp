#include "scarce_memory.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <thread>

namespace {

std::atomic<size_t> g_most{SIZE_MAX};
std::atomic<std::thread::id> g_spared;
std::atomic<int> g_refusals{0};
// Of one thread: what others do meanwhile would make n another call at every run.
thread_local int t_left = 0;
// Of all threads but one.
std::atomic<int> g_left_elsewhere{0};

bool fails_here() {
  if (t_left > 0 && --t_left == 0) return true;
  if (g_left_elsewhere <= 0 || g_spared.load() == std::this_thread::get_id()) return false;
  return --g_left_elsewhere == 0;
}

}  // namespace

// Of the whole program; in a file of their own, where the compiler sees both as one pair. All pairs that the standard
// library uses (std::stable_sort takes the one that does not throw), or the address sanitizer would see memory of one
// go to the other.
void* operator new(size_t bytes, const std::nothrow_t& /*unused*/) noexcept {
  if (fails_here()) return nullptr;
  if (bytes > g_most && g_spared.load() != std::this_thread::get_id()) {
    ++g_refusals;
    return nullptr;
  }
  return std::malloc(bytes > 0 ? bytes : 1);
}
void* operator new(size_t bytes) {
  void* there = operator new(bytes, std::nothrow);
  if (there == nullptr) throw std::bad_alloc();
  return there;
}
void operator delete(void* there) noexcept { std::free(there); }
void operator delete(void* there, size_t) noexcept { std::free(there); }
void operator delete(void* there, const std::nothrow_t& /*unused*/) noexcept { std::free(there); }

namespace weftlight {

Scarce::Scarce(size_t most) {
  g_spared = std::this_thread::get_id();
  g_refusals = 0;
  g_most = most;
}
Scarce::~Scarce() { g_most = SIZE_MAX; }
int Scarce::refusals() { return g_refusals; }

NthFails::NthFails(int n) { t_left = n; }
NthFails::~NthFails() { t_left = 0; }
bool NthFails::failed() { return t_left == 0; }
int NthFails::left() { return t_left; }

NthFailsElsewhere::NthFailsElsewhere(int n) {
  g_spared = std::this_thread::get_id();
  g_left_elsewhere = n;
}
NthFailsElsewhere::~NthFailsElsewhere() { g_left_elsewhere = 0; }
bool NthFailsElsewhere::failed() { return g_left_elsewhere <= 0; }

}  // namespace weftlight
