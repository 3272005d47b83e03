#pragma once
// Colours by the words in which people look for them.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/mark.h"
#include "draft/draft.h"

namespace weftlight::collection {

using draft::Draft, draft::Rgb;

struct ColourName {
  const char *id, *label;  // label: to be shown through base::tr()
};
inline constexpr std::array<ColourName, 11> kColourNames{{
    {"white", base::mark("White")},
    {"grey", base::mark("Grey")},
    {"black", base::mark("Black")},
    {"red", base::mark("Red")},
    {"orange", base::mark("Orange")},
    {"brown", base::mark("Brown")},
    {"yellow", base::mark("Yellow")},
    {"green", base::mark("Green")},
    {"blue", base::mark("Blue")},
    {"purple", base::mark("Purple")},
    {"pink", base::mark("Pink")},
}};

/// The index in kColourNames of a colour in sRGB, 0..1.
size_t colour_name_of(Rgb color);
std::optional<size_t> colour_of_id(std::string_view id);

/// A bit for each of kColourNames that a twentieth of the threads has.
uint32_t colours_of(const Draft& draft);

}  // namespace weftlight::collection
