// Wherever memory ends, what was begun gives an error or std::bad_alloc, which is caught at the border (base/caught.h):
// no crash, no leak of locks, and no half-written file. What succeeds in spite of it is right.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>

#include "../scarce_memory.h"
#include "../scratch_fixture.h"
#include "base/caught.h"
#include "base/json.h"
#include "base/tasks.h"
#include "cloth/cloth.h"
#include "cloth/maps.h"
#include "design/edits.h"
#include "draft/drawdown.h"
#include "draft/factor.h"
#include "files/design_drape.h"
#include "platform/files_below.h"
#include "texture_set/targets.h"
#include "texture_set/texture_set.h"
#include "weaves/weaves.h"
#include "wif/wif.h"

namespace weftlight {

using draft::drawdown;

namespace {

namespace fs = std::filesystem;
constexpr int kMax = 500;  // calls of operator new

/// Runs `job`, whose nth call of operator new fails. `reached`: whether it made so many.
bool fails_at(int n, const std::function<void()>& job, bool& reached) {
  return !base::caught([&] {
    const NthFails fails(n);
    const base::Result<void> inner = base::caught(job);
    reached = NthFails::failed();
    if (!inner) throw std::bad_alloc();
  });
}

/// Runs `job`, once for each call of operator new that fails, until it ends before the nth call. Returns how often it
/// failed.
int at_each_allocation(const std::function<void()>& job, const std::function<void(int n)>& after) {
  int failures = 0;
  bool reached = true;
  for (int n = 1; reached && n <= kMax; ++n) {
    failures += fails_at(n, job, reached);
    after(n);
  }
  return failures;
}

design::Design sample() { return weaves::twill({2, 2}, weaves::Lean::kRight, {8, 8}); }

class NthAllocation : public ScratchTest {};

TEST_F(NthAllocation, AllFilesBelowAFolderAreFoundOrNone) {
  fs::create_directories(path("drafts/deep/deeper"));
  written("drafts/a.wif", "a"), written("drafts/deep/b.wif", "b"), written("drafts/deep/deeper/c.wif", "c");
  std::optional<platform::FilesBelow> found;
  EXPECT_GT(at_each_allocation([&] { found.reset(), found = platform::files_below(path("drafts")); },
                               [&](int n) {
                                 if (found) {
                                   EXPECT_EQ(found->files.size(), 3u) << n;
                                   EXPECT_TRUE(found->unread.empty()) << n;
                                 }
                               }),
            5);
}

TEST_F(NthAllocation, OpeningFailsOrReadsTheDraft) {
  const std::string text = wif::write_new_wif(sample());
  const design::Design whole = wif::read_wif(text).file->design;
  std::optional<wif::WifRead> read;
  const int failures = at_each_allocation([&] { read.reset(), read = wif::read_wif(text); },
                                          [&](int n) {
                                            if (read && read->file) {
                                              EXPECT_EQ(read->file->design, whole) << n;
                                            }
                                          });
  EXPECT_GT(failures, 20);
}

TEST_F(NthAllocation, SavingFailsOrWritesTheWholeFile) {
  const std::string old = written("x.wif", "the old file"), text = wif::write_new_wif(sample());
  const int failures = at_each_allocation(
      [&] {
        if (!base::write_file_atomically(old, wif::write_new_wif(sample()))) throw std::bad_alloc();
      },
      [&](int n) {
        const std::string now = base::read_file(old).value_or("");
        EXPECT_TRUE(now == "the old file" || now == text) << n << ": " << now.size() << " bytes";
        size_t files = 0;
        for ([[maybe_unused]] const auto& entry : fs::directory_iterator(dir_)) ++files;
        EXPECT_EQ(files, 1u) << n << ": something is left beside the file";
        if (now != "the old file") base::write_file_atomically(old, "the old file");
      });
  EXPECT_GT(failures, 20);
}

TEST_F(NthAllocation, EditsAndFactorsFailOrAreRight) {
  const design::Design design = sample();
  const design::Design edited = design::with_size(design::with_threading(design, 3, 1, true), 12, 12, 4, 4);
  std::optional<design::Design> now;
  EXPECT_GT(at_each_allocation(
                [&] {
                  now.reset();
                  now = design::with_size(design::with_threading(design, 3, 1, true), 12, 12, 4, 4);
                },
                [&](int n) {
                  if (now) {
                    EXPECT_EQ(*now, edited) << n;
                  }
                }),
            2);
  const draft::BitMatrix cells = drawdown(edited.draft);
  const draft::Draft whole = draft::with_drawdown(design.draft, cells, {8, 8}).value();
  std::optional<draft::Draft> factored;
  EXPECT_GT(at_each_allocation(
                [&] {
                  factored.reset(), factored = draft::with_drawdown(design.draft, cells, {8, 8}).value();
                },
                [&](int n) {
                  if (factored) {
                    EXPECT_EQ(drawdown(*factored), drawdown(whole)) << n;
                  }
                }),
            2);
}

// A drape that cannot be read is simulated, but not where only memory is missing.
TEST_F(NthAllocation, AShippedDrapeIsReadOrNot) {
  design::Design design = sample();
  design.scene.mesh = "sphere";
  const drape::Mesh whole = files::load_design_drape(design).value();
  base::Result<drape::Mesh> read;
  int errors = 0;
  at_each_allocation(
      [&] {
        read = base::failure(base::ErrorKind::kMemory, "");
        read = files::load_design_drape(design);
      },
      [&](int n) {
        if (read) {
          EXPECT_TRUE(read->position_mm == whole.position_mm) << n;  // and not simulated
        } else {
          EXPECT_EQ(read.error().kind, base::ErrorKind::kMemory) << n << ": " << message(read.error());
          ++errors;
        }
      });
  EXPECT_GT(errors, 20);
}

TEST_F(NthAllocation, MapsFailOrAreWhole) {
  const design::Design design = sample();
  const draft::BitMatrix cells = drawdown(design.draft);
  const auto baked = [&] {
    return cloth::bake(cloth::lay_out(design, cells, draft::Face::kFront, cloth::Period::kRepeat), {32, 32, 8});
  };
  const cloth::Maps whole = baked();
  std::optional<cloth::Maps> maps;
  EXPECT_GT(at_each_allocation([&] { maps.reset(), maps = baked(); },
                               [&](int n) {
                                 if (maps) {
                                   EXPECT_EQ(maps->height_mm.at_, whole.height_mm.at_) << n;
                                 }
                               }),
            20);
}

// nlohmann's destructor asks for memory, also of values that an initializer list leaves behind.
TEST_F(NthAllocation, TreesOfJsonAreMadeAndGo) {
  const auto made = [] {
    nlohmann::json tree{{"threads", {1, 2, 3}}, {"size", {{"width", 2.5}, {"depth", {{"mm", 4}}}}}};
    tree["maps"] = nlohmann::json::array({tree, {{"name", "height"}}});
    return nlohmann::json::parse(tree.dump()).dump();
  };
  const std::string whole = made();
  std::string now;
  EXPECT_GT(at_each_allocation([&] { now.clear(), now = made(); },
                               [&](int n) { EXPECT_TRUE(now.empty() || now == whole) << n; }),
            20);
}

std::map<std::string, std::string> bytes_in(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::directory_iterator(folder))
    all[entry.path().filename().string()] = base::read_file(entry.path().string()).value_or("");
  return all;
}

/// How often `job` asks for memory.
int allocations_of(const std::function<void()>& job) {
  constexpr int kMany = 1 << 30;
  const NthFails counts(kMany);
  job();
  return kMany - NthFails::left();
}

// Where it begins, and where it puts the set in place and clears up.
TEST_F(NthAllocation, AnExportFailsOrIsWhole) {
  // On this thread alone, so that every export asks for memory as often.
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  texture_set::TextureSetOptions options;
  options.target = &texture_set::targets::kRaw;  // without a fit, which takes most of the time
  options.name = "x", options.size = 16, options.draft_path = options.source = "x.wif";
  const design::Design before = sample(), after = design::with_palette_color(before, 0, {0.9f, 0.1f, 0.2f});
  const auto write = [&](const char* folder, const design::Design& design) {
    return texture_set::write_texture_set(path(folder), design, {}, options);
  };
  ASSERT_EQ(problem_of(write("old", before)) + problem_of(write("new", after)) + problem_of(write("set", before)), "");
  const auto old_set = bytes_in(path("old")), new_set = bytes_in(path("new"));
  ASSERT_NE(old_set, new_set);
  const int all = allocations_of([&] { write("set", after); });
  ASSERT_EQ(problem_of(write("set", before)), "");
  const auto job = [&] {
    if (!write("set", after)) throw std::bad_alloc();
  };
  const auto nothing_beside = [&](int n) {
    size_t folders = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(dir_)) ++folders;
    EXPECT_EQ(folders, 3u) << n << ": something is left beside the set";
  };
  EXPECT_GT(at_each_allocation(job,
                               [&](int n) {
                                 const auto now = bytes_in(path("set"));
                                 EXPECT_TRUE(now == old_set || now == new_set) << n;
                                 nothing_beside(n);
                               }),
            100);
  // Whole exports take their time, so these are few.
  constexpr int kFailures = 8, kStep = 30;
  int failures = 0;
  for (int n = all - 1; n > all - kFailures * kStep; n -= kStep) {
    bool reached = false;
    failures += fails_at(n, job, reached) ? 1 : 0;
    EXPECT_TRUE(reached) << n;
    // Files change one after the other, each as a whole; the list holds those of both sets.
    for (const auto& [name, bytes] : bytes_in(path("set")))
      EXPECT_TRUE(name == "texture_set.json" || bytes == old_set.at(name) || bytes == new_set.at(name)) << n;
    nothing_beside(n);
  }
  EXPECT_GT(failures, kFailures / 2) << "what fails at an allocation that is not needed may go on";
}

// A destructor that throws ends the program.
TEST_F(NthAllocation, ARunnerOfTasksEndsWithoutMemory) {
  int dropped = 0;
  {
    auto runner = std::make_unique<base::TaskRunner>();
    const std::shared_ptr<int> held(new int(1), [&dropped](const int* one) {
      delete one;
      ++dropped;
    });
    base::Task task;
    task.work = [held](const base::RunningTask& running) {
      for (int i = 0; i < 3; ++i) running.deliver([held] {});
    };
    runner->start(std::move(task));
    runner->wait();
    const NthFails fails(1);
    runner.reset();
    EXPECT_FALSE(NthFails::failed()) << "it asked for memory";
  }
  EXPECT_EQ(dropped, 1) << "results hold it no longer";
}

}  // namespace
}  // namespace weftlight
