#include "scarce_memory.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string_view>
#include <thread>

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

namespace {

std::atomic<size_t> g_most{SIZE_MAX};
std::atomic<std::thread::id> g_spared;
std::atomic<int> g_refusals{0};
// Of one thread: what others do meanwhile would make n another call at every run.
thread_local int t_left = 0;
// Of all threads but one.
std::atomic<int> g_left_elsewhere{0};

/// Where tinygltf's trees of JSON end they ask for memory (nlohmann's basic_json::destroy), and without it the program
/// ends: nothing around the library can prevent that, as base/json.h does for our own trees.
bool is_of_tinygltf([[maybe_unused]] const void* caller) {
#if __has_include(<dlfcn.h>)
  Dl_info info{};
  return ::dladdr(caller, &info) != 0 && std::string_view(info.dli_fname).find("tinygltf") != std::string_view::npos;
#else
  return false;
#endif
}

bool fails_here(const void* caller) {
  const bool here = t_left > 0, elsewhere = g_left_elsewhere > 0 && g_spared.load() != std::this_thread::get_id();
  if ((!here && !elsewhere) || is_of_tinygltf(caller)) return false;
  if (here && --t_left == 0) return true;
  return elsewhere && --g_left_elsewhere == 0;
}

void* piece_of(size_t bytes, const void* caller) {
  if (fails_here(caller)) return nullptr;
  if (bytes > g_most && g_spared.load() != std::this_thread::get_id()) {
    ++g_refusals;
    return nullptr;
  }
  return std::malloc(bytes > 0 ? bytes : 1);
}

}  // namespace

// Of the whole program; in a file of their own, where the compiler sees both as one pair. All pairs that the standard
// library uses (std::stable_sort takes the one that does not throw), or the address sanitizer would see memory of one
// go to the other.
void* operator new(size_t bytes, const std::nothrow_t& /*unused*/) noexcept {
  return piece_of(bytes, __builtin_return_address(0));
}
void* operator new(size_t bytes) {
  void* there = piece_of(bytes, __builtin_return_address(0));
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
