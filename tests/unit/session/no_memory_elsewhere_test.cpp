// Wherever memory ends on a thread beside the window's, its job alone fails and says so; the next succeeds, and no
// stroke is lost. The nth call of operator new on any of them fails, oneTBB's included.

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "../comes_true.h"
#include "../scarce_memory.h"
#include "../scratch_fixture.h"
#include "../variable.h"
#include "base/caught.h"
#include "base/loops.h"
#include "base/tasks.h"
#include "cloth/cloth.h"
#include "cloth/maps.h"
#include "design/edits.h"
#include "draft/drawdown.h"
#include "files/files.h"
#include "paths.h"
#include "session/jobs/draft_thumbnails.h"
#include "session/jobs/draper.h"
#include "session/jobs/export_plan.h"
#include "session/jobs/export_preview.h"
#include "session/jobs/exporter.h"
#include "session/jobs/reference_tracer.h"
#include "session/loom/loom_link.h"
#include "session/recovery/journal.h"
#include "session/recovery/recovery.h"
#include "session/report.h"
#include "session/saver.h"
#include "session/session.h"
#include "weaves/weaves.h"
#include "wif/wif.h"

namespace weftlight::session {
namespace {

constexpr int kMax = 500;  // calls of operator new

/// Numbers from 1 to kMax, denser at the start, where a job is set up.
std::vector<int> numbers() {
  std::vector<int> all;
  for (int n = 1; n <= kMax; n += 1 + n / 8) all.push_back(n);
  return all;
}

class NoMemoryElsewhere : public ScratchTest {
 protected:
  /// Other people's libraries do without memory while they are loaded, or not at all.
  static void SetUpTestSuite() { files::encode_png({1, 1, 1, {0}}); }

