#pragma once
// Values of a weave's parameters as text, and how its generator reads them.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "weaves/weaves.h"

namespace weftlight::weaves {

/// Values by id; what is missing has its default value (complete_values in table.h).
using WeaveValues = std::vector<std::pair<std::string, std::string>>;

/// Empty if there is no such value.
std::string text(const WeaveValues& values, std::string_view id);
/// 0 if there is none.
int count(const WeaveValues& values, std::string_view id);
bool is(const WeaveValues& values, std::string_view id, std::string_view choice);
Lean lean(const WeaveValues& values);
/// A simple value if the text cannot be read.
Noted<OverUnder> ratio(const WeaveValues& values);
inline constexpr int kMaxBlocks = 26;  // A to Z
/// Of `least` to `blocks` different blocks.
Noted<std::vector<int>> profile(const WeaveValues& values, int blocks, const char* id = "profile", int least = 1);

}  // namespace weftlight::weaves
