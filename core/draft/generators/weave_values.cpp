#include "draft/generators/weave_values.h"

#include <charconv>

#include "draft/generators/families.h"

namespace weftlight::draft {

std::string text(const WeaveValues& values, std::string_view id) {
  for (const auto& [key, value] : values)
    if (key == id) return value;
  return {};
}

int count(const WeaveValues& values, std::string_view id) {
  const std::string value = text(values, id);
  int n = 0;
  std::from_chars(value.data(), value.data() + value.size(), n);
  return n;
}

bool is(const WeaveValues& values, std::string_view id, std::string_view choice) { return text(values, id) == choice; }

OverUnder ratio(const WeaveValues& values, std::string& why) {
  OverUnder order = read_ratio(text(values, "ratio"));
  if (!order.empty()) return order;
  why = quoted(text(values, "ratio")) + " is not a ratio like 2/2; that was taken";
  return {2, 2};
}

std::vector<int> profile(const WeaveValues& values, int blocks, std::string& why, const char* id) {
  std::vector<int> order = read_profile(text(values, id));
  if (order.empty()) {
    why = quoted(text(values, id)) + " is not a profile like A4 B2; A B was taken";
    order = {0, 1};
  }
  for (int& block : order) {
    if (block < blocks) continue;
    why = "this weave has " + std::to_string(blocks) + " blocks; others began again from A";
    block %= blocks;
  }
  return order;
}

Lean lean(const WeaveValues& v) { return is(v, "lean", "left") ? Lean::kLeft : Lean::kRight; }

}  // namespace weftlight::draft
