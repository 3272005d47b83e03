#pragma once
// Parameters that several weaves have, and how their values reach a generator. For the rows of the table.

#include <span>
#include <utility>
#include <vector>

#include "weaves/families.h"
#include "weaves/table.h"

namespace weftlight::weaves {

WeaveParameter count_parameter(const char* id, const char* label, const char* tip, int low, int high,
                               const char* default_value);
/// The first choice is the default.
WeaveParameter choice_parameter(const char* id, const char* label, const char* tip, std::vector<const char*> choices);
WeaveParameter text_parameter(const char* id, const char* label, const char* tip, const char* default_value);
WeaveParameter ratio_parameter(const char* default_value);
WeaveParameter lean_parameter();
/// The system on the front.
WeaveParameter face_parameter();
WeaveParameter profile_parameter(const char* default_value);
WeaveParameter weft_profile_parameter();
WeaveParameter turned_parameter();
/// What make_units() reads: which of `units` if there are several, the profiles, `own` parameters of the weave, turned.
std::vector<WeaveParameter> unit_parameters(std::span<const BlockTemplate> units, const char* profile,
                                            std::vector<WeaveParameter> own = {});

template <auto kMake>
GeneratedWeave from_ratio(const WeaveValues& v, ClothSize size) {
  auto [order, note] = ratio(v);
  return {kMake(order, v, size), std::move(note)};
}

template <auto kMake, int kBlocks>
GeneratedWeave from_profile(const WeaveValues& v, ClothSize size) {
  auto [blocks, note] = profile(v, kBlocks);
  return {kMake(blocks, v, size), std::move(note)};
}

/// A weave that is a unit, or one of several.
template <const auto& kUnits>
GeneratedWeave from_units(const WeaveValues& v, ClothSize size) {
  return make_units(kUnits, v, size);
}

}  // namespace weftlight::weaves
