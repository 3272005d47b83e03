// Any bytes as a draft of another program: parsing never crashes, and the design survives writing and reading as WIF.

#include <cstdint>
#include <string_view>

#include "require.h"
#include "wif/other_formats.h"

using weftlight::design::is_consistent;
using weftlight::draft::is_consistent;
using weftlight::wif::WifRead, weftlight::wif::read_dtx, weftlight::wif::read_wif, weftlight::wif::read_wpo;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const WifRead& read : {read_dtx(bytes), read_wpo(bytes)}) {
    require(read.file.has_value() || !read.diagnostics.empty(), "a rejection has a reason");
    if (!read.file) continue;
    require(is_consistent(read.file->design), "a design is consistent");
    const WifRead again = read_wif(read.file->bytes);
    require(again.file && again.file->design == read.file->design, "the design survives WIF");
  }
  return 0;
}
