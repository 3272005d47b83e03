// Any bytes as another program's draft: reading never crashes, and what it gives is a design that a WIF holds.

#include <cstdint>
#include <string_view>

#include "require.h"
#include "wif/other_formats.h"

using namespace weftlight::draft;
using namespace weftlight::wif;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const WifRead& read : {read_dtx(bytes), read_wpo(bytes)}) {
    require(read.file.has_value() || !read.diagnostics.empty(), "a refusal says why");
    if (!read.file) continue;
    require(is_consistent(read.file->design), "a design is consistent");
    const WifRead again = read_wif(read.file->bytes);
    require(again.file && again.file->design == read.file->design, "a WIF holds it");
  }
  return 0;
}
