#pragma once
// Colours or thicknesses of threads as a line of text, to copy them alone through the clipboard.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "design/design.h"

namespace weftlight::design {

using draft::Draft, draft::Rgb, draft::System;

/// Either colours or thicknesses; the other is empty.
struct ThreadProperties {
  std::vector<Rgb> colors;
  std::vector<float> thickness_mm;  // or kFromYarn
  size_t size() const { return colors.size() + thickness_mm.size(); }
};

/// "weftlight colours: #10357A #E7B24B"; indices out of range are left out.
std::string color_text(const Draft& draft, System system, std::span<const int> threads);
/// "weftlight thickness: 0.5 - 0.8": in mm, - where it follows from the yarn.
std::string thickness_text(const Draft& draft, System system, std::span<const int> threads);

/// Accepts any bytes; reads at most kMaxThreads values.
base::Result<ThreadProperties> read_thread_properties(std::string_view text);

/// Applies the properties to the threads, repeated as needed. Colours that the palette lacks are added to it.
Design with_properties(Design design, System system, std::span<const int> threads, const ThreadProperties& properties);

}  // namespace weftlight::design
