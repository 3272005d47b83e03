#pragma once
// Parses and writes numbers and words of WIF values, independent of the locale.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/words.h"

namespace weftlight::wif {

using base::same_word;

bool is_blank(char c);
std::string_view trimmed(std::string_view text);
char upper(char c);
std::string uppercase(std::string_view text);

/// The integer at the start of a value; the rest is a comment. INT_MAX if it is larger.
std::optional<int> leading_int(std::string_view value);
/// The real number at the start of a value (".212" too). A decimal comma is accepted and reported.
std::optional<double> leading_real(std::string_view value, bool* decimal_comma = nullptr);
/// The comma-separated integers at the start of a value. What stands in the place of the next one, or nothing.
std::string_view leading_ints(std::string_view value, std::vector<int>& out);
/// Size in bytes of the list of numbers at the start of a value.
size_t leading_numbers_size(std::string_view value);
std::optional<bool> word_as_bool(std::string_view value);

/// The shortest decimal, without exponent, that reads back as the same float.
std::string shortest(float value);
/// The shortest decimal v such that float(v * unit_mm) == mm.
std::string in_units(float mm, double unit_mm);

}  // namespace weftlight::wif
