#pragma once
// The rows of the table of weaves, by family.

#include <vector>

#include "weaves/weave_kind.h"

namespace weftlight::weaves {

std::vector<WeaveKind> simple_kinds();
std::vector<WeaveKind> twill_kinds();
std::vector<WeaveKind> texture_kinds();
std::vector<WeaveKind> lace_kinds();
std::vector<WeaveKind> block_kinds();
std::vector<WeaveKind> tied_kinds();
std::vector<WeaveKind> parallel_kinds();
std::vector<WeaveKind> layer_kinds();
std::vector<WeaveKind> written_kinds();
std::vector<WeaveKind> color_kinds();

}  // namespace weftlight::weaves
