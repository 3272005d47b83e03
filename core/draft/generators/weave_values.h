#pragma once
// The numbers of a weave as what makes it takes them: text that was completed (table.h) in, threads and blocks out.

#include <string>
#include <string_view>
#include <vector>

#include "draft/generators/table.h"

namespace weftlight::draft {

/// Empty where there is no such value.
std::string text(const WeaveValues& values, std::string_view id);
/// 0 where there is none.
int count(const WeaveValues& values, std::string_view id);
bool is(const WeaveValues& values, std::string_view id, std::string_view choice);
Lean lean(const WeaveValues& values);
/// What cannot be read is said in `why`, and the plainest that can be woven stands in its place.
OverUnder ratio(const WeaveValues& values, std::string& why);
std::vector<int> profile(const WeaveValues& values, int blocks, std::string& why, const char* id = "profile");

// ---- the weaves that are made of more than one call of generators.h (makers.cpp)
GeneratedWeave make_broken(const WeaveValues& values, ClothSize size);
GeneratedWeave make_satin(const WeaveValues& values, ClothSize size);
GeneratedWeave make_network(const WeaveValues& values, ClothSize size);
GeneratedWeave make_crackle(const WeaveValues& values, ClothSize size);
GeneratedWeave make_substitution(const WeaveValues& values, ClothSize size);
GeneratedWeave make_sections(const WeaveValues& values, ClothSize size);
GeneratedWeave make_sett(const WeaveValues& values, ClothSize size);
GeneratedWeave make_double(const WeaveValues& values, ClothSize size);

}  // namespace weftlight::draft
