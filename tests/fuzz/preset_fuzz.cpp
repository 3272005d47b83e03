// Any bytes as the private sections of a preset: yarns, look, scene, loom and weaves. Every number is in its range, and
// the design survives writing and reading.

#include <cmath>
#include <cstdint>
#include <string>

#include "../unit/straight_draft.h"
#include "design/edits.h"
#include "design/fibre.h"
#include "require.h"
#include "wif/wif.h"

using weftlight::straight_draft;
using weftlight::design::Design, weftlight::design::Scene, weftlight::design::Yarn, weftlight::design::clamped,
    weftlight::design::is_consistent, weftlight::design::kCrossSections, weftlight::design::kFibres,
    weftlight::design::lustre;
using weftlight::draft::is_consistent;
using weftlight::wif::WifRead, weftlight::wif::read_wif, weftlight::wif::write_new_wif, weftlight::wif::write_wif;

namespace {

/// Plain weave of two ends and picks, the start of a yarn preset.
const std::string& beginning() {
  static const std::string text = write_new_wif(straight_draft(2));
  return text;
}

void check(const Design& design) {
  require(is_consistent(design), "a design is consistent");
  for (const Yarn& yarn : design.yarns) {
    require(clamped(yarn) == yarn, "a yarn is within its ranges");
    require(static_cast<int>(yarn.fibre) < kFibres, "a yarn has a fibre");
    require(static_cast<int>(yarn.section) < kCrossSections, "and its fibre a section");
    require(std::isfinite(lustre(yarn)), "lustre is finite");
  }
  const Scene& s = design.scene;
  for (const float number : {s.view_azimuth, s.view_elevation, s.view_distance, s.pan_x, s.pan_y, s.light_azimuth,
                             s.light_elevation, s.light_strength, s.sky_strength, s.background.r, s.background.g,
                             s.background.b, design.look.tolerance, design.look.exposure_ev})
    require(std::isfinite(number), "scene and look are finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes = beginning() + std::string(reinterpret_cast<const char*>(data), size);
  const WifRead read = read_wif(bytes);
  require(read.file.has_value() || !read.diagnostics.empty(), "a rejection has a reason");
  if (!read.file) return 0;
  const Design& design = read.file->design;
  check(design);
  require(write_wif(*read.file, design) == bytes, "an unedited file keeps its bytes");
  if (design.draft.ends() > 64 || design.draft.picks() > 64) return 0;
  const WifRead again = read_wif(write_new_wif(design));
  require(again.file.has_value(), "the written file can be read");
  check(again.file->design);
  require(again.file->design == design, "and gives the same design");
  return 0;
}
