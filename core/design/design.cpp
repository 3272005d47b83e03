#include "design/design.h"

namespace weftlight::design {

using draft::is_consistent;

bool is_consistent(const Design& design) {
  return !design.yarns.empty() && is_consistent(design.draft, design.yarns.size());
}

}  // namespace weftlight::design
