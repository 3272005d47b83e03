// Changes of a file by other programs are noticed; a new time alone is no change.

#include "session/files/file_identity.h"

#include <fstream>

#include "../scratch_fixture.h"

namespace weftlight::session {
namespace {

namespace fs = std::filesystem;
using FileIdentityTest = ScratchTest;

TEST_F(FileIdentityTest, AnUntouchedFileIsUnchanged) {
  const std::string file = written("a.wif", "one");
  FileIdentity known = identify(file);
  EXPECT_TRUE(known.there);
  EXPECT_EQ(changed_since(file, known), FileChange::kNone);
}

TEST_F(FileIdentityTest, NoticesNewContentOfTheSameSize) {
  const std::string file = written("a.wif", "one");
  FileIdentity known = identify(file);
  written("a.wif", "two");
  EXPECT_EQ(changed_since(file, known), FileChange::kContent);
}

TEST_F(FileIdentityTest, NoticesContentWrittenInPlaceWithTheOldTime) {
  const std::string file = written("a.wif", "one");
  const auto time = fs::last_write_time(file);
  FileIdentity known = identify(file);
  std::ofstream(file) << "other";
  fs::last_write_time(file, time);
  EXPECT_EQ(changed_since(file, known), FileChange::kContent);
}

TEST_F(FileIdentityTest, ATouchedFileIsUnchanged) {
  const std::string file = written("a.wif", "one");
  FileIdentity known = identify(file);
  written("a.wif", "one");
  EXPECT_EQ(changed_since(file, known), FileChange::kNone);
  EXPECT_EQ(known, identify(file)) << "so that it is not read again the next time";
}

TEST_F(FileIdentityTest, NoticesDeletionAndCreation) {
  const std::string file = written("a.wif", "one");
  FileIdentity known = identify(file), none = identify(path("b.wif"));
  fs::remove(file);
  EXPECT_EQ(changed_since(file, known), FileChange::kGone);
  EXPECT_FALSE(none.there);
  EXPECT_EQ(changed_since(path("b.wif"), none), FileChange::kNone);
  written("b.wif", "new");
  EXPECT_EQ(changed_since(path("b.wif"), none), FileChange::kContent);
}

}  // namespace
}  // namespace weftlight::session
