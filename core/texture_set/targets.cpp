#include "texture_set/targets.h"

#include <algorithm>

namespace weftlight::texture_set {

const ExportTarget* target_named(std::string_view id, TargetTable table) {
  const auto at = std::ranges::find(table, id, [](const ExportTarget* target) { return std::string_view(target->id); });
  return at == table.end() ? nullptr : *at;
}

}  // namespace weftlight::texture_set
