// Light from files: the shipped lighting presets, and environment maps.

#include "base/resources.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "design/lights.h"
#include "files/environment.h"
#include "scene/light_rig.h"

namespace weftlight::scene {

using base::ErrorKind, base::Result, base::arg, base::failed, base::failure, base::fill, base::presets_dir,
    base::read_file, base::tr;
using design::is_environment;
using files::EnvironmentPicture, files::read_environment;

namespace {

Result<LightRig> load_environment(const std::string& path) {
  Result<EnvironmentPicture> read = read_environment(path);
  if (!read) return failed(read);
  LightRig rig;
  rig.remarks = std::move(read->remarks);
  rig.environment = std::make_shared<const Environment>(std::move(read->picture));
  return rig;
}

}  // namespace

Result<LightRig> load_light_rig(const std::string& name) {
  constexpr uint64_t kMaxBytes = uint64_t{1} << 20;
  if (is_environment(name)) return load_environment(name);
  const std::string path = presets_dir() + "/lights/" + name + ".json";
  const Result<std::string> file = read_file(path, kMaxBytes);
  if (!file)
    return failure(
        ErrorKind::kInput,
        fill(tr("{problem}; set WEFTLIGHT_PRESETS to the folder of presets"), arg("problem", file.error().text)), path);
  Result<LightRig> rig = light_rig_from(*file);
  if (rig) return rig;
  return failure(ErrorKind::kInput,
                 fill(tr("{problem}; correct it, or restore the shipped file"), arg("problem", rig.error().text)), path,
                 rig.error().line);
}

}  // namespace weftlight::scene
