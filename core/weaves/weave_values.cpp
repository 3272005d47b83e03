#include "weaves/weave_values.h"

#include <charconv>

#include "base/text.h"
#include "weaves/families.h"

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

OverUnder ratio(const WeaveValues& values, std::string& why) {
  OverUnder order = read_ratio(text(values, "ratio"));
  if (!order.empty()) return order;
  why =
      fill(tr("'{text}' is no ratio. Write the threads that the warp passes over and under in turn: 2/2, or 3/1/1/3."),
           arg("text", text(values, "ratio")));
  return {2, 2};  // a stand-in: why_refused() keeps it from becoming a draft
}

std::string why_refused(const WeaveKind& kind, const WeaveValues& values) {
  std::string why;
  for (const WeaveParameter& parameter : kind.parameters)
    if (std::string_view(parameter.id) == "ratio") ratio(complete_values(kind, values), why);
  return why;
}

std::vector<int> profile(const WeaveValues& values, int blocks, std::string& why, const char* id) {
  std::vector<int> order = read_profile(text(values, id));
  if (order.empty()) {
    why = fill(tr("'{text}' is not a profile such as A4 B2; A B is used instead"), arg("text", text(values, id)));
    order = {0, 1};
  }
  for (int& block : order) {
    if (block < blocks) continue;
    why = fill(tr_n("this weave has {count} block; further letters start again from A",
                    "this weave has {count} blocks; further letters start again from A", blocks),
               arg("count", blocks));
    block %= blocks;
  }
  return order;
}

Lean lean(const WeaveValues& v) { return is(v, "lean", "left") ? Lean::kLeft : Lean::kRight; }

}  // namespace weftlight::weaves
