#include "weaves/weave_values.h"

#include <algorithm>
#include <charconv>

#include "base/text.h"
#include "weaves/notation.h"

namespace weftlight::weaves {

using base::arg, base::fill, base::tr, base::tr_n;

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

Noted<OverUnder> ratio(const WeaveValues& values) {
  OverUnder order = read_ratio(text(values, "ratio"));
  if (!order.empty()) return {std::move(order), {}};
  // A stand-in: check_values() keeps it from becoming a draft.
  return {{2, 2},
          fill(tr("'{text}' is not a ratio. Write the threads that the warp passes over and under in turn: 2/2, or "
                  "3/1/1/3."),
               arg("text", text(values, "ratio")))};
}

Noted<std::vector<int>> profile(const WeaveValues& values, int blocks, const char* id, int least) {
  Noted<std::vector<int>> read = read_profile(text(values, id));
  std::vector<int>& order = read.value;
  if (order.empty()) {
    read.note = fill(tr("'{text}' is not a profile such as A4 B2; A B is used instead"), arg("text", text(values, id)));
    order = {0, 1};
  }
  for (int& block : order) {
    if (block < blocks) continue;
    read.note = fill(tr_n("this weave has {count} block; further letters start again from A",
                          "this weave has {count} blocks; further letters start again from A", blocks),
                     arg("count", blocks));
    block %= blocks;
  }
  const int used = *std::ranges::max_element(order) + 1;
  for (int block = used; block < least; ++block) order.push_back(block);
  if (used < least)
    read.note = fill(tr_n("this weave needs {count} block; the next letters are added",
                          "this weave needs {count} blocks; the next letters are added", least),
                     arg("count", least));
  return read;
}

Lean lean(const WeaveValues& v) { return is(v, "lean", "left") ? Lean::kLeft : Lean::kRight; }

}  // namespace weftlight::weaves
