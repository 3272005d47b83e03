// A thread that runs out of memory reports it and goes on; no work is lost.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <thread>

#include "../comes_true.h"
#include "../scarce_memory.h"
#include "../scratch_fixture.h"
#include "draft/drawdown.h"
#include "paths.h"
#include "session/jobs/background_writer.h"
#include "session/jobs/draft_thumbnails.h"
#include "session/jobs/export_plan.h"
#include "session/jobs/export_preview.h"
#include "session/jobs/exporter.h"
#include "session/jobs/reference_tracer.h"
#include "session/recovery/journal.h"
#include "session/recovery/recovery.h"
#include "session/report.h"
#include "weaves/weaves.h"

namespace weftlight::session {

using design::Design;
using draft::BitMatrix, draft::Face, draft::drawdown;
using files::Image;
using texture_set::TextureSetOptions;
using weaves::Lean, weaves::twill;

namespace {

namespace fs = std::filesystem;

constexpr size_t kLittle = 8192;  // bytes

class NoMemory : public ScratchTest {
 protected:
  const std::shared_ptr<const Design> design_ = std::make_shared<const Design>(twill({2, 2}, Lean::kRight, {8, 8}));
};

bool tells_of_memory(const std::string& said) { return said.find("not enough memory") != std::string::npos; }

TEST_F(NoMemory, AFailedExportLeavesNothingAndTheNextSucceeds) {
  ExportPlan plan;
  plan.folder = path("out"), plan.targets = {&texture_set::targets::kGodot}, plan.size = 32;
  const std::vector<ExportJob> jobs = jobs_of(plan, *design_, "x.wif", "1");
  for (const int what : {1, 2}) {
    // Thrown once: a wake that comes after the export is over has nothing to throw into the next.
    std::atomic<int> throws{what};
    Exporter exporter([&] {
      const int thrown = throws.exchange(0);
      if (thrown == 1) throw std::bad_alloc();
      if (thrown == 2) throw std::runtime_error("the line broke");
    });
    exporter.start(jobs, design_);
    ASSERT_TRUE(comes_true([&] { return !exporter.busy(); }));
    const std::string said = exporter.take_message();
    EXPECT_TRUE(what == 1 ? tells_of_memory(said) : said.find("the line broke") != std::string::npos) << said;
    EXPECT_TRUE(!fs::exists(path("out")) || fs::is_empty(path("out")));
    exporter.start(jobs, design_);
    ASSERT_TRUE(comes_true([&] { return !exporter.busy(); }));
    EXPECT_EQ(exporter.state().written.size(), 1u);
    fs::remove_all(path("out"));
  }
}

TEST_F(NoMemory, TheJournalRetriesAndHasEveryStroke) {
  Recovery recovery(path("recovery"));
  Journal journal(recovery);
  const uint64_t a = journal.new_document(), b = journal.new_document();
  std::atomic<int> tries{0};
  journal.keep(a, {"", "a", {}}, [&]() -> std::string {
    if (++tries == 1) throw std::bad_alloc();
    if (tries == 2) throw 7;
    return "every stroke";
  });
  journal.keep(b, {"", "b", {}}, [] { return "of another"; });
  ASSERT_TRUE(comes_true([&] { return tells_of_memory(journal.problem()); })) << journal.problem();
  ASSERT_TRUE(comes_true([&] { return !journal.busy(); }));
  EXPECT_EQ(journal.problem(), "");
  EXPECT_EQ(tries, 3);
  EXPECT_EQ(read_left({recovery.journal_path(a), {}, 0})->text, "every stroke");
  EXPECT_EQ(read_left({recovery.journal_path(b), {}, 0})->text, "of another");
}

TEST_F(NoMemory, TheWriterRetries) {
  std::atomic<int> tries{0};
  BackgroundWriter writer;
  writer.keep(path("a"), [&]() -> base::Result<void> {
    if (++tries == 1) throw 7;
    return {};
  });
  ASSERT_TRUE(comes_true([&] { return !writer.busy(); }));
  EXPECT_EQ(tries, 2);
}

TEST_F(NoMemory, AFailedAnalysisIsReportedAndTheNextSucceeds) {
  const auto large = std::make_shared<const Design>(twill({2, 2}, Lean::kRight, {512, 512}));
  const BitMatrix cells = drawdown(large->draft);
  Reporter reporter;
  {
    const Scarce scarce(kLittle);
    EXPECT_EQ(reporter.on(large, cells, 1, 5), nullptr);
    ASSERT_TRUE(comes_true([&] { return reporter.poll(); }));
  }
  const std::string said = reporter.take_message();
  EXPECT_TRUE(tells_of_memory(said)) << said;
  EXPECT_EQ(reporter.on(large, cells, 1, 5), nullptr);
  EXPECT_FALSE(reporter.busy()) << "what failed is not tried in every frame";
  ASSERT_TRUE(comes_true([&] { return reporter.on(large, cells, 2, 5) != nullptr; }));
}

TEST_F(NoMemory, AFailedExportPreviewIsReportedAndTheNextSucceeds) {
  ExportPreviewer previewer(design_, [] {});
  TextureSetOptions options;
  options.name = std::string("x"), options.size = 32;
  std::optional<base::Result<ExportPreview>> made;
  const auto comes = [&] { return comes_true([&] { return (made = previewer.take()).has_value(); }); };
  {
    const Scarce scarce(kLittle);
    previewer.ask(Face::kFront, options, {});
    ASSERT_TRUE(comes());
  }
  EXPECT_TRUE(tells_of_memory(problem_of(*made))) << problem_of(*made);
  EXPECT_FALSE(previewer.busy());
  previewer.ask(Face::kBack, options, {});
  ASSERT_TRUE(comes());
  ASSERT_TRUE(*made) << problem_of(*made);
  EXPECT_FALSE((*made)->images.empty());
}

TEST_F(NoMemory, AFailedRayTracingIsReportedAndTheNextSucceeds) {
  TraceJob job{design_, design_->scene, 0, {}, {}};
  job.around = job.preview = Image{32, 32, 3, std::vector<float>(size_t{32} * 32 * 3)};
  ReferenceTracer tracer;
  std::optional<base::Result<PictureComparison>> made;
  const auto comes = [&] { return comes_true([&] { return (made = tracer.take()).has_value(); }); };
  {
    const Scarce scarce(kLittle);
    tracer.start(job);
    ASSERT_TRUE(comes());
  }
  EXPECT_TRUE(tells_of_memory(problem_of(*made))) << problem_of(*made);
  tracer.start(job);
  ASSERT_TRUE(comes());
  EXPECT_EQ(problem_of(*made), "");
}

TEST_F(NoMemory, AFailedThumbnailDoesNotStopTheOthers) {
  DraftThumbnails looks("", [] {});
  const std::string file = std::string(WEFTLIGHT_SOURCE_DIR) + "/presets/drafts/starter.wif";
  std::vector<std::pair<std::string, DraftThumbnail>> made;
  const auto comes = [&] { return comes_true([&] { return !(made = looks.take()).empty(); }); };
  {
    const Scarce scarce(kLittle);
    looks.ask(file);
    ASSERT_TRUE(comes());
  }
  EXPECT_EQ(made[0].second.state, DraftThumbnail::State::kUnreadable);
  looks.ask(file);
  ASSERT_TRUE(comes());
  EXPECT_EQ(made[0].second.state, DraftThumbnail::State::kThere);
}

}  // namespace
}  // namespace weftlight::session
