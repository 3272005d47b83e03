#pragma once
// What the user reads: texts are English in the sources, looked up in the catalogue, and filled with named values.
//
//   fill(tr("{file} has {count} ends"), arg("file", name), arg("count", n))
//   fill(tr_n("{count} pick", "{count} picks", n), arg("count", n))
//   constexpr const char* kLabels[] = {mark("Threads"), mark("Colour")};      a table; tr(kLabels[i]) where it is shown
//
// A sentence is one text, never glued from pieces: other languages order their words differently.

#include <fmt/format.h>

#include <string>
#include <utility>

#include "base/mark.h"
#include "base/translated.h"

namespace weftlight::base {

using fmt::arg;

std::string filled(const char* pattern, fmt::format_args values);
/// The pattern with its {names} replaced by the values (fmt's syntax). A pattern that does not fit its values, as a
/// wrong translation, comes back as it is.
template <class... Values>
std::string fill(const char* pattern, Values&&... values) {
  return filled(pattern, fmt::make_format_args(values...));
}

}  // namespace weftlight::base
