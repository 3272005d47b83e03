#pragma once
// The measured LOD table that ships with the program: presets/lod_table.csv, written by `weftlight chart`.

#include <string>

#include "light/lod_table.h"

namespace weftlight::render_data {

using light::LodTable;

struct ShippedLodTable {
  LodTable lod_table;
  std::string problem;  // with the file; the table is then default_lod_table()
};
ShippedLodTable shipped_lod_table();

}  // namespace weftlight::render_data
