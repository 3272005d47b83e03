// Recovered work keeps its name, and its file only if the file is unchanged.

#include "session/document/bring_back.h"

#include "../scratch_fixture.h"
#include "design/edits.h"
#include "session/recovery/journal.h"

namespace weftlight::session {

using design::Design, design::with_threading;
using draft::blank_draft;
using wif::write_new_wif;

namespace {

namespace fs = std::filesystem;

class BringBack : public ScratchTest {
 protected:
  static Design plain(int shafts) {
    Design d;
    d.draft = blank_draft(8, 8, shafts, shafts);
    for (int i = 0; i < 8; ++i) d.draft.threading.set(i, i % shafts, true);
    return d;
  }
  static Edit paint() {
    return {"paint", [](Design d) { return with_threading(std::move(d), 0, 1, true); }};
  }
  std::string draft_file(const std::string& name, int shafts = 4) const {
    return written(name, write_new_wif(plain(shafts)) + "[PRIVATE ANOTHER PROGRAM]\r\nKept=as it is\r\n");
  }

  /// A crashed session that had this document.
  LeftWork left_of(const Document& document) const {
    const std::string folder = path("recovery/0123456789abcdef");
    fs::create_directories(folder);
    const std::string journal =
        written("recovery/0123456789abcdef/1.journal", journal_start({document.note(), document.writer()()}));
    return {journal, document.note(), 0};
  }
};

TEST_F(BringBack, UnsavedWorkWithoutAFileStaysWithoutOne) {
  Document draft(plain(4));
  draft.commit(paint(), 0);
  const LeftWork left = left_of(draft);
  draft_file("opened.wif");  // by the window that brings it back
  const OpenResult back = bring_back(left);
  ASSERT_TRUE(back.document);
  EXPECT_EQ(back.document->path(), "");
  EXPECT_EQ(back.document->name(), "Untitled");
  EXPECT_FALSE(back.document->is_saved());
  EXPECT_EQ(back.document->now(), draft.now());
}

TEST_F(BringBack, KeepsItsFileIfTheFileIsUnchanged) {
  const std::string file = draft_file("a.wif");
  Document draft = *open_document(file).document;
  const Design before = draft.now();
  draft.commit(paint(), 0);
  const LeftWork left = left_of(draft);
  OpenResult back = bring_back(left);
  ASSERT_TRUE(back.document);
  EXPECT_EQ(back.document->path(), file);
  EXPECT_FALSE(back.document->is_saved());
  EXPECT_EQ(back.document->now(), draft.now());
  EXPECT_EQ(back.document->writer()(), draft.writer()());
  EXPECT_TRUE(back.document->undo());
  EXPECT_EQ(back.document->now(), before);
  EXPECT_TRUE(back.document->is_saved());
}

TEST_F(BringBack, DetachesFromAFileThatIsGoneOrChanged) {
  for (const bool gone : {true, false}) {
    const std::string file = draft_file("a.wif");
    Document draft = *open_document(file).document;
    draft.commit(paint(), 0);
    const LeftWork left = left_of(draft);
    if (gone) fs::remove(file);
    else draft_file("a.wif", 6);
    const OpenResult back = bring_back(left);
    ASSERT_TRUE(back.document) << gone;
    EXPECT_EQ(back.document->path(), "") << gone;
    EXPECT_EQ(back.document->name(), "a.wif") << gone;
    EXPECT_FALSE(back.document->is_saved()) << gone;
    EXPECT_EQ(back.document->now(), draft.now()) << gone;
    EXPECT_EQ(back.document->writer()(), draft.writer()()) << "also what another program wrote into it";
  }
}

TEST_F(BringBack, WorkSavedBeforeTheCrashIsNotOffered) {
  const std::string file = draft_file("a.wif");
  Document draft = *open_document(file).document;
  draft.commit(paint(), 0);
  left_of(draft);
  EXPECT_EQ(Recovery(path("recovery")).left_behind().size(), 1u);
  written("a.wif", draft.writer()());
  EXPECT_TRUE(Recovery(path("recovery")).left_behind().empty());
}

TEST_F(BringBack, ReportsWhatCannotBeRead) {
  const OpenResult none = bring_back({path("none.journal"), {}, 0});
  EXPECT_FALSE(none.document);
  ASSERT_EQ(none.remarks.size(), 1u);
  const OpenResult odd = bring_back({written("odd.journal", journal_start({{}, "no draft"})), {}, 0});
  EXPECT_FALSE(odd.document);
  EXPECT_FALSE(odd.remarks.empty());
}

TEST_F(BringBack, ADocumentNoticesChangesOfItsFileByOtherPrograms) {
  const std::string file = draft_file("a.wif");
  Document one = *open_document(file).document, two = *open_document(file).document;
  one.commit(paint(), 0);
  const std::string bytes = one.writer()();
  written("a.wif", bytes);
  one.mark_saved(file, identify(file, bytes), one.history().mark());
  EXPECT_EQ(one.look_at_file(), FileChange::kNone);
  EXPECT_EQ(two.look_at_file(), FileChange::kContent) << "two windows on one file";
  two.accept_file();
  EXPECT_EQ(two.look_at_file(), FileChange::kNone);
  fs::remove(file);
  EXPECT_EQ(one.look_at_file(), FileChange::kGone);
}

TEST(TimeInWords, NamesTodayYesterdayOrTheDate) {
  constexpr int64_t kDay = int64_t{24 * 3600} * 1'000'000'000, kNow = int64_t{1'800'000'000} * 1'000'000'000;
  EXPECT_TRUE(time_in_words(kNow, kNow).starts_with("today "));
  EXPECT_TRUE(time_in_words(kNow - kDay, kNow).starts_with("yesterday "));
  EXPECT_NE(time_in_words(kNow - 400 * kDay, kNow).find("2025"), std::string::npos);
}

}  // namespace
}  // namespace weftlight::session