  const std::shared_ptr<const design::Design> design_ =
      std::make_shared<const design::Design>(weaves::twill({2, 2}, weaves::Lean::kRight, {8, 8}));
};

TEST_F(NoMemoryElsewhere, ATaskIsAnsweredInAnyCase) {
  for (const int n : numbers()) {
    int answers = 0;
    base::TaskRunner runner;
    {
      const NthFailsElsewhere fails(n);
      base::Task task = base::task_with_result([](const base::RunningTask&) { return std::string(100, 'x'); },
                                               [&](const base::Result<std::string>&) { ++answers; });
      task.finishes = true;
      runner.start(std::move(task));
      ASSERT_TRUE(comes_true([&] { return runner.take(); })) << n << ": nobody is told";
    }
    EXPECT_EQ(answers, 1) << n;
  }
}

TEST_F(NoMemoryElsewhere, TwoTasksThatCannotSpeakAreAnsweredWhenMemoryIsBack) {
  // The work fails and so does every answer, for a while.
  std::optional<Scarce> scarce(std::in_place, 1);
  base::TaskRunner runner;
  int answers = 0;
  for (const char* kind : {"a", "b"}) {
    base::Task task = base::task_with_result([](const base::RunningTask&) { return std::string(100, 'x'); },
                                             [&](const base::Result<std::string>&) { ++answers; });
    task.kind = kind;
    runner.start(std::move(task));
  }
  constexpr int kBothAndTheirAnswers = 4;
  ASSERT_TRUE(comes_true([] { return Scarce::refusals() >= kBothAndTheirAnswers; }));
  EXPECT_EQ(answers, 0);
  scarce.reset();
  EXPECT_TRUE(comes_true([&] { return runner.take(), answers == 2; }));
}

TEST_F(NoMemoryElsewhere, ALoopFailsWhereItWasCalled) {
  const draft::BitMatrix cells = drawdown(design_->draft);
  const auto baked = [&] {
    return cloth::bake(cloth::lay_out(*design_, cells, draft::Face::kFront, cloth::Period::kRepeat), {64, 64, 8});
  };
  const cloth::Maps whole = baked();
  for (const int n : numbers()) {
    std::optional<cloth::Maps> maps;
    base::Result<void> done;
    {
      const NthFailsElsewhere fails(n);
      done = base::caught([&] { maps = baked(); });
    }
    EXPECT_EQ(maps.has_value(), done.has_value());
    if (maps) {
      EXPECT_EQ(maps->height_mm.at_, whole.height_mm.at_) << n;
    }
  }
}

TEST_F(NoMemoryElsewhere, TheJournalHasEveryStroke) {
  struct Kept {
    explicit Kept(const std::string& folder) : recovery(folder), journal(recovery) {}
    bool on_disk(uint64_t document, const std::string& text) const {
      const auto entry = read_left({recovery.journal_path(document), {}, 0});
      return entry && entry->text == text;
    }
    Recovery recovery;
    Journal journal;
    std::map<uint64_t, std::string> newest;
  };
  // A lost entry is tried again after a second, so many journals fail side by side.
  std::vector<std::unique_ptr<Kept>> all;
  for (const int n : numbers()) {
    Kept& kept = *all.emplace_back(std::make_unique<Kept>(path("recovery" + std::to_string(n))));
    const NthFailsElsewhere fails(n);
    for (const size_t length : {1000, 1010, 2000}) {
      const uint64_t document = kept.journal.new_document();
      const std::string text = std::string(length, 'a') + std::to_string(document);
      kept.journal.keep(document, {path("a.wif"), "a draft with a long name", {}},
                        [text] { return std::string(text); });
      kept.newest[document] = text;
    }
    const auto first = *kept.newest.begin();
    ASSERT_TRUE(comes_true([&] { return NthFailsElsewhere::failed() || kept.on_disk(first.first, first.second); }))
        << n;
  }
  for (const auto& kept : all) {
    ASSERT_TRUE(comes_true([&] { return !kept->journal.busy(); }));
    for (const auto& [document, text] : kept->newest) EXPECT_TRUE(kept->on_disk(document, text)) << document;
    // What may not have reached the disk is written anew with the next stroke.
    auto& [document, text] = *kept->newest.begin();
    text += "b";
    kept->journal.keep(document, {path("a.wif"), "a draft", {}}, [newest = text] { return std::string(newest); });
  }
  for (const auto& kept : all) {
    ASSERT_TRUE(comes_true([&] { return !kept->journal.busy() && kept->journal.problem().empty(); }))
        << kept->journal.problem();
    for (const auto& [document, text] : kept->newest) EXPECT_TRUE(kept->on_disk(document, text)) << document;
  }
}

TEST_F(NoMemoryElsewhere, AnAnalysisSaysSo) {
  const draft::BitMatrix cells = drawdown(design_->draft);
  uint64_t revision = 0;
  Reporter reporter;
  for (const int n : numbers()) {
    {
      const NthFailsElsewhere fails(n);
      reporter.on(design_, cells, ++revision, 5);
      ASSERT_TRUE(comes_true([&] { return reporter.poll(); })) << n;
    }
    const bool there = reporter.on(design_, cells, revision, 5) != nullptr;
    EXPECT_NE(there, !reporter.take_message().empty()) << n;
  }
  reporter.on(design_, cells, ++revision, 5);
  EXPECT_TRUE(comes_true([&] { return reporter.on(design_, cells, revision, 5) != nullptr; }));
}

TEST_F(NoMemoryElsewhere, AnExportPreviewSaysSo) {
  ExportPreviewer previewer(design_, [] {});
  texture_set::TextureSetOptions options;
  options.name = "x", options.size = 16;
  std::optional<base::Result<ExportPreview>> made;
  const auto comes = [&] { return comes_true([&] { return (made = previewer.take()).has_value(); }); };
  draft::Face face = draft::Face::kFront;
  for (const int n : numbers()) {
    face = face == draft::Face::kFront ? draft::Face::kBack : draft::Face::kFront;  // another preview than before
    const NthFailsElsewhere fails(n);
    previewer.ask(face, options, {});
    ASSERT_TRUE(comes()) << n;
    if (*made) {
      EXPECT_FALSE((*made)->images.empty()) << n;
    }
  }
}

TEST_F(NoMemoryElsewhere, AnExportIsAnswered) {
  ExportPlan plan;
  plan.targets = {&texture_set::targets::kGodot}, plan.size = 16;
  for (const int n : numbers()) {
    plan.folder = path("out" + std::to_string(n));
    Exporter exporter([] {});
    {
      const NthFailsElsewhere fails(n);
      exporter.start(jobs_of(plan, *design_, "x.wif", "1"), design_);
      ASSERT_TRUE(comes_true([&] { return !exporter.busy(); })) << n;
    }
    EXPECT_NE(exporter.take_message(), "") << n;
    if (exporter.state().written.size() == 1) {
      EXPECT_FALSE(std::filesystem::is_empty(plan.folder)) << n;
    }
    if (!std::filesystem::exists(plan.folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(plan.folder))
      EXPECT_EQ(entry.path().filename().string().find(".part-"), std::string::npos) << n << ": " << entry.path();
  }
}

TEST_F(NoMemoryElsewhere, AThumbnailIsThereOrUnreadable) {
  const std::string file = std::string(WEFTLIGHT_SOURCE_DIR) + "/presets/drafts/starter.wif";
  for (const int n : numbers()) {
    DraftThumbnails looks(path("cache"), [] {});
    std::vector<std::pair<std::string, DraftThumbnail>> made;
    {
      const NthFailsElsewhere fails(n);
      looks.ask(file);
      ASSERT_TRUE(comes_true([&] { return !(made = looks.take()).empty(); })) << n;
    }
    EXPECT_NE(made[0].second.state, DraftThumbnail::State::kMissing) << n;
  }
}

TEST_F(NoMemoryElsewhere, ASaveFailsOrWritesTheWholeFile) {
  const std::string file = written("x.wif", wif::write_new_wif(*design_));
  base::TaskRunner writing;
  Session session(path("recovery"), Document(*design_));
  Saver saver(session, writing);
  const uint64_t id = session.add(std::move(*open_document(file).document), Origin::kOwn).id;
  uint64_t stroke = 0;
  for (const int n : numbers()) {
    const std::string old = base::read_file(file).value_or("");
    const bool up = ++stroke % 2 == 1;
    session.commit({"Paint", [=](design::Design d) { return design::with_threading(std::move(d), 0, 1, up); }}, stroke);
    session.settle();  // the journal has a test of its own
    std::optional<bool> saved;
    {
      const NthFailsElsewhere fails(n);
      saver.save(id, file, true, [&](const SaveResult& result) { saved = is_written(result); });
      ASSERT_TRUE(comes_true([&] { return writing.take(), saved.has_value(); })) << n << ": nobody is told";
    }
    const std::string now = base::read_file(file).value_or("");
    if (!*saved) {
      EXPECT_EQ(now, old) << n;
    }
    EXPECT_TRUE(wif::read_wif(now).file) << n << ": half a file";
    EXPECT_EQ(session.unsaved().empty(), *saved) << n;
    EXPECT_EQ(session.active().document.now().draft.threading.get(0, 1), up) << n << ": a stroke is lost";
  }
  saver.save(id, file, true, {});
  ASSERT_TRUE(comes_true([&] { return writing.take(), !saver.saving(0); }));
  EXPECT_EQ(wif::read_wif(base::read_file(file).value_or("")).file->design, session.active().document.now());
}

TEST_F(NoMemoryElsewhere, ADrapeSaysSo) {
  const Variable cache("XDG_CACHE_HOME", path("cache"));
  design::Design cloth = *design_;
  cloth.scene.mesh = "sphere", cloth.scene.simulated_drape = true;
  const auto draped = std::make_shared<const design::Design>(std::move(cloth));
  Draper draper([] {});
  int failures = 0;
  for (const int n : numbers()) {
    const NthFailsElsewhere fails(n);
    draper.again(draped);
    // It begins to fall and is stopped, or it fails.
    ASSERT_TRUE(comes_true([&] { return !draper.busy() || draper.state().share > 0; })) << n;
    if (draper.state().stage == DrapeStage::kFailed) {
      EXPECT_NE(draper.state().problem, "") << n;
      EXPECT_NE(draper.take_update().message, "") << n;
      ++failures;
    }
    draper.stop();
  }
  EXPECT_GT(failures, 5);
  draper.again(draped);
  EXPECT_TRUE(comes_true([&] { return draper.state().share > 0; })) << "it does not fall any more";
  draper.stop();
}

TEST_F(NoMemoryElsewhere, ARayTracedPictureSaysSo) {
  TraceJob job{design_, design_->scene, 0, {}, {}};
  job.around = job.preview = files::Image{8, 8, 3, std::vector<float>(size_t{8} * 8 * 3)};
  int failures = 0;
  for (const int n : numbers()) {
    std::optional<base::Result<PictureComparison>> made;
    ReferenceTracer tracer;
    const NthFailsElsewhere fails(n);
    tracer.start(job);
    ASSERT_TRUE(comes_true([&] { return (made = tracer.take()).has_value(); })) << n;
    failures += *made ? 0 : 1;
    tracer.stop();
  }
  EXPECT_GT(failures, 5);
}

TEST_F(NoMemoryElsewhere, ALoomIsCalledAgain) {
  for (int n = 1; n <= 24; n += 1) {
    LoomLink link([] {});
    const NthFailsElsewhere fails(n);
    link.connect("tcp:127.0.0.1:1 a long address");
    ASSERT_TRUE(comes_true([&] { return !link.why().empty(); })) << n;
  }
}

}  // namespace
}  // namespace weftlight::session
