// --live-export and --ui-map replace their own files and no others.

#include "session/files/own_output.h"

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
  EXPECT_EQ(live().rejected_edit(draft), "");
  for (const char* bytes : {"one", "two", "three"}) {
    LiveExport again = live();
    EXPECT_EQ(again.rejected_edit(draft), "") << bytes;
    EXPECT_EQ(again.write(bytes), "");
    EXPECT_EQ(again.write(std::string(bytes) + " more"), "");
  }
  EXPECT_EQ(live().rejected_edit(""), "");
}

TEST_F(OwnOutput, LiveExportRefusesForeignFiles) {
  written("live.wif", "somebody's draft");
  EXPECT_NE(live().rejected_edit(""), "");
  fs::remove(path("live.wif"));
  EXPECT_EQ(live().write("mine"), "");
  EXPECT_EQ(live().rejected_edit(""), "");
  written("live.wif", "edited by another program since");
  EXPECT_NE(live().rejected_edit(""), "");
}

TEST_F(OwnOutput, LiveExportRefusesTheDraftUnderAnyPath) {
  const std::string draft = written("draft.wif", "a draft");
  fs::create_symlink(draft, path("live.wif"));
  EXPECT_NE(live().rejected_edit(draft), "");
  EXPECT_NE(LiveExport(path("./draft.wif"), path("state")).rejected_edit(draft), "");
  EXPECT_NE(LiveExport(dir_.string(), path("state")).rejected_edit(draft), "") << "a folder";
}

TEST_F(OwnOutput, LiveExportAcceptsAnEmptyFileAndACopyOfTheDraft) {
  const std::string draft = written("draft.wif", "a draft");
  written("live.wif", "");
  EXPECT_EQ(live().rejected_edit(draft), "");
  written("live.wif", "a draft");
  EXPECT_EQ(live().rejected_edit(draft), "");
}

TEST_F(OwnOutput, LiveExportRecognisesItsFileAfterACrash) {
  LiveExport one = live();
  EXPECT_EQ(one.write("first"), "");
  // The record is written before the file: as if killed in between.
  fs::rename(path("live.wif"), path("kept.wif"));
  fs::create_directory(path("live.wif"));
  EXPECT_NE(one.write("second"), "");
  fs::remove(path("live.wif"));
  fs::rename(path("kept.wif"), path("live.wif"));
  EXPECT_EQ(live().rejected_edit(""), "");
}

TEST_F(OwnOutput, UiMapIsRecognisedByItsContent) {
  const std::string draft = written("draft.wif", "[WIF]\n");
  EXPECT_EQ(ui_map_refusal(path("map.json"), draft), "");
  written("map.json", R"({"frame": 3, "controls": [], "grids": []})");
  EXPECT_EQ(ui_map_refusal(path("map.json"), draft), "");
  for (const char* other : {"{}", "not JSON", R"({"frame": 3})", "[1, 2]", "\xff\xfe"}) {
    written("map.json", other);
    EXPECT_NE(ui_map_refusal(path("map.json"), draft), "") << other;
  }
  EXPECT_NE(ui_map_refusal(draft, draft), "");
  EXPECT_NE(ui_map_refusal(dir_.string(), draft), "");
}

}  // namespace
}  // namespace weftlight::session
