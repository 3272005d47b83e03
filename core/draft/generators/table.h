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

enum class NumberKind {
  kCount,   // a whole number of low..high
  kChoice,  // one of `choices`
  kText,    // words that `words` explains: a ratio, a profile, a sequence
};

struct WeaveNumber {
  const char* id;
  const char* label;
  const char* words;
  NumberKind kind = NumberKind::kCount;
  const char* first = "";  // what it begins with
  int low = 0, high = 0;
  std::vector<const char*> choices = {};
};

/// Values by id; what is missing has its first value.
using WeaveValues = std::vector<std::pair<std::string, std::string>>;

/// A whole draft of the asked size. `why`: what could not be taken as it was written, and what was done.
struct Made {
  Design design;
  std::string why;
};

struct WeaveKind {
  const char* id;
  const char* name;
  const char* family;  // under which a menu shows it
  const char* words;   // what it is, in one sentence
  std::vector<WeaveNumber> numbers;
  Made (*make)(const WeaveValues& values, ClothSize size);
  bool has_colors = false;  // its colours are part of it
};

/// In the order of a menu: families stand together.
std::span<const WeaveKind> weave_kinds();
const WeaveKind* find_weave(std::string_view id);
/// Values of every number, those given brought into range.
WeaveValues complete_values(const WeaveKind& kind, const WeaveValues& given);
/// The smallest cloth that shows the weave whole: one repeat.
ClothSize repeat_of(const WeaveKind& kind, const WeaveValues& values);

/// A weave over threads of a draft: over all of them it becomes the draft, which keeps its size, colours (unless
/// the weave has its own) and yarns; over some, their crossings are woven so and the rest stays (factor.h), within the
/// loom. `use` is remembered in place of what was there before. Unchanged, with the reason, where it cannot be.
Made with_weave(Design design, const WeaveUse& use);

}  // namespace weftlight::draft
