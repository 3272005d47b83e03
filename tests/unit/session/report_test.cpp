#include "session/report.h"

#include <gtest/gtest.h>

#include "../semaphore.h"
#include "weaves/weaves.h"

namespace weftlight::session {

using design::Design;
using draft::BitMatrix, draft::Face, draft::drawdown;
using weaves::Lean, weaves::satin, weaves::twill;

namespace {

TEST(Report, ReportsFloatsRepeatAndHeddles) {
  const Design satin8 = satin(8, 3, Face::kFront, {16, 16});
  const BitMatrix cells = drawdown(satin8.draft);
  const Report r = report_on(satin8, cells, 5);
  EXPECT_EQ(r.longest.warp_front, 7);
  EXPECT_GT(r.floats.count, 0);
  EXPECT_EQ(r.floats.listed.front().length, 7);
  EXPECT_EQ(r.front.rows(), 16);
  EXPECT_EQ(r.repeat.ends, 8);
  EXPECT_EQ(r.layers, 1u);
  EXPECT_EQ(r.loom.heddles, std::vector<int>(8, 2));
  EXPECT_EQ(report_on(satin8, cells, 7).floats.count, 0);
}

TEST(Report, AnalysesTheNewestRequestedDesign) {
  const auto twilled = std::make_shared<const Design>(twill({2, 2}, Lean::kRight, {16, 16}));
  const auto satined = std::make_shared<const Design>(satin(8, 3, Face::kFront, {16, 16}));
  const BitMatrix short_floats = drawdown(twilled->draft), long_floats = drawdown(satined->draft);
  // The thread tells of each analysis, and is held up at the first while three more are asked for.
  BinarySemaphore told{0}, proceed{0};
  int analyses = 0;
  Reporter reporter([&] {
    ++analyses;
    told.release();
    if (analyses == 1) proceed.acquire();
  });
  EXPECT_EQ(reporter.on(twilled, short_floats, 1, 5), nullptr);
  told.acquire();
  for (const uint64_t revision : {2, 3, 4}) {
    const Report* r = reporter.on(twilled, short_floats, revision, 5);
    ASSERT_NE(r, nullptr);
    EXPECT_EQ(r->revision, 1u);
  }
  proceed.release();
  told.acquire();
  const Report* last = reporter.on(satined, long_floats, 5, 5);
  ASSERT_NE(last, nullptr);
  EXPECT_NE(last->revision, 3u) << "nobody asks for it any more";
  told.acquire();
  last = reporter.on(satined, long_floats, 5, 5);
  EXPECT_EQ(last->revision, 5u);
  EXPECT_GT(last->floats.count, 0) << "it is of another design";
  EXPECT_FALSE(reporter.busy());
  EXPECT_EQ(analyses, 3) << "each that was asked for meanwhile was analysed";
}

}  // namespace
}  // namespace weftlight::session
