#include "weaves/parameters.h"

#include "base/mark.h"

namespace weftlight::weaves {

using base::mark;

WeaveParameter count_parameter(const char* id, const char* label, const char* tip, int low, int high,
                               const char* default_value) {
  return {id, label, tip, ParameterKind::kCount, default_value, low, high, {}};
}

WeaveParameter choice_parameter(const char* id, const char* label, const char* tip, std::vector<const char*> choices) {
  const char* default_value = choices.front();
  return {id, label, tip, ParameterKind::kChoice, default_value, 0, 0, std::move(choices)};
}

WeaveParameter text_parameter(const char* id, const char* label, const char* tip, const char* default_value) {
  return {id, label, tip, ParameterKind::kText, default_value, 0, 0, {}};
}

WeaveParameter ratio_parameter(const char* default_value) {
  return text_parameter("ratio", mark("Ratio"),
                        mark("Threads the warp passes over, then under, and so on: 2/2, or 3/1/1/3"), default_value);
}

WeaveParameter lean_parameter() {
  return choice_parameter("lean", mark("Direction"), mark("Direction of the twill line"),
                          {mark("right"), mark("left")});
}

WeaveParameter face_parameter() {
  return choice_parameter("face", mark("Face"), mark("System that floats on the front"), {mark("warp"), mark("weft")});
}

WeaveParameter profile_parameter(const char* default_value) {
  return text_parameter("profile", mark("Profile"),
                        mark("Order of the blocks, each with its length: A4 B2 C1; repeats in brackets: 3x(A B)"),
                        default_value);
}

WeaveParameter weft_profile_parameter() {
  return text_parameter("weft_profile", mark("Weft profile"), mark("Order of the weft blocks; empty: as drawn in"), "");
}

WeaveParameter turned_parameter() {
  return choice_parameter("turned", mark("Turned"),
                          mark("Warp and weft change places, so that one shuttle weaves what takes two"),
                          {mark("no"), mark("yes")});
}

std::vector<WeaveParameter> unit_parameters(std::span<const BlockTemplate> units, const char* profile,
                                            std::vector<WeaveParameter> own) {
  std::vector<WeaveParameter> all;
  if (units.size() > 1) {
    std::vector<const char*> kinds;
    for (const BlockTemplate& unit : units) kinds.push_back(unit.id);
    all.push_back(choice_parameter("kind", mark("Kind"), "", std::move(kinds)));
  }
  all.push_back(profile_parameter(profile));
  for (WeaveParameter& parameter : own) all.push_back(std::move(parameter));
  all.push_back(weft_profile_parameter());
  all.push_back(turned_parameter());
  return all;
}

}  // namespace weftlight::weaves
