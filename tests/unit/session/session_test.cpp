// Several documents without a window: opened, edited, closed, saved, and recovered after a crash.

#include "session/session.h"

#include <signal.h>
#include <sys/wait.h>

#include <memory>

#include "../scratch_fixture.h"
#include "design/edits.h"
#include "session/editing/selection_state.h"
#include "wif/wif.h"

namespace weftlight::session {

using design::Design, design::History, design::with_new_palette_color, design::with_new_yarn, design::with_threading;
using draft::BitGrid, draft::Selection, draft::blank_draft, draft::drawdown;
using wif::Diagnostic, wif::write_new_wif;

namespace {

namespace fs = std::filesystem;

Design plain(int shafts, const std::string& title = {}) {
  Design d;
  d.title = title;
  d.draft = blank_draft(8, 8, shafts, shafts);
  for (int i = 0; i < 8; ++i) d.draft.threading.set(i, i % shafts, true);
  return d;
}

Document first() { return Document(plain(4, "first")); }

/// End 1 on another shaft.
Edit paint(int shaft = 1) {
  return {"Paint", [shaft](Design d) { return with_threading(std::move(d), 0, shaft, true); }};
}

class SessionTest : public ScratchTest {
 protected:
  std::unique_ptr<Session> session() const {
    auto made = std::make_unique<Session>(path("recovery"), first());
    made->set_left(made->find_left());
    return made;
  }
  static std::string save(Session& s, uint64_t id, const std::string& file) {
    const SaveJob job = s.save_job(id, file);
    const SaveResult result = write(job);
    s.take_saved(job, result);
    return problem_of(result);
  }
  std::string draft_file(const std::string& name, int shafts = 4) const {
    return written(name, write_new_wif(plain(shafts)));
  }
  static OpenDocument& open(Session& s, const std::string& file) {
    return s.add(std::move(*open_document(file).document), Origin::kOwn);
  }
  /// A session in a process of its own that opens the files, edits each, and is killed.
  void crash_with(const std::vector<std::string>& files) const {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      const auto s = session();
      int shaft = 0;
      for (const std::string& file : files) {
        open(*s, file);
        s->commit(paint(++shaft), 0);
      }
      s->settle();
      kill(getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
  }
  /// The newest work of a crashed session.
  static OpenDocument* bring_back(Session& s, std::vector<Diagnostic>& why) {
    const LeftWork left = s.left()[0];
    OpenResult back = session::bring_back(left);
    why = back.remarks;
    return s.take_back(left, std::move(back));
  }
  static std::vector<std::string> titles(const Session& s) {
    std::vector<std::string> all;
    for (const auto& open : s.all()) all.push_back(open->document.now().title);
    return all;
  }
};

using Titles = std::vector<std::string>;

TEST_F(SessionTest, AnEditThatAddsTreadlesLetsTheDraftBeFittedAgainPaintingDoesNot) {
  const auto s = session();
  Edit wider{"Paste", [](Design d) {
               const int treadles = d.draft.treadles + 2;
               return design::with_size(std::move(d), 8, 8, 4, treadles);
             }};
  ASSERT_TRUE(s->commit(wider, 1));
  EXPECT_TRUE(s->active().view.draft.has_grown);
  s->active().view.draft.has_grown = false;
  ASSERT_TRUE(s->commit(paint(), 2));
  EXPECT_FALSE(s->active().view.draft.has_grown) << "no treadle more";
  wider.by_painting = true;
  ASSERT_TRUE(s->commit(wider, 3));
  EXPECT_FALSE(s->active().view.draft.has_grown);
}

TEST_F(SessionTest, EachDocumentHasItsOwnHistoryAndView) {
  const auto s = session();
  const uint64_t one = open(*s, draft_file("one.wif")).id;
  s->commit(paint(), 0);
  s->active().view.draft.pitch = 17;
  const Design painted = s->active().document.now();
  const uint64_t two = open(*s, draft_file("two.wif", 8)).id;
  EXPECT_EQ(s->active().view.draft.pitch, 0) << "to be fitted";
  EXPECT_FALSE(s->undo()) << "nothing was done in this one";
  EXPECT_EQ(s->unsaved(), std::vector<uint64_t>{one});
  s->show(one);
  EXPECT_EQ(s->active().view.draft.pitch, 17);
  EXPECT_EQ(s->active().document.now(), painted);
  EXPECT_TRUE(s->undo());
  EXPECT_TRUE(s->unsaved().empty());
  EXPECT_NE(one, two);
}

TEST_F(SessionTest, UndoAndRedoBringTheSelectionBack) {
  const auto s = session();
  SelectState& select = s->active().view.select;
  ThreadChoice& chosen = s->active().view.chosen;
  const Selection first{BitGrid::kThreading, 1, 3, 0, 2}, second{BitGrid::kTieup, 0, 2, 0, 2};
  select_cells(select, first);
  chosen.threads = {1, 2};
  s->commit(paint(1), 0);
  select_cells(select, second);
  chosen.threads.clear();
  s->commit(paint(2), 0);
  select_cells(select, {});
  ASSERT_TRUE(s->undo());
  EXPECT_EQ(select.selected, second);
  ASSERT_TRUE(s->undo());
  EXPECT_EQ(select.selected, first);
  EXPECT_EQ(chosen.threads, (std::vector<int>{1, 2}));
  ASSERT_TRUE(s->redo());
  EXPECT_EQ(select.selected, second);
}

TEST_F(SessionTest, UndoOfAColourOrYarnActivatesTheOneBefore) {
  const auto s = session();
  DrawingState& drawing = s->active().view.drawing;
  const auto colors = [&] { return static_cast<int>(s->active().document.now().draft.palette.size()); };
  const auto yarns = [&] { return static_cast<int>(s->active().document.now().yarns.size()); };
  ASSERT_GE(colors(), 2);
  s->commit({"Add colour", [](Design d) { return with_new_palette_color(std::move(d), {0.5f, 0.5f, 0.5f}); }}, 0);
  drawing.color = colors() - 1;
  const design::Yarn yarn = s->active().document.now().yarns[0];
  s->commit({"Add yarn", [&yarn](Design d) { return with_new_yarn(std::move(d), yarn); }}, 0);
  s->commit({"Add yarn", [&yarn](Design d) { return with_new_yarn(std::move(d), yarn); }}, 0);
  drawing.yarn = yarns() - 1;
  ASSERT_TRUE(s->undo());
  ASSERT_TRUE(s->undo());
  EXPECT_EQ(drawing.yarn, 0);
  EXPECT_EQ(drawing.color, colors() - 1) << "is still there";
  ASSERT_TRUE(s->undo());
  EXPECT_EQ(drawing.color, 0) << "not the last one that is left";
}

TEST_F(SessionTest, RevisionsOfTwoDocumentsDiffer) {
  const auto s = session();
  open(*s, draft_file("one.wif"));
  const uint64_t before = s->revision();
  open(*s, draft_file("two.wif"));
  EXPECT_NE(s->revision(), before);
  EXPECT_FALSE(s->is_of_active(before));
  EXPECT_TRUE(s->is_of_active(s->revision()));
}

TEST_F(SessionTest, TheFirstDocumentIsReplacedUnlessEdited) {
  const auto s = session();
  s->add(Document(plain(4, "a")), Origin::kShipped);
  EXPECT_EQ(titles(*s), (Titles{"a"}));
  s->add(Document(plain(4, "b")), Origin::kShipped);
  EXPECT_EQ(titles(*s), (Titles{"b"})) << "leafing through the library";
  s->commit(paint(), 0);
  s->add(Document(plain(4, "c")), Origin::kShipped);
  EXPECT_EQ(titles(*s), (Titles{"b", "c"})) << "an edited one stays";
  s->add(Document(plain(4, "d")), Origin::kOwn);
  EXPECT_EQ(titles(*s), (Titles{"b", "c", "d"})) << "to a file of the weaver's own a shipped one does not give way";
}

TEST_F(SessionTest, AnOpenFileIsFoundByAnyPath) {
  const auto s = session();
  const std::string file = draft_file("one.wif");
  const uint64_t id = open(*s, file).id;
  fs::create_symlink(file, path("link.wif"));
  fs::create_directory(path("folder"));
  EXPECT_EQ(s->on_file(path("folder/../one.wif"))->id, id);
  const FileIdentity linked = open_document(path("link.wif")).document->file();
  ASSERT_NE(s->on_file(path("link.wif"), linked), nullptr);
  EXPECT_EQ(s->on_file(path("link.wif"), linked)->id, id);
  EXPECT_EQ(s->on_file(path("none.wif")), nullptr);
  EXPECT_EQ(s->on_file(""), nullptr);
}

TEST_F(SessionTest, ASaveByAnotherNameOfAnOpenFileIsKnown) {
  const auto s = session();
  const std::string file = draft_file("one.wif");
  const uint64_t one = open(*s, file).id, two = s->add(Document(plain(4, "two")), Origin::kOwn).id;
  fs::create_symlink(file, path("link.wif"));
  const std::string before = base::read_file(file).value_or("");
  EXPECT_NE(save(*s, two, path("link.wif")).find("is open in another tab"), std::string::npos);
  EXPECT_EQ(base::read_file(file).value_or(""), before);
  EXPECT_EQ(save(*s, one, path("link.wif")), "");
  EXPECT_EQ(s->find(one)->document.path(), file) << "it keeps its own name";
  EXPECT_TRUE(fs::is_symlink(path("link.wif")));
}

TEST_F(SessionTest, TabsStepAroundMoveAndClose) {
  const auto s = session();
  std::vector<uint64_t> ids;
  for (const char* name : {"a", "b", "c"}) ids.push_back(s->add(Document(plain(4, name)), Origin::kOwn).id);
  EXPECT_EQ(titles(*s), (Titles{"a", "b", "c"}));
  s->step(1);
  EXPECT_EQ(s->active().id, ids[0]);
  s->step(-1);
  EXPECT_EQ(s->active().id, ids[2]);
  s->move(ids[2], 0);
  EXPECT_EQ(titles(*s), (Titles{"c", "a", "b"}));
  EXPECT_EQ(s->active().id, ids[2]) << "the same is shown";
  s->show(ids[1]);
  s->close(ids[0], first);
  EXPECT_EQ(s->active().id, ids[1]) << "closing another leaves this one shown";
  s->close(ids[1], first);
  EXPECT_EQ(s->active().id, ids[2]);
  s->close(ids[2], first);
  EXPECT_EQ(titles(*s), (Titles{"first"})) << "never none";
  s->close(12345, first);
  EXPECT_EQ(s->all().size(), 1u);
}

TEST_F(SessionTest, AllDocumentsAreOfferedAfterACrash) {
  const std::string a = draft_file("a.wif"), b = draft_file("b.wif", 6);
  ASSERT_NO_FATAL_FAILURE(crash_with({a, b}));
  const auto s = session();
  ASSERT_EQ(s->left().size(), 2u);
  std::vector<Diagnostic> why;
  while (!s->left().empty()) ASSERT_NE(bring_back(*s, why), nullptr);
  ASSERT_EQ(s->all().size(), 2u);
  EXPECT_EQ(s->unsaved().size(), 2u);
  ASSERT_NE(s->on_file(a), nullptr);
  ASSERT_NE(s->on_file(b), nullptr);
  EXPECT_TRUE(s->on_file(a)->document.now().draft.threading.get(0, 1));
  EXPECT_TRUE(s->on_file(b)->document.now().draft.threading.get(0, 2));
  s->settle();
  EXPECT_TRUE(Session(path("recovery"), first()).find_left().empty()) << "this session has them now";
}

TEST_F(SessionTest, RecoveredWorkReplacesTheTabOfItsFile) {
  const std::string a = draft_file("a.wif");
  ASSERT_NO_FATAL_FAILURE(crash_with({a}));
  const auto s = session();
  open(*s, a);
  std::vector<Diagnostic> why;
  ASSERT_NE(bring_back(*s, why), nullptr);
  EXPECT_EQ(s->all().size(), 1u);
  EXPECT_EQ(s->active().document.path(), a);
  EXPECT_TRUE(s->active().document.now().draft.threading.get(0, 1));
}

TEST_F(SessionTest, RecoveredWorkOpensBesideAnEditedTabOfItsFile) {
  const std::string a = draft_file("a.wif");
  ASSERT_NO_FATAL_FAILURE(crash_with({a}));
  const auto s = session();
  open(*s, a);
  s->commit(paint(3), 0);
  std::vector<Diagnostic> why;
  ASSERT_NE(bring_back(*s, why), nullptr);
  EXPECT_EQ(s->all().size(), 2u);
  EXPECT_EQ(s->active().document.path(), "") << "one file, one tab";
  EXPECT_EQ(s->active().document.name(), "a.wif");
}

TEST_F(SessionTest, SavedAndClosedDocumentsLeaveNoJournal) {
  const auto journals = [this] {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(path("recovery")))
      count += entry.path().extension() == ".journal";
    return count;
  };
  const auto s = session();
  const std::string a = draft_file("a.wif");
  const uint64_t one = open(*s, a).id;
  s->commit(paint(), 0);
  const uint64_t two = open(*s, draft_file("b.wif")).id;
  s->commit(paint(), 0);
  s->settle();
  EXPECT_EQ(journals(), 2);
  EXPECT_EQ(save(*s, one, a), "");
  s->settle();
  EXPECT_EQ(journals(), 1);
  EXPECT_EQ(s->unsaved(), std::vector<uint64_t>{two});
  s->close(two, first);
  s->settle();
  EXPECT_EQ(journals(), 0);
  EXPECT_TRUE(open_document(a).document->now().draft.threading.get(0, 1));
}

TEST_F(SessionTest, SavesAllAndReportsWhatFails) {
  const auto s = session();
  std::vector<std::string> files{draft_file("a.wif"), draft_file("b.wif"), path("gone/c.wif")};
  for (size_t i = 0; i < 2; ++i) {
    open(*s, files[i]);
    s->commit(paint(), 0);
  }
  const std::vector<uint64_t> ids = s->unsaved();
  ASSERT_EQ(ids.size(), 2u);
  for (const uint64_t id : ids) EXPECT_EQ(save(*s, id, s->find(id)->document.path()), "");
  EXPECT_TRUE(s->unsaved().empty());
  s->commit(paint(3), 0);
  EXPECT_NE(save(*s, s->active().id, files[2]), "") << "no such folder";
  EXPECT_EQ(s->unsaved().size(), 1u);
  EXPECT_EQ(s->active().document.path(), files[1]);
}

TEST_F(SessionTest, GoesToAnyStepOfTheHistory) {
  const auto s = session();
  for (int shaft = 1; shaft < 4; ++shaft) s->commit(paint(shaft), 0);
  const History& h = s->active().document.history();
  ASSERT_EQ(h.steps(), 4u);
  EXPECT_EQ(h.label(3), "Paint");
  EXPECT_TRUE(s->go_to(0));
  EXPECT_EQ(s->active().document.now(), first().now());
  EXPECT_EQ(s->active().document.cells(), drawdown(first().now().draft));
  EXPECT_TRUE(s->go_to(2));
  EXPECT_EQ(h.position(), 2u);
  EXPECT_TRUE(h.can_redo()) << "the future stays";
  EXPECT_FALSE(s->go_to(2));
}

}  // namespace
}  // namespace weftlight::session
