#pragma once
// The yarns that a weaver finds ready: what each is spun from, and why its numbers are what they are.

#include <span>

#include "draft/yarn.h"

namespace weftlight::draft {

/// The eight yarns, cotton first.
std::span<const Yarn> yarn_presets();

}  // namespace weftlight::draft
