#pragma once
// The yarn presets; the sources of their numbers are in yarn_presets.cpp.

#include <span>

#include "design/yarn.h"

namespace weftlight::design {

/// Eight yarns, cotton first. The names are English and are saved with a design; a list shows tr(name).
std::span<const Yarn> yarn_presets();
/// The one of that fibre. Its name is also the name of the fibre.
const Yarn& ready_yarn(Fibre fibre);

}  // namespace weftlight::design
