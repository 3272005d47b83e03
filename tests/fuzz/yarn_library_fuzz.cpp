// Any bytes as a list of yarns: parsing never crashes, and what was read survives writing and reading.

#include <cstdint>
#include <string>
#include <string_view>

#include "design/yarn_fields.h"
#include "design/yarn_library.h"
#include "require.h"

using weftlight::design::Design, weftlight::design::LibraryYarn, weftlight::design::YarnLibrary,
    weftlight::design::clamped, weftlight::design::is_consistent, weftlight::design::kMaxYarnColors,
    weftlight::design::read_yarn_library, weftlight::design::with_yarn_from, weftlight::design::yarn_library_text;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const weftlight::base::Result<YarnLibrary> read = read_yarn_library({reinterpret_cast<const char*>(data), size});
  require(read || !read.error().text.empty(), "a rejection has a reason");
  if (!read) return 0;
  for (const LibraryYarn& y : read->yarns) {
    require(clamped(y.yarn) == y.yarn, "numbers are in range");
    require(y.price >= 0 && y.cone_g >= 0 && y.cone_m >= 0, "prices are prices");
    require(y.colors.size() <= kMaxYarnColors, "colours are counted");
  }
  const std::string text = yarn_library_text(*read);
  const weftlight::base::Result<YarnLibrary> again = read_yarn_library(text);
  require(again && again->yarns == read->yarns, "yarns survive writing and reading");
  require(read->head.empty() || again->head == read->head, "what stands before them as well");
  require(yarn_library_text(*again) == text, "the text as well");
  Design design;
  design.draft = weftlight::draft::blank_draft(4, 4, 2, 2);
  for (const LibraryYarn& y : read->yarns) design = with_yarn_from(std::move(design), y, 0).design;
  require(is_consistent(design), "a draft stays consistent");
  return 0;
}
