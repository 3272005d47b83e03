// Edits go on while a draft is saved: nothing is lost, and only what is on the disk counts as saved.

#include "session/saver.h"

#include <signal.h>
#include <sys/wait.h>

#include <memory>
#include <optional>
#include <semaphore>

#include "../scratch_fixture.h"
#include "design/edits.h"
#include "wif/wif.h"

namespace weftlight::session {

using base::read_file;
using design::Design, design::with_threading;
using draft::blank_draft;
using wif::write_new_wif;

namespace {

namespace fs = std::filesystem;

Design plain() {
  Design d;
  d.draft = blank_draft(8, 8, 4, 4);
  for (int i = 0; i < 8; ++i) d.draft.threading.set(i, i % 4, true);
  return d;
}

Document first() { return Document(plain()); }

/// End 1 on another shaft.
Edit paint(int shaft) {
  return {"Paint", [shaft](Design d) { return with_threading(std::move(d), 0, shaft, true); }};
}

class SaverTest : public ScratchTest {
 protected:
  void SetUp() override {
    file_ = written("a.wif", write_new_wif(plain()));
    session_.emplace(path("recovery"), first());
    saver_.emplace(*session_, runner_);
    id_ = open(file_);
  }
  uint64_t open(const std::string& file) {
    return session_->add(std::move(*open_document(file).document), Origin::kOwn).id;
  }
  /// What is started now waits until proceed(), as on a disk that is busy.
  void hold_up() {
    base::Task task;
    task.work = [this](const base::RunningTask&) { disk_.acquire(); };
    task.kind = "disk";
    runner_.start(std::move(task));
  }
  void proceed() {
    disk_.release();
    while (saver_->saving(0)) {
      runner_.wait();
      runner_.take();
    }
  }
  Saver::Then note(std::optional<SaveResult>& result) {
    return [&result](const SaveResult& r) { result = r; };
  }
  const Document& document() { return session_->find(id_)->document; }
  /// The shaft of end 1 in the file.
  static int saved_shaft(const std::string& file) {
    return open_document(file).document->now().draft.threading.first(0);
  }

