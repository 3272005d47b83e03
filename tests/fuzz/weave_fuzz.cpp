// Any words as the numbers of any weave: a draft of the asked size is made, and making it never crashes.

#include <cstdint>
#include <string_view>

#include "draft/generators/table.h"
#include "require.h"

using namespace weftlight::draft;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size < 3) return 0;
  const auto kinds = weave_kinds();
  const WeaveKind& kind = kinds[data[0] % kinds.size()];
  const ClothSize asked{1 + data[1] % 40, 1 + data[2] % 40};
  std::string_view rest(reinterpret_cast<const char*>(data + 3), size - 3);
  WeaveValues values;
  for (const WeaveParameter& number : kind.parameters) {  // a line a number
    const size_t end = rest.find('\n');
    values.emplace_back(number.id, rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  }
  const GeneratedWeave made = new_draft(kind, values, asked);
  require(is_consistent(made.design), "a design is consistent");
  require(made.design.draft.ends() == asked.ends && made.design.draft.picks() == asked.picks, "it has the asked size");
  const WeaveValues allowed = allowed_values(kind, values);
  require(allowed == allowed_values(kind, allowed), "what is allowed stays as it is");
  return 0;
}
