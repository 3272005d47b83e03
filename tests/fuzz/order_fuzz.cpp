// Any text as an order of sections: it is read or rejected, within limits, and the result is consistent.

#include <cstdint>
#include <string_view>

#include "design/edits.h"
#include "require.h"
#include "weaves/sections.h"

using namespace weftlight::draft;
using namespace weftlight::design;
using namespace weftlight::weaves;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Order order = read_order(text);
  if (order.why.empty()) {
    const std::string written = order_text(order.items);
    const Order again = read_order(written);
    require(again.why.empty() && again.items == order.items, "an order survives writing and reading");
  }
  Design design;
  design.draft = blank_draft(6, 2, 3, 3);
  Assembly assembly;
  for (const char* name : {"A", "B"})
    assembly = with_section(assembly, section_of(design, {System::kWarp, 0, name[0] == 'A' ? 2 : 3}, name));
  assembly.order = std::string(text);
  const Assembled made = assembled(design, System::kWarp, assembly);
  require(is_consistent(made.design), "a design is consistent");
  require(made.why.empty() || made.design == design, "an impossible order leaves the draft");
  const std::string name = section_name(text);
  require(name.empty() || read_order(name).items == std::vector<OrderItem>{{name, {}, 1}},
          "a valid name reads as a section");
  return 0;
}
