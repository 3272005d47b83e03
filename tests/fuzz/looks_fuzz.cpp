// Any bytes on the clipboard as colours or thicknesses of threads: reading them never crashes, and a draft that takes
// them stays whole.

#include <cstdint>
#include <string_view>

#include "draft/thread_text.h"
#include "require.h"

using namespace weftlight::draft;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const ThreadPropertiesRead read = read_look_text({reinterpret_cast<const char*>(data), size});
  require(read.looks.has_value() == read.problem.empty(), "a refusal says why");
  if (!read.looks) return 0;
  require(read.looks->size() > 0, "there is something to take over");
  constexpr int kThreads[] = {-1, 0, 3, 4, 8, 99};
  Design design;
  design.draft = blank_draft(9, 7, 4, 5);
  for (const System system : {System::kWarp, System::kWeft}) {
    design = with_properties(std::move(design), system, kThreads, *read.looks);
    require(is_consistent(design), "a draft stays consistent");
    require(read_look_text(color_text(design.draft, system, kThreads)).looks.has_value(), "colours come back");
    require(read_look_text(thickness_text(design.draft, system, kThreads)).looks.has_value(), "thicknesses come back");
  }
  return 0;
}
