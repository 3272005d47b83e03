#pragma once
#pragma GCC system_header
// What C++20's library has and libc++ 13, the one of Emscripten 3.1.6, lacks: the algorithms of std::ranges that
// Weftlight uses, numbers with a point in from_chars and to_chars, and stop_token. The build for browsers includes it
// before every file (third_party/web/dependencies.cmake); with a newer libc++ it is empty.

#include <version>

#if defined(__cplusplus) && defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000

#include <algorithm>
#include <bit>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <iterator>
#include <list>
#include <memory>
#include <mutex>
#include <numeric>
#include <type_traits>
#include <utility>

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}

from_chars_result from_chars(const char* first, const char* last, double& value);
from_chars_result from_chars(const char* first, const char* last, float& value);
to_chars_result to_chars(char* first, char* last, double value);
to_chars_result to_chars(char* first, char* last, float value);
to_chars_result to_chars(char* first, char* last, double value, chars_format format);
to_chars_result to_chars(char* first, char* last, float value, chars_format format);
to_chars_result to_chars(char* first, char* last, double value, chars_format format, int precision);

namespace ranges {

template <class R>
constexpr auto find(R&& range, const auto& value, auto projection) {
  auto at = std::begin(range);
  const auto end = std::end(range);
  while (at != end && !(std::invoke(projection, *at) == value)) ++at;
  return at;
}
template <class R>
constexpr auto find(R&& range, const auto& value) {
  return ranges::find(range, value, identity{});
}
template <class R, class F>
constexpr auto find_if(R&& range, F test) {
  auto at = std::begin(range);
  const auto end = std::end(range);
  while (at != end && !std::invoke(test, *at)) ++at;
  return at;
}
template <class R, class F>
constexpr bool any_of(R&& range, F test) {
  return ranges::find_if(range, test) != std::end(range);
}
template <class R, class F>
constexpr bool none_of(R&& range, F test) {
  return !ranges::any_of(range, test);
}
template <class R, class F>
constexpr bool all_of(R&& range, F test) {
  return !ranges::any_of(range, [&test](const auto& one) { return !std::invoke(test, one); });
}
template <class R, class F>
constexpr auto count_if(R&& range, F test) {
  return std::count_if(std::begin(range), std::end(range), [&](const auto& one) { return std::invoke(test, one); });
}
template <class R, class P = identity>
constexpr auto count(R&& range, const auto& value, P projection = {}) {
  return ranges::count_if(range, [&](const auto& one) { return std::invoke(projection, one) == value; });
}
template <class R, class F>
constexpr auto adjacent_find(R&& range, F test) {
  return std::adjacent_find(std::begin(range), std::end(range), test);
}
template <class I, class O>
struct in_out {
  I in;
  O out;
};
template <class I, class O>
in_out(I, O) -> in_out<I, O>;
template <class R, class O>
constexpr auto copy(R&& range, O out) {
  return in_out{std::end(range), std::copy(std::begin(range), std::end(range), out)};
}
template <class I, class O>
constexpr auto copy(I first, I last, O out) {
  return in_out{last, std::copy(first, last, out)};
}
template <class R, class O>
constexpr auto move(R&& range, O out) {
  return in_out{std::end(range), std::move(std::begin(range), std::end(range), out)};
}
template <class R>
constexpr auto fill(R&& range, const auto& value) {
  std::fill(std::begin(range), std::end(range), value);
  return std::end(range);
}
template <class R>
constexpr void replace(R&& range, const auto& old, const auto& value) {
  std::replace(std::begin(range), std::end(range), old, value);
}
template <class R, class F>
constexpr void replace_if(R&& range, F test, const auto& value) {
  std::replace_if(std::begin(range), std::end(range), test, value);
}
template <class R, class O, class F>
constexpr auto transform(R&& range, O out, F made) {
  return in_out{std::end(range), std::transform(std::begin(range), std::end(range), out,
                                                [&](auto&& one) -> decltype(auto) { return std::invoke(made, one); })};
}
template <class R>
constexpr void reverse(R&& range) {
  std::reverse(std::begin(range), std::end(range));
}

namespace before {
/// The comparison of what the projection makes of two values.
template <class C, class P>
constexpr auto by(C compare, P projection) {
  return [=](const auto& a, const auto& b) -> bool {
    return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
  };
}
}  // namespace before

template <class R, class C = less, class P = identity>
constexpr void sort(R&& range, C compare = {}, P projection = {}) {
  std::sort(std::begin(range), std::end(range), before::by(compare, projection));
}
template <class R, class C = less, class P = identity>
void stable_sort(R&& range, C compare = {}, P projection = {}) {
  std::stable_sort(std::begin(range), std::end(range), before::by(compare, projection));
}
template <class R, class I, class C = less, class P = identity>
constexpr void nth_element(R&& range, I nth, C compare = {}, P projection = {}) {
  std::nth_element(std::begin(range), nth, std::end(range), before::by(compare, projection));
}
template <class R, class C = less, class P = identity>
constexpr auto max_element(R&& range, C compare = {}, P projection = {}) {
  return std::max_element(std::begin(range), std::end(range), before::by(compare, projection));
}
template <class R, class C = less, class P = identity>
constexpr auto min_element(R&& range, C compare = {}, P projection = {}) {
  return std::min_element(std::begin(range), std::end(range), before::by(compare, projection));
}
template <class R>
constexpr auto max(R&& range) {
  return *ranges::max_element(range);
}
template <class R>
constexpr auto min(R&& range) {
  return *ranges::min_element(range);
}
template <class T>
struct min_max {
  T min, max;
};
template <class T>
min_max(T, T) -> min_max<T>;
template <class R, class C = less, class P = identity>
constexpr auto minmax(R&& range, C compare = {}, P projection = {}) {
  const auto [low, high] = std::minmax_element(std::begin(range), std::end(range), before::by(compare, projection));
  return min_max{*low, *high};
}
template <class R, class T, class C = less, class P = identity>
constexpr auto lower_bound(R&& range, const T& value, C compare = {}, P projection = {}) {
  return std::partition_point(std::begin(range), std::end(range), [&](const auto& one) {
    return static_cast<bool>(std::invoke(compare, std::invoke(projection, one), value));
  });
}
template <class R, class T, class C = less, class P = identity>
constexpr auto upper_bound(R&& range, const T& value, C compare = {}, P projection = {}) {
  return std::partition_point(std::begin(range), std::end(range), [&](const auto& one) {
    return !static_cast<bool>(std::invoke(compare, value, std::invoke(projection, one)));
  });
}
template <class R, class F>
constexpr auto partition_point(R&& range, F test) {
  return std::partition_point(std::begin(range), std::end(range), test);
}
template <class R, class T>
constexpr bool binary_search(R&& range, const T& value) {
  return std::binary_search(std::begin(range), std::end(range), value);
}
template <class A, class B, class C = equal_to, class P = identity, class Q = identity>
constexpr bool equal(A&& a, B&& b, C compare = {}, P of_a = {}, Q of_b = {}) {
  return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b), [&](const auto& x, const auto& y) {
    return static_cast<bool>(std::invoke(compare, std::invoke(of_a, x), std::invoke(of_b, y)));
  });
}
template <class A, class B>
struct in_in {
  A in1;
  B in2;
};
template <class A, class B>
in_in(A, B) -> in_in<A, B>;
template <class A, class B>
constexpr auto mismatch(A&& a, B&& b) {
  const auto [x, y] = std::mismatch(std::begin(a), std::end(a), std::begin(b), std::end(b));
  return in_in{x, y};
}
template <class A, class B, class O>
constexpr auto set_union(A&& a, B&& b, O out) {
  return std::set_union(std::begin(a), std::end(a), std::begin(b), std::end(b), out);
}

}  // namespace ranges

