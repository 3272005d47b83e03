#include "commands/closest_word.h"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

namespace weftlight::commands {
namespace {

/// The number of letters to change, to add or to leave out. Based on: V. I. Levenshtein, Binary codes capable of
/// correcting deletions, insertions and reversals, 1966.
size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 0; i < a.size(); ++i) {
    size_t corner = std::exchange(row[0], i + 1);
    for (size_t k = 0; k < b.size(); ++k) {
      const size_t changed = corner + (a[i] != b[k]);
      corner = row[k + 1];
      row[k + 1] = std::min({changed, corner + 1, row[k] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string closest_word(const std::string& typed, std::span<const std::string> words) {
  constexpr size_t kMaxDistance = 3;
  std::string closest;
  const size_t dashes = std::min(typed.find_first_not_of('-'), typed.size());  // of an option
  size_t apart = std::min(kMaxDistance, (typed.size() - dashes) / 2) + 1;
  for (const std::string& word : words) {
    const size_t letters = edit_distance(typed, word);
    if (letters < apart) apart = letters, closest = word;
  }
  return closest;
}

}  // namespace weftlight::commands
