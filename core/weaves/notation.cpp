#include "weaves/notation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "base/text.h"

namespace weftlight::weaves {

using base::arg, base::fill, base::tr;
using draft::Rgb, draft::kMaxShafts, draft::kMaxThreads;

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

// The number at `at`, at most kMaxThreads; -1 if there is none.
int number_at(std::string_view text, size_t& at) {
  if (at >= text.size() || !is_digit(text[at])) return -1;
  int value = 0;
  while (at < text.size() && is_digit(text[at])) value = std::min(value * 10 + (text[at++] - '0'), kMaxThreads);
  return value;
}

constexpr std::string_view kBlanks = " ,\t\n";

void skip_blanks(std::string_view text, size_t& at) {
  while (at < text.size() && kBlanks.find(text[at]) != kBlanks.npos) ++at;
}

constexpr int kMaxDepth = 32;  // of nested brackets

struct SequenceReader {
  std::string_view text;
  int most;
  size_t at = 0;
  std::string note;

  void fail(const std::string& what) {
    if (note.empty()) note = fill(tr("{problem} at character {at}"), arg("problem", what), arg("at", at + 1));
    at = text.size();
  }
  void append(std::vector<int>& to, const std::vector<int>& part, int times) {
    for (int i = 0; i < times; ++i) {
      if (to.size() + part.size() > static_cast<size_t>(kMaxThreads)) return fail(tr("too many threads"));
      to.insert(to.end(), part.begin(), part.end());
    }
  }
  bool is_at(std::string_view any) const { return at < text.size() && any.find(text[at]) != any.npos; }
  /// "3x" or "3*", or "3" before a bracket; 1 if there is none.
  int count_before() {
    const size_t begin = at;
    const int times = number_at(text, at);
    skip_blanks(text, at);
    const bool sign = is_at("x*");
    if (times >= 0 && sign) ++at, skip_blanks(text, at);
    if (times >= 0 && (sign || is_at("("))) return times;
    at = begin;
    return 1;
  }
  /// "5" or "5-8".
  std::vector<int> run() {
    const int from = number_at(text, at);
    skip_blanks(text, at);
    int last = from;
    if (is_at("-")) {
      ++at;
      skip_blanks(text, at);
      last = number_at(text, at);
    }
    std::vector<int> threads;
    if (from < 1 || last < 1 || from > most || last > most) {
      fail(fill(tr("a number outside 1 to {most}"), arg("most", most)));
      return threads;
    }
    const int step = from <= last ? 1 : -1;
    for (int i = from; i != last + step; i += step) threads.push_back(i - 1);
    return threads;
  }
  // Until a closing bracket or the end.
  std::vector<int> parts(int depth) {
    std::vector<int> out;
    for (skip_blanks(text, at); at < text.size() && text[at] != ')'; skip_blanks(text, at)) {
      const size_t begin = at;
      const int times = count_before();
      if (at < text.size() && is_digit(text[at])) {
        append(out, run(), times);
        continue;
      }
      if (!is_at("(") || depth >= kMaxDepth) {
        at = begin;
        fail(depth >= kMaxDepth ? tr("brackets nested too deeply") : tr("neither a number nor a bracket"));
        return out;
      }
      ++at;
      const std::vector<int> inside = parts(depth + 1);
      if (at >= text.size()) {
        if (note.empty()) note = tr("a bracket is not closed");
        return out;
      }
      ++at;
      append(out, inside, times);
    }
    return out;
  }
};

/// Blocks and brackets, each with a count before or behind it. What is neither is passed over, and noted.
struct ProfileReader {
  std::string_view text;
  size_t at = 0;
  std::string note{};

