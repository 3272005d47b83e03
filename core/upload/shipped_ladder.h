#pragma once
// The measured ladder that ships with the program: presets/ladder.csv, written by `weftlight chart`.

#include "light/ladder.h"
#include "upload/names.h"

namespace weftlight::upload {

/// The shipped ladder; the bands of default_ladder() where the file is missing or broken.
Ladder shipped_ladder();

}  // namespace weftlight::upload
