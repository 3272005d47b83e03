#pragma once
// A weave of the table: name, description, parameters with their ranges, and generator. Values of parameters are text,
// so that a ratio, a profile and a count are stored alike. Names, labels and tips are English; show tr(...) of them.

#include <vector>

#include "weaves/weave_values.h"
#include "weaves/weaves.h"

namespace weftlight::weaves {

enum class ParameterKind {
  kCount,   // a whole number of low..high
  kChoice,  // one of `choices`
  kText,    // text whose syntax `tip` explains: a ratio, a profile, a sequence
};

struct WeaveParameter {
  const char* id;
  const char* label;
  const char* tip;
  ParameterKind kind = ParameterKind::kCount;
  const char* default_value = "";
  int low = 0, high = 0;
  std::vector<const char*> choices = {};
  /// The values from low to high that make a weave, given the parameters before it; null: all.
  std::vector<int> (*allowed)(const WeaveParameter& parameter, const WeaveValues& values) = nullptr;
  /// Names of the choices, in their order; empty: the choices are their own.
  std::vector<const char*> names = {};
  /// Whether the weave of these values has this parameter at all; null: always.
  bool (*used)(const WeaveValues& values) = nullptr;
};

/// Colours of a new draft of the weave.
enum class WeaveColors {
  kTwoTone,   // light warp, dark weft
  kPattern,   // dark pattern weft, tabby in the warp's colour
  kByThread,  // the weave says which threads are light (0), dark (1), or a weft of a third colour (2)
  kOwn,       // the colours are part of the weave
};

struct WeaveKind {
  const char* id;
  const char* name;
  const char* family;       // its group in menus
  const char* description;  // what it is, and what it is for
  std::vector<WeaveParameter> parameters;
  GeneratedWeave (*make)(const WeaveValues& values, ClothSize size);
  WeaveColors colors = WeaveColors::kTwoTone;
};

}  // namespace weftlight::weaves
