// Weave codes of ISO 9354: plain weaves, twills and satins as four groups of numbers.

#include <algorithm>
#include <numeric>

#include "base/text.h"
#include "weaves/families.h"

namespace weftlight::weaves {

using base::arg, base::fill, base::tr;
using draft::BitMatrix;

namespace {

constexpr int kMaxRepeat = 1024;  // picks or ends of a repeat that is read
constexpr int kMaxWritten = 64;   // of one that is written; codes of larger ones are no use
enum Kind { kPlain = 1, kTwill = 2, kSatin = 3 };

bool is_digit(char c) { return c >= '0' && c <= '9'; }

using Column = std::vector<char>;  // of picks, 1 where the end is up

/// Numbers with blanks between; digits without are numbers of two digits each. Empty if there is something else.
std::vector<int> numbers_of(std::string_view part) {
  std::vector<int> out;
  for (size_t at = 0; at < part.size();) {
    if (part[at] == ' ') {
      ++at;
    } else if (is_digit(part[at])) {
      const bool two = at + 1 < part.size() && is_digit(part[at + 1]);
      out.push_back(two ? 10 * (part[at] - '0') + (part[at + 1] - '0') : part[at] - '0');
      at += two ? 2 : 1;
    } else {
      return {};
    }
  }
  return out;
}

/// The column so many picks higher.
Column risen(const Column& column, int picks) {
  const auto n = static_cast<int>(column.size());
  Column out(column.size());
  for (int p = 0; p < n; ++p) out[static_cast<size_t>(((p + picks) % n + n) % n)] = column[static_cast<size_t>(p)];
  return out;
}

Column opposite(Column column) {
  for (char& up : column) up = up ? 0 : 1;
  return column;
}

struct Code {
  int kind = kPlain;
  bool up = true;
  std::vector<int> runs, groups, steps;

