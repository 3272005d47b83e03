// A week at the loom, without a window: a scripted weaver opens, paints, generates, saves, prints, exports, weaves and
// closes, day after day, and then memory, file handles and threads are as on the first evening. A few days in the
// ordinary run; WEFTLIGHT_WEEK=600 weaves for as many seconds, and makes 100,000 strokes where it makes some.

#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <random>
#include <thread>

#include "../comes_true.h"
#include "../loom_port.h"
#include "../scratch_fixture.h"
#include "base/loops.h"
#include "design/edits.h"
#include "print/print.h"
#include "session/jobs/export_plan.h"
#include "session/jobs/exporter.h"
#include "session/loom/at_loom.h"
#include "session/loom/loom_link.h"
#include "session/report.h"
#include "session/saver.h"
#include "session/session.h"
#include "weaves/table.h"
#include "wif/wif.h"

#if defined(__SANITIZE_ADDRESS__)
// Of the sanitizer, whose header GCC does not bring along.
extern "C" size_t __sanitizer_get_current_allocated_bytes();  // NOLINT(bugprone-reserved-identifier)
#endif

namespace weftlight::session {

using base::core_count;
using design::Design, design::WeaveUse, design::with_threading, design::with_tieup;
using draft::blank_draft;
using weaves::weave_kinds, weaves::with_weave;
using wif::write_new_wif;

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

size_t entries_of(const char* folder) {
  return static_cast<size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// What the program holds of the system.
struct Held {
  size_t bytes = 0, handles = 0, threads = 0;
};

Held held() {
#if defined(__SANITIZE_ADDRESS__)
  const size_t bytes = __sanitizer_get_current_allocated_bytes();
#else
  const struct mallinfo2 info = mallinfo2();
  const size_t bytes = info.uordblks + info.hblkhd;
#endif
  return {bytes, entries_of("/proc/self/fd"), entries_of("/proc/self/task")};
}

/// Seconds that the weaver works; 0 in the ordinary run.
double long_run_s() {
  const char* wanted = std::getenv("WEFTLIGHT_WEEK");
  return wanted != nullptr ? std::atof(wanted) : 0;
}

Design plain(int threads) {
  Design d;
  d.draft = blank_draft(threads, threads, 8, 8);
  for (int i = 0; i < threads; ++i) d.draft.threading.set(i, i % 8, true), d.draft.treadling.set(i, i % 8, true);
  for (int t = 0; t < 8; ++t)
    for (int s = 0; s < 8; ++s) d.draft.tieup.set(t, s, (s + t) % 8 < 4);
  return d;
}

Document first() { return Document(plain(8)); }

class Week : public ScratchTest {
 protected:
  void SetUp() override {
    session_ = std::make_unique<Session>(path("recovery"), first());
    saver_ = std::make_unique<Saver>(*session_, writing_);
  }
  int roll(int from, int to) { return std::uniform_int_distribution<int>(from, to)(dice_); }
  std::string draft_file(int k) const {
    return written("draft" + std::to_string(k) + ".wif", write_new_wif(plain(64)));
  }
  OpenDocument& open(const std::string& file) {
    return session_->add(std::move(*open_document(file).document), Origin::kOwn);
  }
  void stroke();
  void regret();
  void generate();
  void save(uint64_t id, const std::string& file);
  void at_the_loom();
  void out_of_the_window();
  void close_all();
  void day();

  std::mt19937 dice_{1};
  uint64_t strokes_ = 0;
  base::TaskRunner writing_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<Saver> saver_;
  Reporter reporter_;
  Exporter exporter_{[] {}};
  LoomLink link_{[] {}};
  AtLoom loom_;
};

/// A drag over a few cells.
void Week::stroke() {
  ++strokes_;
  const int end = roll(0, 60), shaft = roll(0, 7);
  for (int k = 0; k < 3; ++k)
    session_->commit({"Paint", [=](Design d) { return with_threading(std::move(d), end + k, shaft, true); }}, strokes_);
  if (roll(0, 9) == 0)
    session_->commit({"Tie", [=](Design d) { return with_tieup(std::move(d), shaft, shaft, end % 2 == 0); }},
                     ++strokes_);
}

/// One back, and perhaps forth.
void Week::regret() {
  session_->undo();
  if (roll(0, 1) == 0) session_->redo();
}

/// A weave from the table, over the whole draft.
void Week::generate() {
  const weaves::WeaveKind& kind =
      weave_kinds()[static_cast<size_t>(roll(0, static_cast<int>(weave_kinds().size()) - 1))];
  WeaveUse use;
  use.weave = kind.id;
  const weaves::WeaveValues values = weaves::complete_values(kind, {});
  use.values.assign(values.begin(), values.end());
  use.ends = session_->active().document.now().draft.ends(),
  use.picks = session_->active().document.now().draft.picks();
  auto made = with_weave(session_->active().document.now(), use);
  if (made) session_->commit({kind.name, [&](const Design&) { return made->design; }}, ++strokes_);
}

void Week::save(uint64_t id, const std::string& file) {
  bool written = false;
  saver_->save(id, file, true, [&](const SaveResult& result) { written = is_written(result); });
  while (saver_->saving(0)) writing_.wait(), writing_.take();
  EXPECT_TRUE(written) << file;
}

/// A dozen picks at a loom that answers nothing, and a line that breaks.
void Week::at_the_loom() {
  const LoomPort port;
  link_.connect(port.address());
  const int loom = port.accepted();
  EXPECT_TRUE(comes_true([&] { return link_.take().connected || link_.state() == LoomLink::State::kConnected; }));
  for (int k = 0; k < 12; ++k) {
    LoomStep step = step_by_hand(loom_, session_->active().document.now(), true, true);
    link_.send(step.send);
    if (step.edit) session_->commit(*step.edit, step.edit->stroke);
  }
  ::close(loom);
  link_.disconnect();
  EXPECT_TRUE(comes_true([&] { return link_.state() == LoomLink::State::kOff; }));
  loom_ = {};
}

/// Analysed, printed and exported.
void Week::out_of_the_window() {
  const OpenDocument& shown = session_->active();
  reporter_.on(shown.document.snapshot(), shown.document.cells(), session_->revision(), 5);
  const auto printed = print::printed(shown.document.now(), print::PrintFormat::kSvg, {});
  EXPECT_TRUE(printed);
  ExportPlan plan;
  plan.folder = path("sets"), plan.targets = {&texture_set::targets::kGodot}, plan.size = 16;
  exporter_.start(jobs_of(plan, shown.document.now(), "towel.wif", "1"), shown.document.snapshot());
  EXPECT_TRUE(comes_true([&] { return !exporter_.busy(); }));
  EXPECT_EQ(exporter_.state().written.size(), 1u) << exporter_.take_message();
  EXPECT_TRUE(comes_true([&] { return reporter_.poll() || !reporter_.busy(); }));
}

void Week::close_all() {
  while (session_->all().size() > 1) session_->close(session_->active().id, first);
  session_->close(session_->active().id, first);
  session_->settle();
}

void Week::day() {
  for (int k = 0; k < 4; ++k) {
    OpenDocument& opened = open(path("draft" + std::to_string(k) + ".wif"));
    for (int i = 0; i < 30; ++i) i % 5 == 4 ? regret() : stroke();
    generate();
    session_->step(1);
    session_->step(-1);
    save(opened.id, path("saved" + std::to_string(k) + ".wif"));
    // Strokes that nobody saves.
    stroke();
  }
  at_the_loom();
  out_of_the_window();
  close_all();
  EXPECT_EQ(session_->problem(), "");
}

TEST_F(Week, LeavesNothingBehind) {
  for (int k = 0; k < 4; ++k) draft_file(k);
  const Clock::time_point end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(long_run_s()));
  day();  // tables are made once, and helper threads started
  const Held start = held();
  int days = 0;
  while (days < 2 || Clock::now() < end) day(), ++days;
  const Held now = held();
  std::printf("  %d days, %llu strokes: %zu to %zu KB, %zu to %zu handles, %zu to %zu threads\n", days,
              static_cast<unsigned long long>(strokes_), start.bytes / 1024, now.bytes / 1024, start.handles,
              now.handles, start.threads, now.threads);
  EXPECT_LE(static_cast<double>(now.bytes), 1.05 * static_cast<double>(start.bytes));
  EXPECT_LE(now.handles, start.handles);
  // Loops may only now have started all the threads that they share.
  EXPECT_LE(now.threads, start.threads + static_cast<size_t>(core_count()));
}

TEST_F(Week, StrokesOfOneLongSittingFitIntoMemory) {
  const int strokes = long_run_s() > 0 ? 100'000 : 1000;
  for (int k = 0; k < 4; ++k) draft_file(k);
  open(path("draft0.wif"));
  stroke();
  session_->settle();
  const size_t before = held().bytes;
  const Clock::time_point start = Clock::now();
  for (int k = 0; k < strokes; ++k) {
    const int end = roll(0, 63), shaft = roll(0, 7);
    session_->commit({"Paint", [=](Design d) { return with_threading(std::move(d), end, shaft, true); }}, ++strokes_);
  }
  session_->settle();
  const double ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  const size_t steps = session_->active().document.history().steps(),
               grown = held().bytes - std::min(before, held().bytes);
  std::printf("  %d strokes, %zu steps: %zu KB, %.3f ms a stroke\n", strokes, steps, grown / 1024, ms / strokes);
  // 300 MB for 100,000.
  EXPECT_LE(grown, static_cast<size_t>(strokes) * 3000);
  EXPECT_GE(steps, static_cast<size_t>(strokes) * 8 / 10) << "cells that were painted already make no step";
}

TEST_F(Week, AHundredTabsOpenAndClose) {
  constexpr int kTabs = 100;
  const std::string file = draft_file(0);
  const auto tabs = [&] {
    for (int k = 0; k < kTabs; ++k) {
      open(file);
      stroke();
    }
    EXPECT_EQ(session_->all().size(), static_cast<size_t>(kTabs));
    session_->settle();
    EXPECT_EQ(session_->unsaved().size(), static_cast<size_t>(kTabs));
    for (int k = 0; k < kTabs; ++k) session_->step(1), stroke();
  };
  tabs();
  const size_t open_bytes = held().bytes;
  close_all();
  const Held start = held();
  tabs();
  close_all();
  const Held now = held();
  std::printf("  %d tabs: %zu KB each\n", kTabs, (open_bytes - std::min(open_bytes, start.bytes)) / 1024 / kTabs);
  EXPECT_LE(static_cast<double>(now.bytes), 1.05 * static_cast<double>(start.bytes));
  EXPECT_LE(now.handles, start.handles);
  EXPECT_TRUE(session_->find_left().empty());
}

TEST_F(Week, TenWindowsShareAFolder) {
  constexpr size_t kWindows = 10;
  const std::string file = draft_file(0);
  std::vector<std::unique_ptr<Session>> windows;
  std::vector<uint64_t> opened;
  for (size_t k = 0; k < kWindows; ++k) {
    windows.push_back(std::make_unique<Session>(path("recovery"), first()));
    opened.push_back(windows.back()->add(std::move(*open_document(file).document), Origin::kOwn).id);
    const int end = static_cast<int>(k);
    windows.back()->commit({"Paint", [=](Design d) { return with_threading(std::move(d), end, 7 - end % 8, true); }},
                           1);
  }
  for (const auto& window : windows) window->settle();
  // None takes the work of another for that of a crash, and the first to save is not written over.
  size_t saved = 0;
  for (size_t k = 0; k < kWindows; ++k) {
    EXPECT_TRUE(windows[k]->find_left().empty()) << k;
    EXPECT_EQ(windows[k]->problem(), "");
    const SaveJob job = windows[k]->save_job(opened[k], file);
    const SaveResult result = write(job);
    ASSERT_TRUE(result) << problem_of(result);
    windows[k]->take_saved(job, result);
    saved += is_written(result);
  }
  EXPECT_EQ(saved, 1u);
  EXPECT_EQ(open_document(file).document->now().draft.threading.get(0, 7), true);
  for (const auto& window : windows) window->forget_all();
  windows.clear();
  session_.reset();
  EXPECT_TRUE(!fs::exists(path("recovery")) || fs::is_empty(path("recovery")));
}

}  // namespace
}  // namespace weftlight::session
