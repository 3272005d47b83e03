#include "collection/folder_index.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "../scratch_fixture.h"
#include "base/whole_files.h"
#include "design/design.h"
#include "wif/wif.h"

namespace weftlight::collection {
namespace {

namespace fs = std::filesystem;

class FolderIndexTest : public ScratchTest {
 protected:
  void SetUp() override {
    ScratchTest::SetUp();
    fs::create_directories(drafts() + "/within");
    put("a.wif", 4, "First");
    put("within/b.wif", 8, "Second");
    base::write_file_atomically(drafts() + "/notes.txt", "no draft");
  }
  std::string drafts() const { return (dir_ / "drafts").string(); }
  std::string cache() const { return (dir_ / "cache").string(); }
  void put(const std::string& name, int shafts, const std::string& title) const {
    design::Design d;
    d.title = title;
    d.draft = draft::blank_draft(8, 8, shafts, shafts);
    for (int i = 0; i < 8; ++i) d.draft.threading.set(i, i % shafts, true), d.draft.treadling.set(i, i % shafts, true);
    for (int i = 0; i < shafts; ++i) d.draft.tieup.set(i, i, true);
    ASSERT_TRUE(base::write_file_atomically(drafts() + "/" + name, wif::write_new_wif(d)));
  }
  FolderIndex look() const { return look_through(drafts(), cache()); }
};

TEST_F(FolderIndexTest, ReadsEachFileOnce) {
  const FolderIndex first = look();
  ASSERT_EQ(first.entries->size(), 2U);
  EXPECT_EQ(first.read, 2U);
  EXPECT_EQ((*first.entries)[0].title, "First");
  EXPECT_EQ((*first.entries)[1].shafts, 8);
  EXPECT_EQ((*first.entries)[1].family, WeaveFamily::kTwill);
  const FolderIndex again = look();
  EXPECT_EQ(again.read, 0U);
  EXPECT_EQ(*again.entries, *first.entries);
}

TEST_F(FolderIndexTest, FollowsWhatChangesInTheFolder) {
  look();
  put("a.wif", 3, "Changed to another length");
  put("c.wif", 4, "New");
  fs::remove(drafts() + "/within/b.wif");
  base::write_file_atomically(drafts() + "/d.dtx", "nonsense");
  const FolderIndex now = look();
  EXPECT_EQ(now.read, 3U);
  ASSERT_EQ(now.entries->size(), 3U);
  EXPECT_EQ((*now.entries)[0].shafts, 3);
  EXPECT_EQ((*now.entries)[1].title, "New");
  EXPECT_FALSE((*now.entries)[2].readable);
  EXPECT_EQ(look().read, 0U) << "the unreadable one is not read again either";
}

TEST_F(FolderIndexTest, SaysWhatIsKnownBeforeItLooks) {
  EXPECT_EQ(known_drafts(drafts(), cache()), nullptr);
  look();
  std::vector<size_t> sizes;
  put("c.wif", 4, "New");
  look_through(drafts(), cache(), {}, [&](const std::shared_ptr<const Entries>& e) { sizes.push_back(e->size()); });
  EXPECT_EQ(sizes, (std::vector<size_t>{2}));
}

TEST_F(FolderIndexTest, AStopLosesNothingThatWasKnown) {
  look();
  std::stop_source stop;
  stop.request_stop();
  const FolderIndex stopped = look_through(drafts(), cache(), base::TaskProgress(stop.get_token()));
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.entries->size(), 2U);
  EXPECT_EQ(look().read, 0U);
}

TEST_F(FolderIndexTest, ADamagedIndexIsMadeAnew) {
  look();
  base::write_file_atomically(index_file_of(drafts(), cache()), "weftlight drafts 1\nhalf a li");
  EXPECT_EQ(look().read, 2U);
  EXPECT_EQ(look().read, 0U);
}

TEST_F(FolderIndexTest, WorksWithoutACache) {
  EXPECT_EQ(look_through(drafts(), "").read, 2U);
  EXPECT_FALSE(fs::exists(cache()));
  EXPECT_TRUE(look_through((dir_ / "nowhere").string(), "").entries->empty());
}

}  // namespace
}  // namespace weftlight::collection
