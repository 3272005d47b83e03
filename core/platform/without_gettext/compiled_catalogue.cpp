// Source: GNU gettext manual, The Format of GNU MO Files, and Plural forms.

#include "platform/without_gettext/compiled_catalogue.h"

#include <algorithm>
#include <array>
#include <utility>

namespace weftlight::platform {
namespace {

constexpr uint32_t kMagic = 0x950412de;  // of a file in the order of bytes that x86 and ARM have

/// Reads a rule from left to right; of C's operators those that gettext has.
class PluralRule {
 public:
  PluralRule(std::string_view rule, uint64_t count) : rest_(rule), count_(count) {}

  std::optional<uint64_t> value() {
    const uint64_t all = choice();
    skip_spaces();
    return good_ && rest_.empty() ? std::optional(all) : std::nullopt;
  }

 private:
  static constexpr int kMaxDepth = 50, kLevels = 6;
  struct Operator {
    std::string_view sign;
    int level;  // the higher, the closer it binds
    uint64_t (*apply)(uint64_t, uint64_t);
  };
  // Those of two signs before those that begin alike.
  static constexpr std::array<Operator, 13> kOperators = {
      {{"||", 0, [](uint64_t a, uint64_t b) -> uint64_t { return a != 0 || b != 0; }},
       {"&&", 1, [](uint64_t a, uint64_t b) -> uint64_t { return a != 0 && b != 0; }},
       {"==", 2, [](uint64_t a, uint64_t b) -> uint64_t { return a == b; }},
       {"!=", 2, [](uint64_t a, uint64_t b) -> uint64_t { return a != b; }},
       {"<=", 3, [](uint64_t a, uint64_t b) -> uint64_t { return a <= b; }},
       {">=", 3, [](uint64_t a, uint64_t b) -> uint64_t { return a >= b; }},
       {"<", 3, [](uint64_t a, uint64_t b) -> uint64_t { return a < b; }},
       {">", 3, [](uint64_t a, uint64_t b) -> uint64_t { return a > b; }},
       {"+", 4, [](uint64_t a, uint64_t b) { return a + b; }},
       {"-", 4, [](uint64_t a, uint64_t b) { return a - b; }},
       {"*", 5, [](uint64_t a, uint64_t b) { return a * b; }},
       {"/", 5, [](uint64_t a, uint64_t b) { return b == 0 ? 0 : a / b; }},
       {"%", 5, [](uint64_t a, uint64_t b) { return b == 0 ? 0 : a % b; }}}};

  void skip_spaces() {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t')) rest_.remove_prefix(1);
  }
  bool take(std::string_view sign) {
    skip_spaces();
    if (!rest_.starts_with(sign)) return false;
    rest_.remove_prefix(sign.size());
    return true;
  }
  uint64_t fail() {
    good_ = false;
    return 0;
  }

  uint64_t choice() {
    if (++depth_ > kMaxDepth) return fail();
    const uint64_t which = operators(0);
    uint64_t result = which;
    if (good_ && take("?")) {
      const uint64_t yes = choice();
      const uint64_t no = good_ && take(":") ? choice() : fail();
      result = which != 0 ? yes : no;
    }
    --depth_;
    return result;
  }
  uint64_t operators(int level) {
    if (level == kLevels) return number();
    uint64_t left = operators(level + 1);
    for (bool again = good_; again;) {
      again = false;
      for (const Operator& one : kOperators) {
        if (one.level != level || !take(one.sign)) continue;
        left = one.apply(left, operators(level + 1));
        again = good_;
        break;
      }
    }
    return left;
  }
  uint64_t number() {
    if (take("n")) return count_;
    if (take("!")) {
      if (++depth_ > kMaxDepth) return fail();
      const uint64_t of = number();
      --depth_;
      return of == 0 ? 1 : 0;
    }
    if (take("(")) {
      const uint64_t inner = choice();
      return good_ && take(")") ? inner : fail();
    }
    skip_spaces();
    if (rest_.empty() || rest_[0] < '0' || rest_[0] > '9') return fail();
    uint64_t value = 0;
    for (; !rest_.empty() && rest_[0] >= '0' && rest_[0] <= '9'; rest_.remove_prefix(1))
      value = value * 10 + static_cast<uint64_t>(rest_[0] - '0');
    return value;
  }

  std::string_view rest_;
  uint64_t count_;
  int depth_ = 0;
  bool good_ = true;
};

/// The 32 bits at a place in the file; 0 beyond its end.
uint32_t number_at(std::string_view bytes, uint64_t at) {
  if (at > bytes.size() || bytes.size() - at < 4) return 0;
  uint32_t value = 0;
  for (uint64_t i = 4; i-- > 0;) value = (value << 8) | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// What a pair of length and place names, if a zero follows it in the file.
std::optional<std::string_view> text_at(std::string_view bytes, uint64_t pair) {
  const uint64_t length = number_at(bytes, pair), from = number_at(bytes, pair + 4);
  if (from > bytes.size() || length >= bytes.size() - from || bytes[from + length] != '\0') return {};
  return bytes.substr(from, length);
}

}  // namespace

std::optional<uint64_t> plural_form(std::string_view rule, uint64_t count) { return PluralRule(rule, count).value(); }

CompiledCatalogue::CompiledCatalogue(std::string bytes) : bytes_(std::move(bytes)) {
  const std::string_view all = bytes_;
  constexpr uint64_t kHead = 20, kPair = 8;
  if (all.size() < kHead || number_at(all, 0) != kMagic) return;
  const uint64_t keys = number_at(all, 12), texts = number_at(all, 16);
  const uint64_t count = std::min<uint64_t>(number_at(all, 8), all.size() / kPair);
  for (uint64_t i = 0; i < count; ++i) {
    const auto key = text_at(all, keys + i * kPair), text = text_at(all, texts + i * kPair);
    if (key && text) texts_.emplace(key->substr(0, key->find('\0')), *text);
  }
  constexpr std::string_view kPlural = "plural=";
  const std::string forms = field("Plural-Forms");
  if (const size_t at = forms.find(kPlural); at != std::string::npos) {
    plural_rule_ = forms.substr(at + kPlural.size());
    plural_rule_.resize(std::min(plural_rule_.size(), plural_rule_.find(';')));
  }
}

const char* CompiledCatalogue::text(std::string_view key) const {
  const auto found = texts_.find(key);
  return found == texts_.end() ? nullptr : found->second.data();
}

const char* CompiledCatalogue::text(std::string_view one, uint64_t count) const {
  const auto found = texts_.find(one);
  if (found == texts_.end()) return nullptr;
  std::string_view forms = found->second;
  for (uint64_t form = plural_form(plural_rule_, count).value_or(count != 1 ? 1 : 0); form > 0; --form) {
    const size_t end = forms.find('\0');
    if (end == std::string_view::npos) break;  // there are fewer forms than the rule says
    forms.remove_prefix(end + 1);
  }
  return forms.data();
}

std::string CompiledCatalogue::field(std::string_view name) const {
  const auto header = texts_.find("");
  if (header == texts_.end()) return {};
  for (std::string_view rest = header->second; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    if (line.starts_with(name) && line.substr(name.size()).starts_with(": "))
      return std::string(line.substr(name.size() + 2));
  }
  return {};
}

}  // namespace weftlight::platform
