// Any text as an order of sections: it is read or rejected, within limits, and the result is consistent.

#include <cstdint>
#include <string_view>

#include "design/edits.h"
#include "require.h"
#include "weaves/sections.h"

using weftlight::design::Assembly, weftlight::design::Design, weftlight::design::is_consistent;
using weftlight::draft::System, weftlight::draft::blank_draft, weftlight::draft::is_consistent;
using weftlight::weaves::OrderItem, weftlight::weaves::assembled, weftlight::weaves::order_text,
    weftlight::weaves::read_order, weftlight::weaves::section_name, weftlight::weaves::section_of,
    weftlight::weaves::with_section;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto order = read_order(text)) {
    const std::string written = order_text(*order);
    const auto again = read_order(written);
    require(again && *again == *order, "an order survives writing and reading");
  }
  Design design;
  design.draft = blank_draft(6, 2, 3, 3);
  Assembly assembly;
  for (const char* name : {"A", "B"})
    assembly = with_section(assembly, section_of(design, {System::kWarp, 0, name[0] == 'A' ? 2 : 3}, name));
  assembly.order = std::string(text);
  const auto made = assembled(design, System::kWarp, assembly);
  require(!made || is_consistent(*made), "a design is consistent");
  const std::string name = section_name(text);
  require(name.empty() || read_order(name) == std::vector<OrderItem>{{name, {}, 1}}, "a valid name reads as a section");
  return 0;
}
