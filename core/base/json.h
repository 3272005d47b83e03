#pragma once
// Trees of JSON, by nlohmann's library, that go without memory. Its destructor asks for some (basic_json::destroy,
// version 3.11), where an exception ends the program; pieces for arrays of JSON come from a store that is kept back
// where there is no other memory. Instead of <nlohmann/json.hpp>, since all files must know it.

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <type_traits>

namespace weftlight::base {

/// Throws std::bad_alloc where the store is used up, too.
void* take_json_memory(size_t bytes);
void give_json_memory_back(void* piece) noexcept;

/// How deep a text of JSON is nested, and of how many values it is at least; found before any of them takes memory.
struct JsonExtent {
  int depth = 0;
  size_t values = 1;
};
JsonExtent json_extent(std::string_view text);

inline constexpr int kMaxJsonDepth = 64;
inline constexpr size_t kMaxJsonValues = 500'000;  // up to 200 bytes of memory each

/// Whether it is this text. The library's own comparison with a pointer makes a value within noexcept, so that the
/// program ends where there is no memory for it.
bool is_text(const nlohmann::json& value, std::string_view text);

/// The value; discarded where the text is no JSON, nested deeper than kMaxJsonDepth, or of more than kMaxJsonValues.
nlohmann::json read_json(std::string_view text);

}  // namespace weftlight::base

template <>
struct std::allocator<nlohmann::json> {
  using value_type = nlohmann::json;
  using size_type = size_t;
  using difference_type = ptrdiff_t;
  using propagate_on_container_move_assignment = std::true_type;
  using is_always_equal = std::true_type;

  allocator() noexcept = default;
  template <class Other>
  allocator(const std::allocator<Other>& /*of_others*/) noexcept {}  // NOLINT(google-explicit-constructor)

  value_type* allocate(size_t count);
  void deallocate(value_type* piece, size_t /*count*/) noexcept { weftlight::base::give_json_memory_back(piece); }
  friend bool operator==(const allocator& /*a*/, const allocator& /*b*/) noexcept { return true; }
};

#include <nlohmann/json.hpp>  // what the above must precede

inline nlohmann::json* std::allocator<nlohmann::json>::allocate(size_t count) {
  if (count > SIZE_MAX / sizeof(value_type)) throw std::bad_array_new_length();
  return static_cast<value_type*>(weftlight::base::take_json_memory(count * sizeof(value_type)));
}
