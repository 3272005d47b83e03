// `lobes`: what it does without tracing; the fit itself is tested in tests/unit/render_data/fibre_lobes_test.cpp.

#include "../yarns.h"
#include "base/whole_files.h"
#include "scratch_folder.h"
#include "weaves/weaves.h"

namespace weftlight::commands {

using design::Design;
using weaves::plain;
using wif::write_new_wif;

namespace {

class LobesCommand : public ScratchFolder {
 protected:
  std::string metal() const {
    const Design d = with_yarns(plain({8, 8}), yarn_preset("Metallic"), yarn_preset("Metallic"));
    return written("metal.wif", write_new_wif(d));
  }
};

TEST_F(LobesCommand, MetalStaysAsItIs) {
  const std::string file = metal();
  const Ran ran = run({"lobes", file, "-o", path("out.wif")});
  EXPECT_EQ(ran.code, kDone) << ran.said;
  EXPECT_NE(ran.out.find("metallic"), std::string::npos) << ran.out;
  EXPECT_EQ(run({"lobes", file, "-o", path("out.wif"), "--quiet"}).out, "");
  EXPECT_EQ(*base::read_file(path("out.wif")), *base::read_file(file));
}

TEST_F(LobesCommand, NothingIsTracedWithoutAPlaceForTheResult) {
  const Ran ran = run({"lobes", metal(), "-o", path("missing/out.wif")});
  EXPECT_EQ(ran.code, kNotWritten) << ran.said;
  EXPECT_EQ(run({"lobes", path("none.wif"), "-o", path("out.wif")}).code, kBadInput);
}

}  // namespace
}  // namespace weftlight::commands
