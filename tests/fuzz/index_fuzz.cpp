// Any bytes as the index of a folder: reading never crashes, and what is read survives writing and reading.

#include <cstdint>
#include <string_view>

#include "collection/index_text.h"
#include "require.h"

using weftlight::collection::entries_from, weftlight::collection::index_text;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto entries = entries_from({reinterpret_cast<const char*>(data), size});
  if (!entries) return 0;
  const auto again = entries_from(index_text(*entries));
  require(again && *again == *entries, "an index survives writing and reading");
  return 0;
}
