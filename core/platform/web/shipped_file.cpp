#include "platform/shipped_file.h"

#include <emscripten.h>
#include <emscripten/threading.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>

#include "platform/file.h"
#include "platform/folders.h"
#include "platform/unique_name.h"

/// The bytes at an address beside the page, or null. To be freed. A worker may wait for them.
EM_JS(char*, page_fetch, (const char* address, int* size), {
  const asked = new XMLHttpRequest();
  asked.open('GET', UTF8ToString(address), false);
  asked.responseType = 'arraybuffer';
  try {
    asked.send();
  } catch (error) {
    return 0;
  }
  if (asked.status != 200) return 0;
  const bytes = new Uint8Array(asked.response);
  const at = _malloc(bytes.length);
  HEAPU8.set(bytes, at);
  HEAP32[size >> 2] = bytes.length;
  return at;
});

namespace weftlight::platform {

namespace fs = std::filesystem;

bool is_shipped(const std::string& path) {
  if (file_facts(path).kind == FileKind::kRegular) return true;
  const fs::path address = fs::path(path).lexically_relative(program_folder());
  if (emscripten_is_main_browser_thread() || address.empty() || *address.begin() == "..") return false;
  int size = 0;
  const std::unique_ptr<char, void (*)(void*)> bytes(page_fetch(address.c_str(), &size), std::free);
  if (!bytes) return false;
  // Beside it first: another thread may look for it.
  const std::string beside = temporary_beside(path);
  std::error_code error;
  fs::create_directories(fs::path(path).parent_path(), error);
  std::ofstream out(beside, std::ios::binary);
  out.write(bytes.get(), size);
  out.close();
  if (out) fs::rename(beside, path, error);
  return out && !error;
}

}  // namespace weftlight::platform