  bool is_at(std::string_view any) const { return at < text.size() && any.find(text[at]) != any.npos; }
  /// "3", "3x" or "3*" before a part; 1 if there is none.
  size_t count_before() {
    const int times = number_at(text, at);
    if (times < 0) return 1;
    if (is_at("x*")) ++at;
    skip_blanks(text, at);
    return static_cast<size_t>(times);
  }
  /// "3", "3x" or "*3" behind a part; 1 if there is none, or if it is that of a bracket behind it: "A 3x(B C)".
  size_t count_behind() {
    const size_t begin = at;
    skip_blanks(text, at);
    const bool apart = at > begin, star = is_at("*");
    if (star) ++at, skip_blanks(text, at);
    const int times = number_at(text, at);
    if (times >= 0 && is_at("x")) ++at;
    const size_t end = at;
    while (is_at(" ")) ++at;
    const bool of_next = apart && !star && is_at("(");
    at = times < 0 || of_next ? begin : end;
    return times < 0 || of_next ? 1 : static_cast<size_t>(times);
  }
  void append(std::vector<int>& to, const std::vector<int>& part, size_t times) {
    const size_t room = static_cast<size_t>(kMaxThreads) - to.size();
    const size_t whole = std::min(room / part.size(), times);
    for (size_t i = 0; i < whole; ++i) to.insert(to.end(), part.begin(), part.end());
  }
  /// A block or a bracket; empty if there is none.
  std::vector<int> part(int depth) {
    const char c = at < text.size() ? upper(text[at]) : '\0';
    if (c >= 'A' && c <= 'Z') return ++at, std::vector<int>{c - 'A'};
    if (c != '(' || depth >= kMaxDepth) return {};
    ++at;
    std::vector<int> inside = parts(depth + 1);
    if (is_at(")")) ++at;
    else if (note.empty()) note = tr("a bracket is not closed");
    return inside;
  }
  // Until a closing bracket or the end.
  std::vector<int> parts(int depth) {
    std::vector<int> out;
    for (skip_blanks(text, at); at < text.size() && !(depth > 0 && is_at(")")); skip_blanks(text, at)) {
      const size_t begin = at;
      const size_t before = count_before();
      const std::vector<int> one = part(depth);
      if (one.empty()) {
        if (at == begin) ++at;
        if (note.empty()) note = fill(tr("'{text}' is not read"), arg("text", text.substr(begin, at - begin)));
        continue;
      }
      append(out, one, before * count_behind());
    }
    return out;
  }
};

struct NamedColor {
  std::string_view code;
  Rgb rgb;
};

constexpr Rgb bytes(int r, int g, int b) {
  return {static_cast<float>(r) / 255, static_cast<float>(g) / 255, static_cast<float>(b) / 255};
}

// Letters of the tartan registers; a prefix L or D means light or dark. The shades are our choice.
constexpr std::array kTartanColors = {
    NamedColor{"K", bytes(24, 24, 26)},    NamedColor{"R", bytes(190, 30, 38)},  NamedColor{"B", bytes(38, 58, 120)},
    NamedColor{"G", bytes(22, 88, 52)},    NamedColor{"Y", bytes(228, 184, 40)}, NamedColor{"W", bytes(240, 238, 230)},
    NamedColor{"N", bytes(132, 132, 130)}, NamedColor{"T", bytes(98, 66, 42)},   NamedColor{"A", bytes(96, 148, 196)},
    NamedColor{"P", bytes(96, 46, 110)},   NamedColor{"O", bytes(220, 112, 36)}, NamedColor{"C", bytes(150, 26, 60)},
    NamedColor{"M", bytes(112, 24, 46)},   NamedColor{"S", bytes(206, 52, 40)},
};

Rgb mixed(Rgb a, Rgb b, float weight) {
  return {a.r + (b.r - a.r) * weight, a.g + (b.g - a.g) * weight, a.b + (b.b - a.b) * weight};
}

std::optional<Rgb> tartan_color(std::string_view code) {
  for (const NamedColor& c : kTartanColors)
    if (c.code == code) return c.rgb;
  if (code.size() != 2 || (code[0] != 'L' && code[0] != 'D')) return {};
  const std::optional<Rgb> plain = tartan_color(code.substr(1));
  if (!plain) return {};
  return code[0] == 'L' ? mixed(*plain, {1, 1, 1}, 0.35f) : mixed(*plain, {0, 0, 0}, 0.4f);
}

std::string tartan_letters() {
  std::string letters;
  for (const NamedColor& c : kTartanColors) letters.append(letters.empty() ? "" : " ").append(c.code);
  return letters;
}

// "#rrggbb" at `at`.
std::optional<Rgb> hex_color(std::string_view text, size_t& at) {
  if (at + 7 > text.size() || text[at] != '#') return {};
  int value = 0;
  for (size_t i = at + 1; i < at + 7; ++i) {
    const char c = upper(text[i]);
    const int digit = is_digit(c) ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
    if (digit < 0) return {};
    value = value * 16 + digit;
  }
  at += 7;
  return bytes(value >> 16, (value >> 8) & 255, value & 255);
}

int palette_index(std::vector<Rgb>& palette, Rgb color) {
  const auto found = std::ranges::find(palette, color);
  if (found != palette.end()) return static_cast<int>(found - palette.begin());
  palette.push_back(color);
  return static_cast<int>(palette.size()) - 1;
}

std::string_view without_blanks(std::string_view text) {
  size_t begin = 0;
  skip_blanks(text, begin);
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// Takes the dots before and behind a sett away; true if there were any.
bool take_dots(std::string_view& text) {
  text = without_blanks(text);
  bool taken = false;
  for (const std::string_view dots : {"...", "\xE2\x80\xA6"}) {
    if (text.starts_with(dots)) text.remove_prefix(dots.size()), taken = true;
    if (text.ends_with(dots)) text.remove_suffix(dots.size()), taken = true;
  }
  return taken;
}

/// The fewest threads that, repeated, make all of them; the last repeat may be cut. (Knuth, Morris and Pratt.)
size_t repeat_of(std::span<const int> threads) {
  std::vector<size_t> overlap(threads.size());  // of the start with the end of the threads up to each
  for (size_t i = 1, same = 0; i < threads.size(); ++i) {
    while (same > 0 && threads[i] != threads[same]) same = overlap[same - 1];
    if (threads[i] == threads[same]) ++same;
    overlap[i] = same;
  }
  return threads.empty() ? 0 : threads.size() - overlap.back();
}

}  // namespace

OverUnder read_ratio(std::string_view text) {
  constexpr std::string_view kBetween = " /,-:";
  OverUnder order;
  int sum = 0;
  for (size_t at = 0; at < text.size();) {
    const int n = number_at(text, at);
    if (n == 0 || sum + n > kMaxShafts) return {};
    if (n < 0 && kBetween.find(text[at++]) == kBetween.npos) return {};
    if (n < 0) continue;
    order.push_back(n);
    sum += n;
  }
  if (order.size() == 1 && 2 * sum <= kMaxShafts) order.push_back(order[0]);
  return order.size() % 2 == 1 ? OverUnder{} : order;
}

Noted<std::vector<int>> read_profile(std::string_view text) {
  ProfileReader reader{text};
  std::vector<int> blocks = reader.parts(0);
  return {std::move(blocks), std::move(reader.note)};
}

Noted<std::vector<int>> read_sequence(std::string_view text, int most) {
  SequenceReader reader{text, most, 0, {}};
  std::vector<int> threads = reader.parts(0);
  if (reader.note.empty() && reader.at < text.size()) reader.fail(tr("an unmatched closing bracket"));
  return {std::move(threads), std::move(reader.note)};
}

std::string sequence_text(std::span<const int> threads) {
  std::string text;
  const std::span<const int> once = threads.first(repeat_of(threads));
  for (size_t i = 0, next = 0; i < once.size(); i = next) {
    while (next < once.size() && once[next] == once[i]) ++next;
    if (i > 0) text += ' ';
    if (next - i > 1) text.append(std::to_string(next - i)).append("x");
    text.append(std::to_string(once[i] + 1));
  }
  return text;
}

Noted<Sett> read_sett(std::string_view text) {
  Noted<Sett> read;
  Sett& out = read.value;
  bool pivots = false;
  const bool full = take_dots(text);
  for (size_t at = 0; at < text.size();) {
    skip_blanks(text, at);
    if (at >= text.size()) break;
    const size_t begin = at;
    std::optional<Rgb> color = hex_color(text, at);
    if (!color) {
      std::string code;
      while (at < text.size() && std::isalpha(static_cast<unsigned char>(text[at]))) code += upper(text[at++]);
      color = tartan_color(code);
    }
    skip_blanks(text, at);
    if (at < text.size() && text[at] == '/') {
      pivots = true;
      ++at;
    }
    const int threads = number_at(text, at);
    if (!color || threads < 0) {
      const std::string_view rest = text.substr(begin, 12);
      read.note = fill(tr("'{text}' is not a colour with a number of threads; colours are {letters}, darker with D "
                          "before it and lighter with L, or #rrggbb"),
                       arg("text", rest.substr(0, rest.find_last_not_of(' ') + 1)), arg("letters", tartan_letters()));
      break;
    }
    out.stripes.push_back({palette_index(out.palette, *color), threads});
  }
  if (pivots && !full)
    for (int i = static_cast<int>(out.stripes.size()) - 2; i > 0; --i)
      out.stripes.push_back(Stripe(out.stripes[static_cast<size_t>(i)]));
  return read;
}

}  // namespace weftlight::weaves
