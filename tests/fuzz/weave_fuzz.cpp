// Any text as parameters of any weave: generating never crashes and gives a draft of the requested size.

#include <cstdint>
#include <string_view>

#include "require.h"
#include "weaves/table.h"

using weftlight::design::is_consistent;
using weftlight::draft::is_consistent;
using weftlight::weaves::ClothSize, weftlight::weaves::GeneratedWeave, weftlight::weaves::WeaveKind,
    weftlight::weaves::WeaveParameter, weftlight::weaves::WeaveValues, weftlight::weaves::allowed_values,
    weftlight::weaves::new_draft, weftlight::weaves::weave_kinds;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size < 3) return 0;
  const auto kinds = weave_kinds();
  const WeaveKind& kind = kinds[data[0] % kinds.size()];
  const ClothSize asked{1 + data[1] % 40, 1 + data[2] % 40};
  std::string_view rest(reinterpret_cast<const char*>(data + 3), size - 3);
  WeaveValues values;
  for (const WeaveParameter& parameter : kind.parameters) {  // one line per parameter
    const size_t end = rest.find('\n');
    values.emplace_back(parameter.id, rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  }
  const GeneratedWeave made = new_draft(kind, values, asked);
  require(is_consistent(made.design), "a design is consistent");
  require(made.design.draft.ends() == asked.ends && made.design.draft.picks() == asked.picks,
          "it has the requested size");
  const WeaveValues allowed = allowed_values(kind, values);
  require(allowed == allowed_values(kind, allowed), "allowed values are not changed again");
  return 0;
}
