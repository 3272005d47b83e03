#pragma once
// Numbers and words of WIF values, the same in every locale.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wif/names.h"

namespace weftlight::wif {

bool is_blank(char c);
std::string_view trimmed(std::string_view text);
char upper(char c);
std::string uppercase(std::string_view text);
/// Ignoring the case of ASCII letters.
bool same_word(std::string_view a, std::string_view b);

/// The integer a value starts with; what follows it is a comment. Too large: INT_MAX.
std::optional<int> leading_int(std::string_view value);
/// The real a value starts with (".212" too). A decimal comma is taken and reported.
std::optional<double> leading_real(std::string_view value, bool* decimal_comma = nullptr);
/// The comma-separated integers a value starts with, into `out`.
void leading_ints(std::string_view value, std::vector<int>& out);
/// How many bytes of a value its leading list of numbers takes.
size_t leading_numbers_size(std::string_view value);
std::optional<bool> word_as_bool(std::string_view value);

/// The shortest decimal that reads back as the same float; never an exponent.
std::string shortest(float value);
/// The shortest decimal v for which float(v * unit_mm) is `mm`.
std::string in_units(float mm, double unit_mm);

}  // namespace weftlight::wif
