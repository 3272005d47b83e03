#pragma once
// Colours or thicknesses of threads as a line of text, for the clipboard: copied alone, without the cells, from thread
// to thread and from draft to draft.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "draft/design.h"

namespace weftlight::draft {

/// One of the two has values.
struct ThreadProperties {
  std::vector<Rgb> colors;
  std::vector<float> thickness_mm;  // or kFromYarn
  size_t size() const { return colors.size() + thickness_mm.size(); }
};

/// "weftlight colours: #10357A #E7B24B"; threads that are not there are left out.
std::string color_text(const Draft& draft, System system, std::span<const int> threads);
/// "weftlight thickness: 0.5 - 0.8": millimetres, - where the yarn's holds.
std::string thickness_text(const Draft& draft, System system, std::span<const int> threads);

struct ThreadPropertiesRead {
  std::optional<ThreadProperties> looks;
  std::string problem;  // why there are none, and what to do
};
/// Any bytes; at most kMaxThreads values are taken.
ThreadPropertiesRead read_look_text(std::string_view text);

/// Over and over along the threads. Colours are those of the palette, or new ones of it.
Design with_properties(Design design, System system, std::span<const int> threads, const ThreadProperties& looks);

}  // namespace weftlight::draft
