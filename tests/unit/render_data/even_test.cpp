// Footprint from which on a cloth is uniform: not while its figure shows, even in sheen alone.

#include <gtest/gtest.h>

#include "design/edits.h"
#include "render_data/stages.h"

namespace weftlight::render_data {

using design::Design;
using draft::blank_draft;

namespace {

constexpr int kBlock = 40;

/// Satin on five shafts, if `figured` warp-faced and weft-faced in a chequerboard of blocks, else warp-faced
/// everywhere.
Design white_satin(bool figured) {
  Design d;
  d.draft = blank_draft(2 * kBlock, 2 * kBlock, 10, 10);
  d.scene.mesh.clear();
  for (int i = 0; i < 2 * kBlock; ++i) {
    const int thread = i / kBlock * 5 + i % 5;
    d.draft.threading.set(i, thread, true), d.draft.treadling.set(i, thread, true);
  }
  for (int t = 0; t < 10; ++t) {
    for (int s = 0; s < 10; ++s) {
      const bool bound = s * 2 % 5 == t % 5, warp_faced = !figured || s / 5 == t / 5;
      d.draft.tieup.set(t, s, bound != warp_faced);
    }
  }
  return d;
}

float even_yarns(const Design& d) {
  Stages stages;
  stages.update(std::make_shared<const Design>(d));
  return stages.packed().lobes.data.even_yarns;
}

TEST(Even, ADamaskOfOneColourShowsItsBlocks) {
  EXPECT_GE(even_yarns(white_satin(true)), kBlock / 2.0f);
  EXPECT_LE(even_yarns(white_satin(false)), 10.0f);
}

}  // namespace
}  // namespace weftlight::render_data
