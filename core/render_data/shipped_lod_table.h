#pragma once
// The measured LOD table that ships with the program: presets/lod_table.csv, written by `weftlight chart`.

#include "base/result.h"
#include "light/lod_table.h"

namespace weftlight::render_data {

using light::LodTable;

struct ShippedLodTable {
  LodTable lod_table;
  base::Result<void> read;  // or why the table is default_lod_table()
};
ShippedLodTable shipped_lod_table();

}  // namespace weftlight::render_data
