// --live-export and --ui-map replace their own files and no others.

#include "session/files/own_output.h"

#include "../memory_taken.h"
#include "../scratch_fixture.h"

namespace weftlight::session {
namespace {

namespace fs = std::filesystem;

class OwnOutput : public ScratchTest {
 protected:
  LiveExport live() const { return {path("live.wif"), path("state")}; }
};

TEST_F(OwnOutput, LiveExportWritesNewFilesAndItsOwn) {
  const std::string draft = written("draft.wif", "a draft");
  EXPECT_TRUE(live().check({draft}));
  for (const char* bytes : {"one", "two", "three"}) {
    LiveExport again = live();
    EXPECT_TRUE(again.check({draft})) << bytes;
    EXPECT_TRUE(again.write(bytes));
    EXPECT_TRUE(again.write(std::string(bytes) + " more"));
  }
  EXPECT_TRUE(live().check({}));
}

TEST_F(OwnOutput, LiveExportRefusesForeignFiles) {
  written("live.wif", "somebody's draft");
  EXPECT_FALSE(live().check({}));
  fs::remove(path("live.wif"));
  EXPECT_TRUE(live().write("mine"));
  EXPECT_TRUE(live().check({}));
  written("live.wif", "edited by another program since");
  EXPECT_FALSE(live().check({}));
}

TEST_F(OwnOutput, LiveExportRefusesTheDraftUnderAnyPath) {
  const std::string draft = written("draft.wif", "a draft");
  fs::create_symlink(draft, path("live.wif"));
  EXPECT_FALSE(live().check({draft}));
  EXPECT_FALSE(LiveExport(path("./draft.wif"), path("state")).check({draft}));
  EXPECT_FALSE(LiveExport(dir_.string(), path("state")).check({draft})) << "a folder";
}

TEST_F(OwnOutput, NoneOfSeveralDraftsIsReplaced) {
  const std::string one = written("one.wif", "a draft"), two = written("live.wif", "another");
  EXPECT_FALSE(live().check({one, two}));
  EXPECT_FALSE(check_ui_map(two, {one, two}));
  fs::remove(two);
  EXPECT_TRUE(live().check({one}));
  written("live.wif", "a third");
  written("two.wif", "a third");
  EXPECT_TRUE(live().check({one, path("two.wif")})) << "a copy of the second";
}

TEST_F(OwnOutput, LiveExportAcceptsAnEmptyFileAndACopyOfTheDraft) {
  const std::string draft = written("draft.wif", "a draft");
  written("live.wif", "");
  EXPECT_TRUE(live().check({draft}));
  written("live.wif", "a draft");
  EXPECT_TRUE(live().check({draft}));
}

TEST_F(OwnOutput, LiveExportRecognisesItsFileAfterACrash) {
  LiveExport one = live();
  EXPECT_TRUE(one.write("first"));
  // The record is written before the file: as if killed in between.
  fs::rename(path("live.wif"), path("kept.wif"));
  fs::create_directory(path("live.wif"));
  EXPECT_FALSE(one.write("second"));
  fs::remove(path("live.wif"));
  fs::rename(path("kept.wif"), path("live.wif"));
  EXPECT_TRUE(live().check({}));
}

TEST_F(OwnOutput, UiMapIsRecognisedByItsContent) {
  const std::string draft = written("draft.wif", "[WIF]\n");
  EXPECT_TRUE(check_ui_map(path("map.json"), {draft}));
  written("map.json", R"({"frame": 3, "controls": [], "grids": []})");
  EXPECT_TRUE(check_ui_map(path("map.json"), {draft}));
  for (const char* other : {"{}", "not JSON", R"({"frame": 3})", "[1, 2]", "\xff\xfe"}) {
    written("map.json", other);
    EXPECT_FALSE(check_ui_map(path("map.json"), {draft})) << other;
  }
  EXPECT_FALSE(check_ui_map(draft, {draft}));
  EXPECT_FALSE(check_ui_map(dir_.string(), {draft}));
}

TEST_F(OwnOutput, UiMapsThatAreBombsAreRefused) {
  const auto says = [this](const std::string& text) {
    written("map.json", text);
    return [this] { return problem_of(check_ui_map(path("map.json"), {})); };
  };
  const std::string head = R"({"frame": 3, "controls": [], "grids": )";
  expect_harmless(says(head + std::string(5'000'000, '[')), "is not a map of the window");
  std::string blanks;
  blanks.resize(40'000'000, ' ');
  expect_harmless(says(head + "[]}" + blanks), "is not a map of the window");
}

}  // namespace
}  // namespace weftlight::session
