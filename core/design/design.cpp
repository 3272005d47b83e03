#include "design/design.h"

#include <algorithm>

namespace weftlight::design {

using draft::is_consistent;

double spacing_of(const Design& design, System system, int thread) {
  const Threads& threads = design.draft.threads(system);
  const auto t = static_cast<size_t>(thread);
  if (threads.spacing_mm[t] >= 0) return static_cast<double>(threads.spacing_mm[t]);
  if (threads.thickness_mm[t] >= 0) return static_cast<double>(threads.thickness_mm[t]);
  return static_cast<double>(design.yarns[static_cast<size_t>(threads.yarn[t])].diameter_mm);
}

bool Version::operator==(const Version& other) const {
  return name == other.name && (design == other.design || *design == *other.design);
}

bool is_consistent(const Design& design) {
  const auto kept = [](const Version& v) { return v.design && v.design->versions.empty() && is_consistent(*v.design); };
  return !design.yarns.empty() && is_consistent(design.draft, design.yarns.size()) &&
         std::ranges::all_of(design.versions, kept);
}

}  // namespace weftlight::design
