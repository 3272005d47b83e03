#include "base/json.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <new>
#include <thread>

namespace weftlight::base {
namespace {

/// A mutex that waits busily, for pieces that are taken in no time: that of mingw-w64 is not there before its
/// constructor.
class BusyLock {
 public:
  void lock() {
    while (held_.test_and_set(std::memory_order_acquire)) std::this_thread::yield();
  }
  void unlock() { held_.clear(std::memory_order_release); }

 private:
  std::atomic_flag held_;
};

/// Pieces one after the other, all free again when none is left: where memory has ended, trees go soon.
class Store {
 public:
  void* take(size_t bytes) {
    const std::lock_guard lock(mutex_);
    const size_t whole = (bytes + kAlign - 1) / kAlign * kAlign;
    if (whole > room_.size() - used_) throw std::bad_alloc();
    void* const piece = room_.data() + used_;
    used_ += whole, ++pieces_;
    return piece;
  }
  /// Whether it was a piece of the store.
  bool give_back(void* piece) {
    const std::less<const void*> before;
    if (before(piece, room_.data()) || !before(piece, room_.data() + room_.size())) return false;
    const std::lock_guard lock(mutex_);
    if (--pieces_ == 0) used_ = 0;
    return true;
  }

 private:
  static constexpr size_t kAlign = alignof(std::max_align_t);
  BusyLock mutex_;
  alignas(kAlign) std::array<std::byte, size_t{1} << 20> room_{};  // 30,000 values that wait for their end
  size_t used_ = 0;
  int pieces_ = 0;
};

/// Of the whole process, and there before and after everything else.
constinit Store g_store;

}  // namespace

void* take_json_memory(size_t bytes) {
  try {
    return ::operator new(bytes);
  } catch (const std::bad_alloc&) {
    return g_store.take(bytes);
  }
}

void give_json_memory_back(void* piece) noexcept {
  if (!g_store.give_back(piece)) ::operator delete(piece);
}

JsonExtent json_extent(std::string_view text) {
  JsonExtent extent;
  int depth = 0;
  bool in_text = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_text) {
      if (c == '\\') ++i;
      else in_text = c != '"';
    } else if (c == '"') {
      in_text = true;
    } else if (c == '[' || c == '{') {
      extent.depth = std::max(extent.depth, ++depth);
      ++extent.values;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == ',') {
      ++extent.values;
    }
  }
  return extent;
}

bool is_text(const nlohmann::json& value, std::string_view text) {
  const auto* own = value.get_ptr<const std::string*>();
  return own != nullptr && *own == text;
}

nlohmann::json read_json(std::string_view text) {
  const JsonExtent extent = json_extent(text);
  if (extent.depth > kMaxJsonDepth || extent.values > kMaxJsonValues) return nlohmann::json::value_t::discarded;
  return nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
}

}  // namespace weftlight::base