namespace stopping {
struct Callback {
  function<void()> run;
};
/// What a source, its tokens and their callbacks share.
struct State {
  recursive_mutex lock;  // a callback may end another, and itself, while it runs
  bool stopped = false;
  list<Callback*> callbacks;
};
}  // namespace stopping

struct nostopstate_t {};
inline constexpr nostopstate_t nostopstate{};

class stop_token {
 public:
  stop_token() noexcept = default;
  bool stop_requested() const noexcept {
    if (!state_) return false;
    const lock_guard held(state_->lock);
    return state_->stopped;
  }
  bool stop_possible() const noexcept { return state_ != nullptr; }
  bool operator==(const stop_token&) const noexcept = default;

 private:
  friend class stop_source;
  template <class>
  friend class stop_callback;
  shared_ptr<stopping::State> state_;
};

class stop_source {
 public:
  stop_source() : state_(make_shared<stopping::State>()) {}
  explicit stop_source(nostopstate_t) noexcept {}
  stop_token get_token() const noexcept {
    stop_token token;
    token.state_ = state_;
    return token;
  }
  bool stop_possible() const noexcept { return state_ != nullptr; }
  bool stop_requested() const noexcept { return get_token().stop_requested(); }
  bool request_stop() noexcept {
    if (!state_) return false;
    const lock_guard held(state_->lock);
    if (state_->stopped) return false;
    state_->stopped = true;
    while (!state_->callbacks.empty()) {
      stopping::Callback* first = state_->callbacks.front();
      state_->callbacks.pop_front();
      first->run();
    }
    return true;
  }

 private:
  shared_ptr<stopping::State> state_;
};

template <class F>
class stop_callback {
 public:
  template <class G>
  stop_callback(const stop_token& token, G&& run) : state_(token.state_), callback_{std::forward<G>(run)} {
    if (!state_) return;
    const lock_guard held(state_->lock);
    if (state_->stopped) callback_.run();
    else state_->callbacks.push_back(&callback_);
  }
  ~stop_callback() {
    if (!state_) return;
    const lock_guard held(state_->lock);
    state_->callbacks.remove(&callback_);
  }
  stop_callback(const stop_callback&) = delete;
  stop_callback& operator=(const stop_callback&) = delete;

 private:
  shared_ptr<stopping::State> state_;
  stopping::Callback callback_;
};
template <class F>
stop_callback(stop_token, F) -> stop_callback<F>;

/// With the wait that a stop ends. It looks again twenty times a second, since the stop does not take the lock.
class condition_variable_with_stop : public condition_variable_any {
 public:
  using condition_variable_any::wait;
  template <class Lock, class Test>
  bool wait(Lock& lock, const stop_token& stop, Test test) {
    const stop_callback wake(stop, [this] { notify_all(); });
    while (!test()) {
      if (stop.stop_requested()) return false;
      wait_for(lock, chrono::milliseconds(50));
    }
    return true;
  }
  using condition_variable_any::wait_for;
  template <class Lock, class Duration, class Test>
  bool wait_for(Lock& lock, const stop_token& stop, const Duration& time, Test test) {
    const auto end = chrono::steady_clock::now() + time;
    const stop_callback wake(stop, [this] { notify_all(); });
    while (!test()) {
      if (stop.stop_requested() || chrono::steady_clock::now() >= end) return test();
      wait_for(lock, chrono::milliseconds(50));
    }
    return true;
  }
};

}  // namespace std

#define condition_variable_any condition_variable_with_stop

#endif
