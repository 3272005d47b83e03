#pragma once
// The ready yarns; the sources of their numbers are in yarn_presets.cpp.

#include <span>

#include "design/yarn.h"

namespace weftlight::design {

/// The usual yarn of each fibre, in the order of Fibre: cotton (carded), mercerised cotton, linen, silk (spun), wool
/// (worsted), viscose, polyester filament, metallic. A fibre's facts, lustre and hairiness are relative to it.
std::span<const Yarn> yarn_presets();
/// The one of that fibre. A file names the fibre by it.
const Yarn& ready_yarn(Fibre fibre);

/// What a weaver chooses from: these and the other yarns of the trade (combed cotton, reeled silk, woollen, spun
/// polyester), each after the usual one of its fibre. The names are English and are saved with a design; a list shows
/// tr(name).
std::span<const Yarn> ready_yarns();

}  // namespace weftlight::design
