// The user's library of yarns as a file: changes, lists in and out, and files that cannot be read.

#include "session/library/yarn_shelf.h"

#include <filesystem>
#include <optional>

#include "../scratch_fixture.h"

namespace weftlight::session {

using base::Result, base::TaskRunner, base::problem_of, base::read_file;
using design::yarn_library_text;

namespace {

LibraryYarn named(const std::string& name) {
  LibraryYarn y;
  y.yarn.name = name;
  return design::as_written(y);
}

class YarnShelfTest : public ScratchTest {
 protected:
  void settle() {
    runner_.wait();
    runner_.take();
    runner_.wait();
    runner_.take();
  }
  /// The problem of a change, or empty.
  std::string change(YarnShelf& shelf, YarnShelf::Change change) {
    std::string problem = "not done";
    shelf.change(std::move(change), [&](const Result<void>& done) { problem = problem_of(done); });
    settle();
    return problem;
  }
  static std::vector<std::string> names(const YarnShelf& shelf) {
    std::vector<std::string> out;
    for (const LibraryYarn& y : shelf.yarns()) out.push_back(y.yarn.name);
    return out;
  }
  using Names = std::vector<std::string>;

  TaskRunner runner_;
};

TEST_F(YarnShelfTest, ChangesAreShownAtOnceAndWritten) {
  YarnShelf shelf(runner_, path("new folder/yarns.txt"));
  shelf.change(keep_yarn(named("Tuna")), {});
  EXPECT_EQ(names(shelf), Names{"Tuna"}) << "before it is written";
  EXPECT_EQ(change(shelf, keep_yarn(named("Line"))), "");
  EXPECT_EQ(change(shelf, replace_yarn(named("Tuna"), named("Alpaca"))), "");
  EXPECT_EQ(names(shelf), (Names{"Alpaca", "Line"}));
  EXPECT_EQ(change(shelf, remove_yarn(named("Line"))), "");
  YarnShelf again(runner_, shelf.path());
  again.load({});
  settle();
  EXPECT_EQ(again.yarns(), std::vector<LibraryYarn>{named("Alpaca")});
}

TEST_F(YarnShelfTest, TwoWindowsKeepEachOthersYarns) {
  YarnShelf one(runner_, path("yarns.txt")), other(runner_, path("yarns.txt"));
  EXPECT_EQ(change(one, keep_yarn(named("Tuna"))), "");
  EXPECT_EQ(change(other, keep_yarn(named("Line"))), "");
  EXPECT_EQ(names(other), (Names{"Line", "Tuna"}));
  EXPECT_EQ(change(one, remove_yarn(named("Tuna"))), "");
  EXPECT_EQ(names(one), Names{"Line"});
}

TEST_F(YarnShelfTest, AFileThatCannotBeReadIsNeverWrittenOver) {
  const std::string file = written("yarns.txt", "[Yarn]\nName=L\xE4mm\n");
  YarnShelf shelf(runner_, file);
  std::string problem;
  shelf.load([&](const Result<void>& read) { problem = problem_of(read); });
  settle();
  EXPECT_NE(problem.find("yarns.txt"), std::string::npos) << problem;
  EXPECT_NE(change(shelf, keep_yarn(named("Tuna"))).find("UTF-8"), std::string::npos);
  EXPECT_EQ(read_file(file).value_or(""), "[Yarn]\nName=L\xE4mm\n");
}

TEST_F(YarnShelfTest, LinesByHandStayWhenTheLibraryChanges) {
  const std::string file = written("yarns.txt", "# mine\n[Yarn]\nName=Tuna\nShelf=3\n");
  YarnShelf shelf(runner_, file);
  EXPECT_EQ(change(shelf, keep_yarn(named("Line"))), "");
  const std::string now = read_file(file).value_or("");
  EXPECT_NE(now.find("# mine\n"), std::string::npos);
  EXPECT_NE(now.find("Shelf=3\n"), std::string::npos);
}

TEST_F(YarnShelfTest, ListsComeInAndGoOut) {
  YarnShelf shelf(runner_, path("yarns.txt"));
  EXPECT_EQ(change(shelf, keep_yarn(named("Tuna"))), "");
  const std::string list = written("list.txt", "[Yarn]\nName=Line\nCount=thin\n[Yarn]\nName=Alpaca\n");
  std::optional<ImportedYarns> in;
  shelf.import(list, [&](const Result<ImportedYarns>& done) { in = done ? std::optional(*done) : std::nullopt; });
  settle();
  ASSERT_TRUE(in);
  EXPECT_EQ(in->count, 2u);
  EXPECT_NE(in->remark.find("line 3"), std::string::npos) << in->remark;
  EXPECT_EQ(names(shelf), (Names{"Alpaca", "Line", "Tuna"}));
  std::string problem = "not done";
  shelf.export_to(path("out.txt"), [&](const Result<void>& done) { problem = problem_of(done); });
  settle();
  EXPECT_EQ(problem, "");
  EXPECT_EQ(read_file(path("out.txt")).value_or(""), read_file(path("yarns.txt")).value_or("?"));
  bool refused = false;
  shelf.import(path("missing.txt"), [&](const Result<ImportedYarns>& done) { refused = !done; });
  settle();
  EXPECT_TRUE(refused);
  EXPECT_EQ(names(shelf).size(), 3u);
}

}  // namespace
}  // namespace weftlight::session
