// Light from files: the shipped lighting presets, and environment maps.

#include "base/files.h"
#include "base/resources.h"
#include "base/text.h"
#include "design/lights.h"
#include "files/environment.h"
#include "scene/light_rig.h"

namespace weftlight::scene {

using base::arg;
using base::fill;
using base::tr;

namespace {

LightRig load_environment(const std::string& path, std::string& error) {
  LightRig rig;
  ReadEnvironment read = read_environment(path);
  error = read.error;
  rig.remarks = std::move(read.remarks);
  if (read.picture) rig.environment = std::make_shared<const Environment>(std::move(*read.picture));
  return rig;
}

}  // namespace

LightRig load_light_rig(const std::string& name, std::string& error) {
  constexpr uint64_t kMaxBytes = uint64_t{1} << 20;
  if (is_environment(name)) return load_environment(name, error);
  const std::string path = presets_dir() + "/lights/" + name + ".json";
  const FileBytes file = read_file(path, kMaxBytes);
  if (!file.error.empty()) {
    error = fill(tr("{file}: {problem}; set WEFTLIGHT_PRESETS to the folder of presets"), arg("file", path),
                 arg("problem", file.error));
    return {};
  }
  LightRig rig = light_rig_from(file.bytes, error);
  if (!error.empty())
    error =
        fill(tr("{file}:{problem}; correct it, or restore the shipped file"), arg("file", path), arg("problem", error));
  return rig;
}

}  // namespace weftlight::scene
