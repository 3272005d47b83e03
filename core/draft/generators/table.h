#pragma once
// Every weave that can be generated: names, words, numbers with their ranges, and what makes it. A dialog, a palette
// of commands and the file all read this one table. Numbers are kept as text, so that a ratio, a profile and a
// count are held alike.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "draft/generators.h"

namespace weftlight::draft {

enum class ParameterKind {
  kCount,   // a whole number of low..high
  kChoice,  // one of `choices`
  kText,    // text whose syntax `tip` explains: a ratio, a profile, a sequence
};

/// Values by id; what is missing has its default value.
using WeaveValues = std::vector<std::pair<std::string, std::string>>;

struct WeaveParameter {
  const char* id;
  const char* label;
  const char* tip;
  ParameterKind kind = ParameterKind::kCount;
  const char* default_value = "";
  int low = 0, high = 0;
  std::vector<const char*> choices = {};
  /// The counts that make the weave, of those from low to high, given the numbers before it; null: all.
  std::vector<int> (*allowed)(const WeaveParameter& number, const WeaveValues& values) = nullptr;
};

/// A whole draft of the asked size. `why`: what could not be taken as it was written, and what was done.
struct GeneratedWeave {
  Design design;
  std::string why;
};

/// What a new draft of the weave is coloured like.
enum class WeaveColors {
  kTwoTone,  // light warp, dark weft
  kPattern,  // dark pattern weft, the tabby between its picks as the warp
  kOwn,      // the colours are part of the weave
};

struct WeaveKind {
  const char* id;
  const char* name;
  const char* family;       // under which a menu shows it
  const char* description;  // what it is, in one sentence
  std::vector<WeaveParameter> parameters;
  GeneratedWeave (*make)(const WeaveValues& values, ClothSize size);
  WeaveColors colors = WeaveColors::kTwoTone;
};

/// In the order of a menu: families stand together.
std::span<const WeaveKind> weave_kinds();
const WeaveKind* find_weave(std::string_view id);
/// Values of every number, those given brought into range.
WeaveValues complete_values(const WeaveKind& kind, const WeaveValues& given);
/// The same, each count also brought to the nearest that makes the weave.
WeaveValues allowed_values(const WeaveKind& kind, const WeaveValues& given);
/// The smallest cloth that shows the weave whole, colours too: one repeat. 0 where that is more than 1,024 threads.
ClothSize repeat_of(const WeaveKind& kind, const WeaveValues& values);
/// The whole number of repeats that is nearest to `about`, at least one; `about` where there is no repeat.
ClothSize whole_repeats(ClothSize repeat, ClothSize about);

/// A draft of the asked size that is the weave alone, coloured as its kind says; the numbers are kept with it.
GeneratedWeave new_draft(const WeaveKind& kind, const WeaveValues& values, ClothSize size);

/// A weave over threads of a draft: over all of them it becomes the draft, which keeps its size, colours (unless
/// the weave has its own) and yarns; over some, their crossings are woven so and the rest stays (factor.h), within the
/// loom. `use` is remembered in place of what was there before. Unchanged, with the reason, where it cannot be.
GeneratedWeave with_weave(Design design, const WeaveUse& use);

}  // namespace weftlight::draft
