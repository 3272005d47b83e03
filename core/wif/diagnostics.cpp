#include <algorithm>

#include "base/utf8.h"
#include "wif/parse.h"

namespace weftlight::wif {
namespace {

constexpr size_t kMaxLinesNamed = 8;
constexpr size_t kLongest = 300;  // bytes of a text: a quoted name may be as long as a file

/// "lines 4, 7 and 12", "lines 4, 7, 8 and on".
std::string line_list(const std::vector<int>& lines, bool all) {
  std::string text = lines.size() == 1 && all ? "line" : "lines";
  for (size_t i = 0; i < lines.size(); ++i)
    text += (i == 0 ? " " : all && i + 1 == lines.size() ? " and " : ", ") + std::to_string(lines[i]);
  return all ? text : text + " and on";
}

/// A line for JSON and for a terminal: bytes that are no UTF-8 are those of a Latin-1 file.
std::string plain(const std::string& text) {
  const std::string line = one_line(is_utf8(text) ? text : to_utf8(text, Encoding::kLatin1));
  return line.size() <= kLongest ? line : std::string(cut_utf8(line, kLongest)) + "...";
}

}  // namespace

void Diagnostics::add(Severity severity, int line_index, std::string_view kind, const std::string& text,
                      const std::string& remedy) {
  error_ = error_ || severity == Severity::kError;
  if (!kind.empty()) {
    const auto [at, is_new] = by_kind_.try_emplace(std::string(kind), static_cast<uint32_t>(items_.size()));
    if (!is_new) {
      Item& item = items_[at->second];
      ++item.more;
      if (line_index >= 0 && item.lines.size() < kMaxLinesNamed) item.lines.push_back(line_index + 1);
      return;
    }
  }
  items_.push_back({{severity, line_index + 1, plain(text), plain(remedy)}, 0, {}});
}

std::vector<Diagnostic> Diagnostics::take() {
  std::vector<Diagnostic> result;
  for (Item& item : items_) {
    if (item.more > 0) {
      const bool all = item.lines.size() == static_cast<size_t>(item.more);
      item.diagnostic.text += " (and " + std::to_string(item.more) + " more like it";
      if (!item.lines.empty()) item.diagnostic.text += ": " + line_list(item.lines, all);
      item.diagnostic.text += ")";
    }
    result.push_back(std::move(item.diagnostic));
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
  items_.clear();
  by_kind_.clear();
  return result;
}

int WifDialect::base_of(std::string_view section) const {
  return std::find(zero_based.begin(), zero_based.end(), section) != zero_based.end() ? 0 : 1;
}

}  // namespace weftlight::wif
