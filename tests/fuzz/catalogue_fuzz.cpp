// Any bytes as a compiled catalogue and as a plural rule: no text reaches beyond the bytes, and every rule ends.

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "platform/without_gettext/compiled_catalogue.h"
#include "require.h"

using weftlight::platform::CompiledCatalogue;
using weftlight::platform::plural_form;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const CompiledCatalogue catalogue(bytes);
  for (const std::string_view key : {"", "text", "one"}) {
    if (const char* text = catalogue.text(key)) require(std::strlen(text) <= size, "a text ends in the file");
    for (const uint64_t count : {0, 1, 5})
      if (const char* form = catalogue.text(key, count)) require(std::strlen(form) <= size, "a form ends in the file");
  }
  require(catalogue.field("Language").size() <= size, "a field is part of the file");
  plural_form(bytes, 3);
  return 0;
}
