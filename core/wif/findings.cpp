#include <algorithm>

#include "wif/parse.h"

namespace weftlight::wif {

void Findings::add(Severity severity, int line_index, std::string_view kind, std::string text, std::string remedy) {
  error_ = error_ || severity == Severity::kError;
  for (Item& item : items_) {
    if (!kind.empty() && item.kind == kind) {
      ++item.more;
      return;
    }
  }
  items_.push_back({{severity, line_index + 1, std::move(text), std::move(remedy)}, std::string(kind), 0});
}

std::vector<Diagnostic> Findings::take() {
  std::vector<Diagnostic> result;
  for (Item& item : items_) {
    if (item.more > 0) {
      item.diagnostic.text += " (and " + std::to_string(item.more) + " more like it)";
    }
    result.push_back(std::move(item.diagnostic));
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
  items_.clear();
  return result;
}

int WifHabits::base_of(std::string_view section) const {
  return std::find(zero_based.begin(), zero_based.end(), section) != zero_based.end() ? 0 : 1;
}

}  // namespace weftlight::wif