  int picks() const { return std::accumulate(runs.begin(), runs.end(), 0); }
  Column first() const {
    Column out;
    bool over = up;
    for (const int run : runs) out.insert(out.end(), static_cast<size_t>(run), over ? 1 : 0), over = !over;
    return out;
  }
  /// The columns of a repeat; of more than `most` ends, none.
  std::vector<Column> columns(int most) const {
    std::vector<Column> out;
    const auto add = [&](const Column& column, int times) {
      for (int i = 0; i < times && static_cast<int>(out.size()) <= most; ++i) out.push_back(column);
    };
    Column column = first();
    if (kind == kPlain) {
      const size_t turns = groups.size() % 2 == 0 ? groups.size() : 2 * groups.size();
      for (size_t i = 0; i < turns; ++i, column = opposite(column)) add(column, groups[i % groups.size()]);
    } else {
      const int n = picks();
      const size_t many = steps.size() > 1 ? steps.size() + 1 : static_cast<size_t>(n / std::gcd(steps[0], n));
      for (size_t i = 0; i < many; ++i) {
        add(column, groups[0]);
        column = risen(column, steps[i % steps.size()]);
      }
    }
    return static_cast<int>(out.size()) > most ? std::vector<Column>{} : out;
  }
  std::string text() const {
    const auto joined = [](const std::vector<int>& numbers) {
      std::string out;
      for (const int n : numbers)
        out.append(out.empty() ? "" : " ").append(n < 10 ? "0" : "").append(std::to_string(n));
      return out;
    };
    return std::to_string(kind).append(up ? "0-" : "1-") + joined(runs) + "-" + joined(groups) + "-" + joined(steps);
  }
};

base::Failure refused(std::string_view code, const char* why) {
  return base::failure(base::ErrorKind::kInput, fill(tr("'{text}' is not an ISO 9354 weave code: {problem}"),
                                                     arg("text", code), arg("problem", why)));
}

bool any_zero(const std::vector<int>& numbers) { return std::ranges::find(numbers, 0) != numbers.end(); }

/// What is wrong with a code whose parts are numbers; null: nothing.
const char* problem_of_code(const Code& code) {
  const bool plain = code.kind == kPlain;
  if (code.kind < kPlain || code.kind > kSatin)
    return tr("it begins with 10 or 11 for plain weaves, 20 or 21 for twills, 30 or 31 for satins");
  if (code.runs.size() < 2 || any_zero(code.runs)) return tr("the second part needs picks above and below end 1");
  if (any_zero(code.groups)) return tr("the third part counts ends that weave alike, from 01");
  if (!plain && code.groups.size() > 1) return tr("the third part of twills and satins is one number");
  if (plain && (code.steps.size() > 1 || code.steps[0] != 0)) return tr("the fourth part of plain weaves is 00");
  if (!plain && any_zero(code.steps)) return tr("the fourth part counts the picks by which the ends rise, from 01");
  if (code.kind == kTwill && code.steps.size() > 1) return tr("the fourth part of twills is one number");
  return nullptr;
}

/// The lengths of the runs of equal crossings, from the first pick on.
std::vector<int> runs_of(const Column& column) {
  std::vector<int> runs;
  for (size_t p = 0; p < column.size(); ++p) {
    if (p == 0 || column[p] != column[p - 1]) runs.push_back(0);
    ++runs.back();
  }
  return runs;
}

/// By how many picks `to` is higher than `from`; 0: by none, or they differ otherwise.
int rise(const Column& from, const Column& to) {
  for (int step = 1; step < static_cast<int>(from.size()); ++step)
    if (risen(from, step) == to) return step;
  return 0;
}

/// The code of columns that begin with a group, whose first pick begins a run above it; empty runs if there is none.
Code code_of(const std::vector<Column>& columns) {
  Code code{kPlain, true, runs_of(columns[0]), {}, {}};
  std::vector<Column> groups;
  for (const Column& column : columns) {
    if (groups.empty() || column != groups.back()) groups.push_back(column), code.groups.push_back(0);
    ++code.groups.back();
  }
  const bool alike = std::ranges::adjacent_find(code.groups, std::ranges::not_equal_to{}) == code.groups.end();
  bool plain = groups.size() % 2 == 0;
  for (size_t i = 1; i < groups.size(); ++i) plain = plain && groups[i] == opposite(groups[i - 1]);
  if (alike) code.groups.resize(1);
  code.steps = {0};
  if (plain) return code;
  if (!alike) return {};
  const bool satin = code.runs.size() == 2 && std::min(code.runs[0], code.runs[1]) == 1 && code.groups[0] == 1;
  code.steps.clear();
  for (size_t i = 1; i < groups.size(); ++i) code.steps.push_back(rise(groups[i - 1], groups[i]));
  if (code.steps.empty() || any_zero(code.steps)) return {};
  const int step = code.steps[0], n = code.picks();
  if (std::ranges::all_of(code.steps, [step](int s) { return s == step; })) code.steps.resize(1);
  const bool regular = code.steps.size() == 1, twill = regular && (step == 1 || step == n - 1);
  code.kind = satin && !twill && (!regular || std::gcd(step, n) == 1) ? kSatin : kTwill;
  return code.kind == kTwill && !regular ? Code{} : code;
}

}  // namespace

base::Result<BitMatrix> read_iso_code(std::string_view text) {
  std::vector<std::vector<int>> parts;
  for (size_t at = 0; at <= text.size() && parts.size() < 5;) {
    const size_t end = std::min(text.find('-', at), text.size());
    parts.push_back(numbers_of(text.substr(at, end - at)));
    at = end + 1;
  }
  if (parts.size() != 4 || std::ranges::any_of(parts, [](const auto& p) { return p.empty(); }) ||
      parts[0].size() != 1 || parts[0][0] % 10 > 1)
    return refused(text, tr("it has four parts with lines between, as 20-02 02-01-01"));
  const Code code{parts[0][0] / 10, parts[0][0] % 10 == 0, parts[1], parts[2], parts[3]};
  if (const char* why = problem_of_code(code)) return refused(text, why);
  const std::vector<Column> columns = code.picks() > kMaxRepeat ? std::vector<Column>{} : code.columns(kMaxRepeat);
  if (columns.empty()) return refused(text, tr("its repeat has more than 1,024 threads"));
  BitMatrix repeat(code.picks(), static_cast<int>(columns.size()));
  for (int e = 0; e < repeat.cols(); ++e)
    for (int p = 0; p < repeat.rows(); ++p)
      repeat.set(p, e, columns[static_cast<size_t>(e)][static_cast<size_t>(p)] != 0);
  return repeat;
}

std::string iso_code(const BitMatrix& cells, ClothSize repeat) {
  const auto [ends, picks] = repeat;
  if (picks < 2 || ends < 2 || picks > kMaxWritten || ends > kMaxWritten) return {};
  std::string best;
  // From every corner where a group of ends and a run of picks begin; the greatest code is the one that is written.
  for (int e0 = 0; e0 < ends; ++e0)
    for (int p0 = 0; p0 < picks; ++p0) {
      if (!cells.get(p0, e0) || cells.get((p0 + picks - 1) % picks, e0)) continue;
      std::vector<Column> columns(static_cast<size_t>(ends));
      for (int e = 0; e < ends; ++e)
        for (int p = 0; p < picks; ++p)
          columns[static_cast<size_t>(e)].push_back(cells.get((p0 + p) % picks, (e0 + e) % ends) ? 1 : 0);
      if (columns.front() == columns.back()) continue;
      const Code code = code_of(columns);
      if (!code.runs.empty() && code.columns(ends) == columns) best = std::max(best, code.text());
    }
  return best;
}

}  // namespace weftlight::weaves
