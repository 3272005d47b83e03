#pragma once
// The weaves that a new draft can begin with: core/draft/generators.h as a table with words and numbers.

#include <array>
#include <span>

#include "draft/generators.h"
#include "session/names.h"

namespace weftlight::session {

inline constexpr int kWeaveNumbers = 3;

struct WeaveNumber {
  const char* label = nullptr;  // null: the weave has no such number
  int min = 0, max = 0, start = 0;
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

/// A straight threading and a balanced twill, two colours.
Design straight_draw(int shafts, int treadles, ClothSize size);

}  // namespace weftlight::session
