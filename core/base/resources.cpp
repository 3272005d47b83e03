#include "base/resources.h"

#include <filesystem>

#include "base/library_file.h"
#include "platform/environment_variables.h"
#include "platform/folders.h"

namespace weftlight::base {
namespace fs = std::filesystem;

namespace {

struct Resource {
  const char *name, *variable;
  const char* known_by;  // a file or folder in it, which tells it from another program's folder; empty: not checked
  const char* share = "weftlight";  // where it is in share
};
constexpr Resource kPresets{"presets", "WEFTLIGHT_PRESETS", "drafts"};
constexpr Resource kShaders{"shaders", "WEFTLIGHT_SHADERS", "cloth.frag"};
constexpr Resource kLanguages{"languages", "WEFTLIGHT_LANGUAGES", ""};  // which languages there are differs
constexpr Resource kHandbook{"handbook", "WEFTLIGHT_HANDBOOK", "index.html", "doc/weftlight"};
constexpr int kFoldersUp = 5;  // from lib/python3/dist-packages/weftlight to share

std::string folder_of(const Resource& resource) {
  if (std::string set = platform::variable(resource.variable); !set.empty()) return set;
  std::error_code error;
  const auto is_it = [&](const fs::path& folder) { return fs::exists(folder / resource.known_by, error); };
  const fs::path program = platform::program_folder();
  if (const fs::path installed = program / "../share" / resource.share / resource.name; is_it(installed))
    return installed.lexically_normal().string();
  fs::path folder = program;
  for (int up = 0; up < kFoldersUp && folder.has_relative_path(); ++up, folder = folder.parent_path()) {
    for (const fs::path& place : {folder / resource.name, folder / "share" / resource.share / resource.name}) {
      if (!is_it(place)) continue;
      const fs::path real = fs::canonical(place, error);  // a build folder holds links to the source
      return (error ? place : real).string();
    }
  }
  return (program / "../share" / resource.share / resource.name).lexically_normal().string();
}

}  // namespace

std::string presets_dir() { return folder_of(kPresets); }
std::string shaders_dir() { return folder_of(kShaders); }
std::string languages_dir() { return folder_of(kLanguages); }

std::string library_file(const std::string& name) {
  const fs::path program = platform::program_folder(), below = fs::path("libexec/weftlight") / name;
  std::error_code error;
  fs::path folder = program;
  for (int up = 0; up < kFoldersUp && folder.has_relative_path(); ++up, folder = folder.parent_path())
    if (fs::exists(folder / below, error)) return (folder / below).string();
  return (program / ".." / below).lexically_normal().string();
}

std::string handbook_page() {
  const fs::path page = fs::path(folder_of(kHandbook)) / kHandbook.known_by;
  std::error_code error;
  return fs::exists(page, error) ? page.string() : "";
}

}  // namespace weftlight::base
