// What a journal keeps, and what can be read when it is damaged, the disk is full, or its folder is gone.

#include "session/recovery/journal.h"

#include <sys/stat.h>

#include <fstream>
#include <new>
#include <stdexcept>
#include <utility>

#include "../comes_true.h"
#include "../scratch_fixture.h"
#include "../semaphore.h"
#include "session/recovery/journal_format.h"

namespace weftlight::session {
namespace {

namespace fs = std::filesystem;

DocumentNote note(const std::string& name) { return {"/some where/" + name, name, {true, 1, 2, 3, -4, 5}}; }

TEST(JournalFormat, ReadsTheLastEntry) {
  std::string bytes = journal_start({note("caf\xe9\n.wif"), "one two three"});
  EXPECT_EQ(read_journal(bytes)->note, note("caf\xe9\n.wif"));
  EXPECT_EQ(read_journal(bytes)->text, "one two three");
  std::string before = "one two three";
  for (const std::string now : {"one three", "one three", "", "new", "one new and two newer", "newer"}) {
    bytes += journal_entry(before, now);
    EXPECT_EQ(read_journal(bytes)->text, now);
    before = now;
  }
}

TEST(JournalFormat, APaintedCellTakesAFewBytes) {
  std::string before;
  for (int i = 1; i < 5000; ++i)
    before.append(std::to_string(i)).append("=").append(std::to_string(i % 16)).append("\r\n");
  std::string now = before;
  now[now.find("\n2500=") + 6] = '7';
  EXPECT_LT(journal_entry(before, now).size(), 64u);
}

TEST(JournalFormat, ATruncatedJournalGivesTheLastCompleteEntry) {
  const std::vector<std::string> texts{"first", "first and second", "third", "third and a last one"};
  std::string bytes = journal_start({note("a.wif"), texts[0]});
  std::vector<size_t> ends{bytes.size()};
  for (size_t i = 1; i < texts.size(); ++i) {
    bytes += journal_entry(texts[i - 1], texts[i]);
    ends.push_back(bytes.size());
  }
  for (size_t cut = 0; cut <= bytes.size(); ++cut) {
    const std::optional<JournalEntry> read = read_journal(bytes.substr(0, cut));
    size_t whole = 0;
    while (whole < ends.size() && ends[whole] <= cut) ++whole;
    ASSERT_EQ(read.has_value(), whole > 0) << cut;
    if (read) {
      EXPECT_EQ(read->text, texts[whole - 1]) << cut;
    }
  }
}

TEST(JournalFormat, ADamagedByteLosesOnlyTheEntriesAfterIt) {
  const std::vector<std::string> texts{"first", "first and second", "third"};
  const std::string bytes =
      journal_start({note("a.wif"), texts[0]}) + journal_entry(texts[0], texts[1]) + journal_entry(texts[1], texts[2]);
  for (size_t at = 0; at < bytes.size(); ++at) {
    std::string odd = bytes;
    odd[at] = static_cast<char>(odd[at] ^ 0x20);
    const std::optional<JournalEntry> read = read_journal(odd);
    if (read) {
      EXPECT_TRUE(read->text == texts[0] || read->text == texts[1]) << at;
    }
  }
}

TEST(JournalFormat, AnEmptyTextAndAFileWithoutDeviceAreKept) {
  const DocumentNote there{"a.wif", "a.wif", {true, 0, 7, 0, 0, 0}};
  const std::optional<JournalEntry> read = read_journal(journal_start({there, ""}));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->note, there);
  EXPECT_EQ(read->text, "");
}

TEST(JournalFormat, ADifferenceOfAnotherTextEndsTheJournal) {
  const std::string start = journal_start({note("a.wif"), "ab"}), next = journal_entry("ab", "abc");
  ASSERT_EQ(read_journal(start + next)->text, "abc");
  // One that begins behind the text, one that keeps more of its end than there is, and one that fits and is another's.
  for (const auto& [before, now] : {std::pair{"abcdefgh", "abcdefghX"}, {"xyz12345", "Xyz12345"}, {"xb", "xbc"}})
    EXPECT_EQ(read_journal(start + journal_entry(before, now) + next)->text, "ab") << now;
}

class JournalTest : public ScratchTest {
 protected:
  std::string root() const { return path("state/recovery"); }
  /// What a start after a crash would find.
  static std::vector<LeftWork> left_in(const std::string& root) { return Recovery(root).left_behind(); }
};

TEST_F(JournalTest, KeepsTheNewestStateOfEachDocument) {
  Recovery recovery(root());
  Journal journal(recovery);
  const uint64_t a = journal.new_document(), b = journal.new_document();
  for (int i = 0; i < 1000; ++i) {
    journal.keep(a, note("a.wif"), [i] { return std::string(static_cast<size_t>(i), 'a'); });
    journal.keep(b, note("b.wif"), [i] { return std::string(static_cast<size_t>(i), 'b'); });
  }
  journal.settle();
  EXPECT_EQ(journal.problem(), "");
  EXPECT_EQ(read_left({recovery.journal_path(a), {}, 0})->text, std::string(999, 'a'));
  EXPECT_EQ(read_left({recovery.journal_path(b), {}, 0})->text, std::string(999, 'b'));
  EXPECT_TRUE(left_in(root()).empty()) << "the session lives";
  journal.forget(a);
  journal.settle();
  EXPECT_EQ(journal.problem(), "");
  EXPECT_FALSE(fs::exists(recovery.journal_path(a)));
  EXPECT_TRUE(fs::exists(recovery.journal_path(b)));
}

TEST_F(JournalTest, LeavesNoFilesWhenEverythingIsSaved) {
  {
    Recovery recovery(root());
    Journal journal(recovery);
    journal.keep(1, note("a.wif"), [] { return "text"; });
    journal.settle();
    journal.forget(1);
  }
  for (const auto& entry : fs::directory_iterator(root())) EXPECT_EQ(entry.path().filename(), "lock");
}

TEST_F(JournalTest, AStrokeIsAppendedAndAnotherNameBeginsItAnew) {
  Recovery recovery(root());
  Journal journal(recovery);
  std::string text(1000, 'a');
  const auto kept = [&](const char* name) {
    journal.keep(1, note(name), [text] { return text; });
    journal.settle();
    struct stat facts {};
    stat(recovery.journal_path(1).c_str(), &facts);
    return std::pair(facts.st_ino, facts.st_size);
  };
  const auto [file, size] = kept("a.wif");
  for (int stroke = 1; stroke <= 3; ++stroke) {
    text[static_cast<size_t>(stroke) * 100] = 'b';
    const auto [now, larger] = kept("a.wif");
    EXPECT_EQ(now, file) << "stroke " << stroke << " wrote all of it";
    EXPECT_GT(larger, size);
    EXPECT_LT(larger, size + stroke * 100);
  }
  EXPECT_EQ(read_left({recovery.journal_path(1), {}, 0})->text, text);
  kept("b.wif");
  EXPECT_EQ(read_left({recovery.journal_path(1), {}, 0})->note.name, "b.wif");
}

TEST_F(JournalTest, AJournalThatCannotBeRemovedIsToldAndTriedAgain) {
  Recovery recovery(root());
  Journal journal(recovery);
  journal.keep(1, note("a.wif"), [] { return "text"; });
  journal.settle();
  const std::string own = recovery.journal_path(1);
  fs::remove(own);
  fs::create_directory(own);
  written(own + "/inside", "of a folder in its place");
  journal.forget(1);
  journal.settle();
  EXPECT_NE(journal.problem().find(own), std::string::npos) << journal.problem();
  journal.replace({path("nothing/1.journal"), {}, 0}, 1);  // joins what failed
  fs::remove(own + "/inside");
  EXPECT_TRUE(comes_true([&] { return !journal.busy(); }));
  EXPECT_EQ(journal.problem(), "");
  EXPECT_FALSE(fs::exists(own));
}

TEST_F(JournalTest, IsRewrittenWhenItHasGrown) {
  Recovery recovery(root());
  Journal journal(recovery);
  std::string text(3 << 20, 'a');
  for (int i = 0; i < 6; ++i) {
    text.assign(text.size(), static_cast<char>('a' + i));
    journal.keep(1, note("a.wif"), [text] { return text; });
    journal.settle();
    EXPECT_LE(fs::file_size(recovery.journal_path(1)), 10u << 20) << i;
  }
  EXPECT_EQ(read_left({recovery.journal_path(1), {}, 0})->text, text);
}

TEST_F(JournalTest, SurvivesTheLossOfItsFolder) {
  Recovery recovery(root());
  Journal journal(recovery);
  journal.keep(1, note("a.wif"), [] { return "one"; });
  journal.settle();
  fs::remove_all(path("state"));
  journal.keep(1, note("a.wif"), [] { return "two"; });
  journal.settle();
  EXPECT_EQ(journal.problem(), "");
  EXPECT_EQ(read_left({recovery.journal_path(1), {}, 0})->text, "two");
  EXPECT_TRUE(left_in(root()).empty()) << "and it still lives";
}

TEST_F(JournalTest, AWriteErrorNamesFileAndCauseUntilItSucceeds) {
  written("state", "a file where the folder should be");
  Recovery recovery(root());
  Journal journal(recovery);
  journal.keep(1, note("a.wif"), [] { return "one"; });
  journal.settle();
  EXPECT_NE(journal.problem().find("a.wif"), std::string::npos) << journal.problem();
  EXPECT_NE(journal.problem().find(path("state")), std::string::npos) << journal.problem();
  EXPECT_TRUE(journal.busy());
  fs::remove(path("state"));
  // Without another change.
  for (int i = 0; i < 300 && !journal.problem().empty(); ++i) usleep(10'000);
  EXPECT_EQ(journal.problem(), "");
  EXPECT_EQ(read_left({recovery.journal_path(1), {}, 0})->text, "one");
}

TEST_F(JournalTest, TheOldJournalIsRemovedOnlyAfterTheNewOneIsOnDisk) {
  const std::string old = path("state/recovery/0123456789abcdef");
  fs::create_directories(old);
  written("state/recovery/0123456789abcdef/1.journal", journal_start({note("a.wif"), "left"}));
  Recovery recovery(root());
  std::vector<LeftWork> left = recovery.left_behind();
  ASSERT_EQ(left.size(), 1u);
  Journal journal(recovery);
  bool fails = true;
  const auto text = [&fails]() -> std::string {
    if (fails) throw std::bad_alloc();
    return "left and more";
  };
  journal.keep(1, note("a.wif"), text);
  journal.replace(left[0], 1);
  journal.settle();
  EXPECT_FALSE(journal.problem().empty());
  EXPECT_TRUE(fs::exists(left[0].journal));
  journal.keep(1, note("a.wif"), [] { return "left and more"; });
  for (int i = 0; i < 300 && journal.busy(); ++i) usleep(10'000);
  EXPECT_EQ(journal.problem(), "");
  EXPECT_FALSE(fs::exists(old));
  EXPECT_EQ(read_left({recovery.journal_path(1), {}, 0})->text, "left and more");
}

TEST_F(JournalTest, WhatMayNotBeOnTheDiskKeepsTheOldOne) {
  const std::string old = path("state/recovery/0123456789abcdef");
  fs::create_directories(old);
  written("state/recovery/0123456789abcdef/1.journal", journal_start({note("a.wif"), "left"}));
  Recovery recovery(root());
  const std::vector<LeftWork> left = recovery.left_behind();
  ASSERT_EQ(left.size(), 1u);
  Journal journal(recovery);
  journal.keep(1, note("a.wif"), [] { return "left and more"; });
  journal.settle();
  // A journal that cannot be opened to be synced.
  const std::string own = recovery.journal_path(1);
  fs::remove(own);
  fs::create_symlink(own, own);
  journal.replace(left[0], 1);
  journal.settle();
  EXPECT_NE(journal.problem().find("may not be on the disk (" + own + ")"), std::string::npos) << journal.problem();
  EXPECT_TRUE(fs::exists(left[0].journal));
  // One that is gone, as after a save, keeps nothing.
  fs::remove(own);
  for (int i = 0; i < 300 && journal.busy(); ++i) usleep(10'000);
  EXPECT_EQ(journal.problem(), "");
  EXPECT_FALSE(fs::exists(left[0].journal));
}

TEST_F(JournalTest, WhatIsThrownIsToldAsItsProblem) {
  Recovery recovery(root());
  Journal journal(recovery);
  journal.keep(1, note("a.wif"), []() -> std::string { throw std::runtime_error("the line broke"); });
  journal.settle();
  EXPECT_EQ(journal.problem(), "No recovery copy: the line broke");
}

TEST_F(JournalTest, AWaitingRequestIsNotLostToTheNext) {
  Recovery recovery(root());
  Journal journal(recovery);
  for (const uint64_t document : {1, 2}) journal.keep(document, note("a.wif"), [] { return "text"; });
  journal.settle();
  // While another document is written: one is forgotten, one kept anew, and each then takes the place of old work.
  BinarySemaphore begun{0}, proceed{0};
  journal.keep(3, note("c.wif"), [&] {
    begun.release();
    proceed.acquire();
    return std::string("slow");
  });
  begun.acquire();
  const LeftWork none{path("state/recovery/0123456789abcdef/1.journal"), {}, 0};
  journal.forget(1);
  journal.replace(none, 1);
  journal.keep(2, note("a.wif"), [] { return "newer"; });
  journal.replace(none, 2);
  proceed.release();
  journal.settle();
  EXPECT_FALSE(fs::exists(recovery.journal_path(1)));
  EXPECT_EQ(read_left({recovery.journal_path(2), {}, 0})->text, "newer");
}

/// A text that is begun, waits, and fails; the next time it is there.
class FailsOnce {
 public:
  std::string operator()() {
    if (std::exchange(failed_, true)) return "at the second try";
    begun_.release();
    proceed_.acquire();
    throw std::bad_alloc();
  }
  void wait_for_its_begin() { begun_.acquire(); }
  void let_it_fail() { proceed_.release(); }

 private:
  BinarySemaphore begun_{0}, proceed_{0};
  bool failed_ = false;
};

TEST_F(JournalTest, WhatFailsJoinsTheRequestThatCameMeanwhile) {
  const std::string old = path("old/0123456789abcdef/1.journal");
  fs::create_directories(fs::path(old).parent_path());
  written("old/0123456789abcdef/1.journal", journal_start({note("a.wif"), "left"}));
  Recovery recovery(root());
  Journal journal(recovery);
  const auto text_of = [&](uint64_t document) { return read_left({recovery.journal_path(document), {}, 0})->text; };
  // One without a text of its own: the older text is still to be written.
  FailsOnce first, second;
  journal.keep(1, note("a.wif"), [&] { return first(); });
  first.wait_for_its_begin();
  journal.replace({path("nothing/1.journal"), {}, 0}, 1);
  first.let_it_fail();
  EXPECT_TRUE(comes_true([&] { return !journal.busy(); }));
  EXPECT_EQ(text_of(1), "at the second try");
  // One with a newer text, which stays; what the older one was to replace is replaced by it.
  journal.keep(2, note("a.wif"), [&] { return second(); });
  journal.replace({old, {}, 0}, 2);
  second.wait_for_its_begin();
  journal.keep(2, note("a.wif"), [] { return "newer"; });
  second.let_it_fail();
  EXPECT_TRUE(comes_true([&] { return !journal.busy(); }));
  EXPECT_EQ(text_of(2), "newer");
  EXPECT_FALSE(fs::exists(old));
}

TEST_F(JournalTest, OldWorkStaysWhileItsNewJournalCannotBeWritten) {
  const std::string old = path("old/0123456789abcdef/1.journal");
  fs::create_directories(fs::path(old).parent_path());
  written("old/0123456789abcdef/1.journal", journal_start({note("a.wif"), "left"}));
  written("state", "a file where the folder should be");
  Recovery recovery(root());
  Journal journal(recovery);
  journal.keep(1, note("a.wif"), [] { return "left and more"; });
  journal.replace({old, {}, 0}, 1);
  journal.settle();
  EXPECT_NE(journal.problem(), "");
  EXPECT_TRUE(fs::exists(old));
}

}  // namespace
}  // namespace weftlight::session
