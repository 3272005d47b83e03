#pragma once
// The measured ladder that ships with the program: presets/ladder.csv, written by `weftlight chart`.

#include <string>

#include "light/ladder.h"
#include "upload/names.h"

namespace weftlight::upload {

struct ShippedLadder {
  Ladder ladder;
  std::string problem;  // of the file: the ladder is then default_ladder()
};
ShippedLadder shipped_ladder();

}  // namespace weftlight::upload
