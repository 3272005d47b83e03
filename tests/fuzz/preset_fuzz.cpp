// Any bytes as what a preset holds beside its draft: yarns, look, scene, loom and weaves. Whatever they say, every
// number is in its range, and what was read is written and read again the same.

#include <cmath>
#include <cstdint>
#include <string>

#include "../unit/straight_draft.h"
#include "draft/edits.h"
#include "draft/fibre.h"
#include "draft/yarn_presets.h"
#include "require.h"
#include "wif/wif.h"

using namespace weftlight;
using namespace weftlight::draft;
using namespace weftlight::wif;

namespace {

/// Plain weave on two threads each way, as a ready yarn's file begins.
const std::string& beginning() {
  static const std::string text = write_new_wif(straight_draft(2));
  return text;
}

void check(const Design& design) {
  require(is_consistent(design), "a design is consistent");
  for (const Yarn& yarn : design.yarns) {
    require(clamped(yarn) == yarn, "a yarn is within its ranges");
    const int fibre = fibre_of(yarn);
    require(fibre >= 0 && fibre < static_cast<int>(yarn_presets().size()), "a yarn is most like one of the ready ones");
    require(std::isfinite(lustre(yarn)), "lustre is a number");
  }
  const Scene& s = design.scene;
  for (const float number : {s.view_azimuth, s.view_elevation, s.view_distance, s.pan_x, s.pan_y, s.light_azimuth,
                             s.light_elevation, s.light_strength, s.sky_strength, s.background.r, s.background.g,
                             s.background.b, design.look.tolerance, design.look.exposure_ev})
    require(std::isfinite(number), "scene and look are numbers");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes = beginning() + std::string(reinterpret_cast<const char*>(data), size);
  const WifRead read = read_wif(bytes);
  require(read.file.has_value() || !read.diagnostics.empty(), "a refusal says why");
  if (!read.file) return 0;
  const Design& design = read.file->design;
  check(design);
  require(write_wif(*read.file, design) == bytes, "an unedited file keeps its bytes");
  if (design.draft.ends() > 64 || design.draft.picks() > 64) return 0;
  const WifRead again = read_wif(write_new_wif(design));
  require(again.file.has_value(), "what is written can be read");
  check(again.file->design);
  require(again.file->design == design, "and says the same");
  return 0;
}
