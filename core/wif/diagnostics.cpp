#include <algorithm>

#include "base/text.h"
#include "base/utf8.h"
#include "wif/parse.h"

namespace weftlight::wif {

using base::arg, base::cut_utf8, base::fill, base::is_utf8, base::tr, base::tr_n;

namespace {

constexpr size_t kMaxListedLines = 8;
constexpr size_t kMaxTextBytes = 300;  // a quoted name may be as long as a file

/// "line 4", "lines 4, 7 and 12", "lines 4, 7, 8 and others".
std::string line_list(const std::vector<int>& lines, bool all) {
  std::string list;
  const size_t separated = all && lines.size() > 1 ? lines.size() - 1 : lines.size();
  for (size_t i = 0; i < separated; ++i) list.append(i == 0 ? "" : ", ").append(std::to_string(lines[i]));
  if (!all) return fill(tr("lines {list} and others"), arg("list", list));
  if (lines.size() == 1) return fill(tr("line {line}"), arg("line", list));
  return fill(tr("lines {list} and {last}"), arg("list", list), arg("last", lines.back()));
}

/// One line of UTF-8, for JSON and the terminal. Other bytes come from a Latin-1 file.
std::string plain(const std::string& text) {
  const std::string line = one_line(is_utf8(text) ? text : to_utf8(text, Encoding::kLatin1));
  return line.size() <= kMaxTextBytes ? line : std::string(cut_utf8(line, kMaxTextBytes)) + "...";
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
      if (line_index >= 0 && item.lines.size() < kMaxListedLines) item.lines.push_back(line_index + 1);
      return;
    }
  }
  items_.push_back({{severity, line_index + 1, plain(text), plain(remedy)}, 0, {}});
}

std::vector<Diagnostic> Diagnostics::release() {
  std::vector<Diagnostic> result;
  for (Item& item : items_) {
    if (item.more > 0) {
      const bool all = item.lines.size() == static_cast<size_t>(item.more);
      const auto text = [&](const char* pattern) {
        return fill(pattern, arg("text", item.diagnostic.text), arg("count", item.more),
                    arg("lines", item.lines.empty() ? std::string() : line_list(item.lines, all)));
      };
      item.diagnostic.text =
          item.lines.empty()
              ? text(tr_n("{text} (and {count} more like it)", "{text} (and {count} more like it)", item.more))
              : text(tr_n("{text} (and {count} more like it: {lines})", "{text} (and {count} more like it: {lines})",
                          item.more));
    }
    result.push_back(std::move(item.diagnostic));
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
  items_.clear();
  by_kind_.clear();
  return result;
}

WifRead rejected(std::vector<Diagnostic> diagnostics) {
  base::Error error{base::ErrorKind::kInput, tr("the file cannot be used")};
  const auto first = std::ranges::find(diagnostics, Severity::kError, &Diagnostic::severity);
  if (first != diagnostics.end()) {
    error.text = fill(tr("{problem}; {remedy}"), arg("problem", first->text), arg("remedy", first->remedy));
    error.line = first->line;
  }
  return {base::Failure(std::move(error)), std::move(diagnostics)};
}

int WifDialect::base_of(std::string_view section) const {
  return std::find(zero_based.begin(), zero_based.end(), section) != zero_based.end() ? 0 : 1;
}

}  // namespace weftlight::wif
