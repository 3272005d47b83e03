// What a browser does itself, or does not let a page do.

#include <emscripten.h>

#include <filesystem>

#include "platform/desktop.h"
#include "platform/folders.h"
#include "platform/own_addresses.h"
#include "platform/shared_library.h"

EM_JS(void, page_show, (const char* address), { window.open(UTF8ToString(address)); });

namespace weftlight::platform {

tl::expected<void, MissingProgram> show_folder(const std::string& /*folder*/) {
  return tl::unexpected(MissingProgram{"xdg-open"});
}
// What lies in the folder of the program, the handbook above all, has an address beside the page's.
tl::expected<void, MissingProgram> show_page(const std::string& file) {
  page_show(std::filesystem::path(file).lexically_relative(program_folder()).c_str());
  return {};
}

std::vector<OwnAddress> own_addresses() { return {}; }
bool has_library(const char* /*name*/) { return false; }

}  // namespace weftlight::platform
