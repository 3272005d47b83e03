#pragma once
// Reads the values of a weave's parameters (complete_values in table.h) for its generator.

#include <string>
#include <string_view>
#include <vector>

#include "weaves/table.h"

namespace weftlight::weaves {

/// Empty if there is no such value.
std::string text(const WeaveValues& values, std::string_view id);
/// 0 if there is none.
int count(const WeaveValues& values, std::string_view id);
bool is(const WeaveValues& values, std::string_view id, std::string_view choice);
Lean lean(const WeaveValues& values);
/// If the text cannot be read, `why` says so and a simple value is returned.
OverUnder ratio(const WeaveValues& values, std::string& why);
std::vector<int> profile(const WeaveValues& values, int blocks, std::string& why, const char* id = "profile");

// ---- weaves that take more than one call of generators.h (makers.cpp)
GeneratedWeave make_broken(const WeaveValues& values, ClothSize size);
GeneratedWeave make_satin(const WeaveValues& values, ClothSize size);
GeneratedWeave make_network(const WeaveValues& values, ClothSize size);
GeneratedWeave make_crackle(const WeaveValues& values, ClothSize size);
GeneratedWeave make_substitution(const WeaveValues& values, ClothSize size);
GeneratedWeave make_sections(const WeaveValues& values, ClothSize size);
GeneratedWeave make_sett(const WeaveValues& values, ClothSize size);
GeneratedWeave make_double(const WeaveValues& values, ClothSize size);

}  // namespace weftlight::weaves
