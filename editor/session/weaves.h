#pragma once
// The weaves that a new draft can begin with: core/draft/generators.h as a table with words and numbers.

#include <array>
#include <span>
#include <vector>

#include "draft/generators.h"
#include "session/names.h"

namespace weftlight::session {

inline constexpr int kWeaveNumbers = 3;

struct WeaveNumber {
  const char* label = nullptr;  // null: the weave has no such number
  int min = 0, max = 0, start = 0;
  /// The values that make the weave, of those from min to max, given the numbers before it; null: all.
  std::vector<int> (*choices)(const std::array<int, kWeaveNumbers>& n) = nullptr;
};
struct Weave {
  const char* name;
  const char* words;  // what it is, in one sentence
  std::array<WeaveNumber, kWeaveNumbers> numbers;
  Design (*make)(const std::array<int, kWeaveNumbers>& n, ClothSize size);
};
/// The first is the bare loom: a straight draw.
std::span<const Weave> weaves();

std::array<int, kWeaveNumbers> first_numbers(const Weave& weave);
/// Each number brought to the nearest that makes the weave.
std::array<int, kWeaveNumbers> valid_numbers(const Weave& weave, std::array<int, kWeaveNumbers> n);
/// Ends and picks after which the weave begins again, colours too; 0 where that is more than 256.
ClothSize repeat_of(const Weave& weave, const std::array<int, kWeaveNumbers>& n);
/// The whole number of repeats that is nearest to `about`, at least one; `about` where there is no repeat.
ClothSize whole_repeats(ClothSize repeat, ClothSize about);

/// Steps that bind a satin of so many shafts evenly: they share no factor with it, and neither 1 nor shafts - 1, which
/// are twills. None for 6 (and below 5).
std::vector<int> satin_steps(int shafts);

/// A straight threading and a balanced twill, two colours.
Design straight_draw(int shafts, int treadles, ClothSize size);

}  // namespace weftlight::session
