#pragma once
// The measured ladder that ships with the program: presets/lod_table.csv, written by `weftlight chart`.

#include <string>

#include "light/lod_table.h"
#include "render_data/names.h"

namespace weftlight::render_data {

struct ShippedLodTable {
  LodTable lod_table;
  std::string problem;  // of the file: the ladder is then default_lod_table()
};
ShippedLodTable shipped_lod_table();

}  // namespace weftlight::render_data
