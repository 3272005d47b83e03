#pragma once
// Numbers as the user's language writes them. Only what is shown goes through here (and through fill, base/text.h):
// files and JSON have a point in every language, because the C locale of numbers is never changed.

#include <fmt/format.h>

#include <string>

namespace weftlight::base {

/// The sign between ones and tenths in the user's language, from the catalogue.
char decimal_point();
/// Text with numbers that were written with a point, as "1.5 mm": each point between two digits becomes the decimal
/// point.
std::string with_decimal_point(std::string text);
/// The pattern with a point that does for `point`; the fields of floating-point formats ("{width:.1f}") write it.
std::string filled_with_point(const char* pattern, fmt::format_args values, char point);

}  // namespace weftlight::base
