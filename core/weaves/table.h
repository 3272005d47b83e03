#pragma once
// The table of weaves: name, description, parameters with their ranges, and generator. Dialogs, commands and files use
// it. Values of parameters are text, so that a ratio, a profile and a count are stored alike. Names, labels and tips
// are English; show tr(...) of them.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "weaves/weave_values.h"
#include "weaves/weaves.h"

namespace weftlight::weaves {

using design::Design, design::WeaveUse;

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

/// In menu order, grouped by family.
std::span<const WeaveKind> weave_kinds();
const WeaveKind* find_weave(std::string_view id);
/// A value for every parameter; given values are clamped to their ranges.
WeaveValues complete_values(const WeaveKind& kind, const WeaveValues& given);
/// The same, with each count changed to the nearest allowed one.
WeaveValues allowed_values(const WeaveKind& kind, const WeaveValues& given);
/// Whether these values make a weave, or the error: a ratio that cannot be read.
base::Result<void> check_values(const WeaveKind& kind, const WeaveValues& values);
/// One repeat of the weave with its colours. 0 if that is more than 1,024 threads.
ClothSize repeat_of(const WeaveKind& kind, const WeaveValues& values);
/// The whole number of repeats nearest to `about`, at least one; `about` if there is no repeat.
ClothSize whole_repeats(ClothSize repeat, ClothSize about);

/// A new draft of the requested size with the weave in its colours; the parameters are stored with it.
GeneratedWeave new_draft(const WeaveKind& kind, const WeaveValues& values, ClothSize size);

/// Applies a weave to threads of a draft. Applied to all threads, it replaces threading, tie-up and treadling; size,
/// yarns and (unless the weave has its own) colours stay. Applied to some, only their crossings change (factor.h),
/// within the loom's limits. `use` is stored instead of weaves that it overlaps. Refused as check_values().
base::Result<GeneratedWeave> with_weave(Design design, const WeaveUse& use);

}  // namespace weftlight::weaves
