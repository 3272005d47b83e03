// Versions in a document: one step of undo each, and in the journal's text.

#include <gtest/gtest.h>

#include "design/edits.h"
#include "session/document/document.h"
#include "session/editing/version_edits.h"
#include "weaves/weaves.h"
#include "wif/wif.h"

namespace weftlight::session {

using design::with_thread_color;
using draft::System;
using weaves::Lean, weaves::twill;

namespace {

Edit weft_of(int color) {
  return {"weft", [color](Design d) {
            for (int pick = 0; pick < d.draft.picks(); ++pick)
              d = with_thread_color(std::move(d), System::kWeft, pick, color);
            return d;
          }};
}

TEST(VersionEdits, AreOneStepOfUndoEach) {
  Document document(twill({2, 2}, Lean::kRight, {16, 16}));
  ASSERT_TRUE(document.commit(keep_version_edit("Light"), 1));
  ASSERT_TRUE(document.commit(weft_of(0), 2));
  ASSERT_TRUE(document.commit(keep_version_edit("Dark"), 3));
  EXPECT_EQ(version_words(document.now(), document.now().versions[0]), "other colours");
  EXPECT_FALSE(go_to_version_edit(document.now(), document.now().versions[1])) << "it is that already";
  const auto dark = document.snapshot();
  const MaybeEdit back = go_to_version_edit(document.now(), document.now().versions[0]);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->label, "Restore version " + document.now().versions[0].name);
  ASSERT_TRUE(document.commit(*back, 4));
  EXPECT_EQ(document.now().draft.weft.color[0], 1);
  EXPECT_EQ(next_version(document.now(), 1)->name, "Dark");
  EXPECT_EQ(next_version(document.now(), -1)->name, "Dark") << "they go round";
  document.undo();
  EXPECT_EQ(document.now(), *dark);
  ASSERT_TRUE(document.commit(delete_version_edit(document.now(), 0), 5));
  ASSERT_TRUE(document.commit(rename_version_edit(0, "Night"), 6));
  ASSERT_EQ(document.now().versions.size(), 1u);
  EXPECT_EQ(document.now().versions[0].name, "Night");
  EXPECT_FALSE(document.commit(keep_version_edit(" "), 7));
  EXPECT_NE(keep_version_edit(" ").why(document.now()), "");
  // The journal holds what a save would write.
  const wif::WifRead read = wif::read_wif(wif::write_new_wif(document.now()));
  ASSERT_TRUE(read.file);
  EXPECT_EQ(read.file->design, document.now());
}

}  // namespace
}  // namespace weftlight::session
