#include <algorithm>

#include "base/utf8.h"
#include "wif/parse.h"

namespace weftlight::wif {
namespace {

constexpr size_t kLongest = 300;  // bytes of a text: a quoted name may be as long as a file

/// A line for JSON and for a terminal: bytes that are no UTF-8 are those of a Latin-1 file.
std::string plain(const std::string& text) {
  const std::string line = one_line(is_utf8(text) ? text : to_utf8(text, Encoding::kLatin1));
  return line.size() <= kLongest ? line : std::string(cut_utf8(line, kLongest)) + "...";
}

}  // namespace

void Findings::add(Severity severity, int line_index, std::string_view kind, std::string text, std::string remedy) {
  error_ = error_ || severity == Severity::kError;
  if (!kind.empty()) {
    const auto [at, is_new] = by_kind_.try_emplace(std::string(kind), static_cast<uint32_t>(items_.size()));
    if (!is_new) {
      ++items_[at->second].more;
      return;
    }
  }
  items_.push_back({{severity, line_index + 1, plain(text), plain(remedy)}, 0});
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
  by_kind_.clear();
  return result;
}

int WifHabits::base_of(std::string_view section) const {
  return std::find(zero_based.begin(), zero_based.end(), section) != zero_based.end() ? 0 : 1;
}

}  // namespace weftlight::wif