  std::binary_semaphore disk_{0};
  std::string file_;
  uint64_t id_ = 0;
  base::TaskRunner runner_;
  std::optional<Session> session_;
  std::optional<Saver> saver_;
};

TEST_F(SaverTest, EditsMadeMeanwhileAreKeptAndNotSaved) {
  session_->commit(paint(1), 0);
  hold_up();
  std::optional<SaveResult> result;
  saver_->save(id_, file_, false, note(result));
  session_->commit(paint(2), 0);
  EXPECT_TRUE(saver_->saving(id_));
  EXPECT_FALSE(document().is_saved());
  proceed();
  ASSERT_TRUE(result && is_written(*result));
  EXPECT_EQ(saved_shaft(file_), 1) << "the draft as it was when the save was asked for";
  EXPECT_FALSE(document().is_saved()) << "there is an edit since";
  EXPECT_EQ(document().now().draft.threading.first(0), 2);
  session_->undo();
  EXPECT_TRUE(document().is_saved()) << "this is what is on the disk";
  session_->redo();
  EXPECT_FALSE(document().is_saved());
}

TEST_F(SaverTest, AStrokeThatGoesOnIsNotSaved) {
  session_->commit(paint(1), 7);
  hold_up();
  saver_->save(id_, file_, false, nullptr);
  session_->commit(paint(2), 7);
  proceed();
  EXPECT_FALSE(document().is_saved());
  EXPECT_EQ(saved_shaft(file_), 1);
}

TEST_F(SaverTest, NothingCountsAsSavedBeforeItIsOnTheDisk) {
  session_->commit(paint(1), 0);
  hold_up();
  saver_->save(id_, path("b.wif"), false, nullptr);
  EXPECT_FALSE(document().is_saved());
  EXPECT_EQ(document().path(), file_);
  session_->settle();
  proceed();
  EXPECT_TRUE(document().is_saved());
  EXPECT_EQ(document().path(), path("b.wif"));
  EXPECT_EQ(saved_shaft(file_), 0);
}

TEST_F(SaverTest, OfThoseThatWaitTheNewestIsWritten) {
  session_->commit(paint(1), 0);
  hold_up();
  int followed = 0;
  const auto follow = [&](const SaveResult& r) { followed += is_written(r); };
  for (int shaft = 1; shaft <= 3; ++shaft) {
    session_->commit(paint(shaft), 0);
    saver_->save(id_, file_, false, follow);
  }
  EXPECT_EQ(runner_.shown().size(), 1u) << "one after the other";
  EXPECT_EQ(runner_.shown()[0].name, "Saving a.wif");
  EXPECT_FALSE(runner_.shown()[0].can_stop);
  proceed();
  EXPECT_EQ(followed, 3) << "all are answered";
  EXPECT_EQ(saved_shaft(file_), 3);
  EXPECT_TRUE(document().is_saved());
}

TEST_F(SaverTest, AFailedOneLeavesTheDraftUnsaved) {
  session_->commit(paint(1), 0);
  std::optional<SaveResult> result;
  bool closed = false;
  hold_up();
  saver_->save(id_, path("gone/a.wif"), false, note(result));
  saver_->after(id_, [&] { closed = true; });
  saver_->after(0, [&] { closed = true; });
  EXPECT_TRUE(saver_->awaited(0));
  proceed();
  ASSERT_TRUE(result);
  EXPECT_NE(problem_of(*result).find("gone/a.wif"), std::string::npos) << problem_of(*result);
  EXPECT_FALSE(document().is_saved());
  EXPECT_EQ(document().path(), file_);
  EXPECT_FALSE(closed) << "the user decides anew";
  EXPECT_FALSE(saver_->awaited(0));
}

TEST_F(SaverTest, WhatClosesWaitsForItsSaves) {
  const uint64_t other = open(written("b.wif", write_new_wif(plain())));
  session_->commit(paint(1), 0);
  hold_up();
  std::string order;
  saver_->save(id_, file_, false, [&](const SaveResult&) { order += "a"; });
  saver_->save(other, path("b.wif"), false, [&](const SaveResult&) { order += "b"; });
  saver_->after(id_, [&] { order += "1"; });
  saver_->after(0, [&] { order += "q"; });
  EXPECT_TRUE(saver_->takes(path("b.wif"), id_));
  EXPECT_FALSE(saver_->takes(path("b.wif"), other));
  proceed();
  EXPECT_EQ(order, "a1bq");
  saver_->after(id_, [&] { order += "!"; });
  EXPECT_EQ(order, "a1bq!") << "at once if nothing is being saved";
}

TEST_F(SaverTest, AnotherProgramsChangeIsNoticedAndOurOwnIsNot) {
  session_->commit(paint(1), 0);
  hold_up();
  std::optional<SaveResult> one, two;
  saver_->save(id_, file_, false, note(one));
  saver_->save(id_, path("a copy.wif"), false, nullptr);
  saver_->save(id_, file_, false, note(two));
  proceed();
  EXPECT_TRUE(is_written(*one));
  EXPECT_TRUE(is_written(*two)) << "the change was our own";
  written("a.wif", "theirs");
  session_->commit(paint(2), 0);
  std::optional<SaveResult> three;
  hold_up();
  saver_->save(id_, file_, false, note(three));
  proceed();
  ASSERT_TRUE(*three) << problem_of(*three);
  EXPECT_TRUE((*three)->changed);
  EXPECT_EQ(read_file(file_).value_or(""), "theirs");
  EXPECT_FALSE(document().is_saved());
  hold_up();
  saver_->save(id_, file_, true, note(three));
  proceed();
  EXPECT_TRUE(is_written(*three));
  EXPECT_EQ(saved_shaft(file_), 2);
  EXPECT_EQ(session_->find(id_)->document.look_at_file(), FileChange::kNone);
}

TEST_F(SaverTest, AKillBeforeTheDiskHasItLosesNothing) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    base::TaskRunner runner;
    Session session(path("crashed"), first());
    Saver saver(session, runner);
    const uint64_t id = session.add(std::move(*open_document(file_).document), Origin::kOwn).id;
    session.commit(paint(1), 0);
    base::Task never;
    never.work = [](const base::RunningTask&) { pause(); };
    never.kind = "disk";
    runner.start(std::move(never));
    saver.save(id, file_, false, nullptr);
    session.commit(paint(2), 0);
    session.settle();
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  Session next(path("crashed"), first());
  next.set_left(next.find_left());
  ASSERT_EQ(next.left().size(), 1u);
  const LeftWork left = next.left()[0];
  ASSERT_NE(next.take_back(left, bring_back(left)), nullptr);
  EXPECT_EQ(next.take_back(left, bring_back(left)), nullptr) << "once is enough";
  EXPECT_EQ(next.active().document.now().draft.threading.first(0), 2);
}

}  // namespace
}  // namespace weftlight::session
