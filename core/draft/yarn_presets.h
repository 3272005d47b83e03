#pragma once
// The yarns that a weaver finds ready: what each is spun from, and why its numbers are what they are.

#include <span>
#include <string_view>

#include "draft/yarn.h"

namespace weftlight::draft {

/// The eight yarns, cotton first.
std::span<const Yarn> yarn_presets();

/// The preset of that name, or the first when there is none.
const Yarn& yarn_preset(std::string_view name);

}  // namespace weftlight::draft
