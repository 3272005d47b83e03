// Any bytes on the clipboard as colours or thicknesses of threads: parsing never crashes, and a draft stays consistent
// when they are applied.

#include <cstdint>
#include <string_view>

#include "design/thread_text.h"
#include "require.h"

using weftlight::design::Design, weftlight::design::ThreadProperties, weftlight::design::color_text,
    weftlight::design::is_consistent, weftlight::design::read_thread_properties, weftlight::design::thickness_text,
    weftlight::design::with_properties;
using weftlight::draft::System, weftlight::draft::blank_draft, weftlight::draft::is_consistent;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const weftlight::base::Result<ThreadProperties> read =
      read_thread_properties({reinterpret_cast<const char*>(data), size});
  require(read || !read.error().text.empty(), "a rejection has a reason");
  if (!read) return 0;
  require(read->size() > 0, "there is at least one value");
  constexpr int kThreads[] = {-1, 0, 3, 4, 8, 99};
  Design design;
  design.draft = blank_draft(9, 7, 4, 5);
  for (const System system : {System::kWarp, System::kWeft}) {
    design = with_properties(std::move(design), system, kThreads, *read);
    require(is_consistent(design), "a draft stays consistent");
    require(read_thread_properties(color_text(design.draft, system, kThreads)).has_value(), "colours come back");
    require(read_thread_properties(thickness_text(design.draft, system, kThreads)).has_value(),
            "thicknesses come back");
  }
  return 0;
}
