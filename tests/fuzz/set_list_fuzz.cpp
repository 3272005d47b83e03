// Any bytes as the texture_set.json of a folder: reading it never crashes, names no file outside the folder, and a set
// is whole only with what its list gives.

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "require.h"
#include "texture_set/set_folder.h"

namespace fs = std::filesystem;
using weftlight::texture_set::check_place, weftlight::texture_set::is_complete, weftlight::texture_set::listed_files,
    weftlight::texture_set::lists_archive;

namespace {

/// A folder of this process with one image, whose list is rewritten for every input.
const fs::path& scratch_folder() {
  static const fs::path folder = [] {
    fs::path made = fs::temp_directory_path() / ("weftlight-fuzz-" + std::to_string(::getpid()));
    fs::create_directories(made);
    std::ofstream(made / "a.png") << "image";
    std::atexit([] { fs::remove_all(scratch_folder()); });
    return made;
  }();
  return folder;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const fs::path& folder = scratch_folder();
  {
    std::ofstream out(folder / "texture_set.json", std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  const std::vector<std::string> files = listed_files(folder);
  for (const std::string& name : files)
    require(!name.empty() && (folder / name).parent_path() == folder && name != "..", "a listed file is in the folder");
  const bool known = bool(check_place(folder, {"x.wif", "x.wif", "gltf"}));
  require(!known || !files.empty(), "only a folder with a list is written to");
  lists_archive(folder);
  require(!is_complete(folder, "key") || !files.empty(), "a folder without a list is no set");
  require(!is_complete(folder, ""), "a set without a key is made again");
  return 0;
}
