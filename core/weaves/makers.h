#pragma once
// Generators of weaves that take more than one call of weaves.h. Their parameters are in the table (table.cpp).

#include "weaves/weave_values.h"
#include "weaves/weaves.h"

namespace weftlight::weaves {

GeneratedWeave make_broken(const WeaveValues& values, ClothSize size);
GeneratedWeave make_satin(const WeaveValues& values, ClothSize size);
GeneratedWeave make_network(const WeaveValues& values, ClothSize size);
GeneratedWeave make_echo(const WeaveValues& values, ClothSize size);
GeneratedWeave make_jin(const WeaveValues& values, ClothSize size);
GeneratedWeave make_overshot(const WeaveValues& values, ClothSize size);
GeneratedWeave make_crackle(const WeaveValues& values, ClothSize size);
GeneratedWeave make_substitution(const WeaveValues& values, ClothSize size);
GeneratedWeave make_sections(const WeaveValues& values, ClothSize size);
GeneratedWeave make_sett(const WeaveValues& values, ClothSize size);
GeneratedWeave make_glen_check(const WeaveValues& values, ClothSize size);
GeneratedWeave make_double(const WeaveValues& values, ClothSize size);
GeneratedWeave make_stitched(const WeaveValues& values, ClothSize size);
GeneratedWeave make_iso(const WeaveValues& values, ClothSize size);

}  // namespace weftlight::weaves
