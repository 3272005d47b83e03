#include "session/report.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

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
  Reporter reporter;
  const auto twilled = std::make_shared<const Design>(twill({2, 2}, Lean::kRight, {16, 16}));
  const BitMatrix cells = drawdown(twilled->draft);
  EXPECT_EQ(reporter.on(twilled, cells, 1, 5), nullptr);
  const auto waited = [&](uint64_t revision) {
    for (int i = 0; i < 3000; ++i) {
      const Report* r = reporter.on(twilled, cells, revision, 5);
      if (r != nullptr && r->revision == revision) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  };
  EXPECT_TRUE(waited(1));
  EXPECT_TRUE(waited(2));
  EXPECT_EQ(reporter.last()->floats.count, 0);
}

}  // namespace
}  // namespace weftlight::session
