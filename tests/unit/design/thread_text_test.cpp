#include "design/thread_text.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"

namespace weftlight::design {

using base::problem_of;
using draft::System, draft::blank_draft, draft::is_consistent, draft::kFromYarn;

namespace {

Design striped() {
  Design d;
  d.draft = blank_draft(4, 6, 2, 2);
  d.draft.palette = {{0, 0, 0}, {1, 1, 1}, {16 / 255.0f, 53 / 255.0f, 122 / 255.0f}};
  d.draft.warp.color = {2, 0, 0, 1};
  d.draft.warp.thickness_mm = {0.5f, kFromYarn, 1.25f, kFromYarn};
  return d;
}

constexpr int kAll[] = {0, 1, 2, 3, 4, 5};

TEST(ThreadText, ColoursArePastedAloneAndRepeated) {
  const Design d = striped();
  const std::string text = color_text(d.draft, System::kWarp, std::vector<int>{0, 1, 3});
  EXPECT_EQ(text, "weftlight colours: #10357A #000000 #FFFFFF\n");
  const base::Result<ThreadProperties> read = read_thread_properties(text);
  ASSERT_TRUE(read) << problem_of(read);
  const Design pasted = with_properties(d, System::kWeft, kAll, *read);
  EXPECT_EQ(pasted.draft.weft.color, (std::vector<int>{2, 0, 1, 2, 0, 1}));
  EXPECT_EQ(pasted.draft.weft.thickness_mm, d.draft.weft.thickness_mm) << "nothing but the colours";
  EXPECT_EQ(pasted.draft.palette, d.draft.palette);
}

TEST(ThreadText, AMissingColourIsAddedToThePalette) {
  Design other;
  other.draft = blank_draft(4, 4, 2, 2);
  const base::Result<ThreadProperties> read = read_thread_properties(color_text(striped().draft, System::kWarp, kAll));
  const Design pasted = with_properties(other, System::kWarp, std::vector<int>{0, 1}, *read);
  ASSERT_EQ(pasted.draft.palette.size(), 3u);
  EXPECT_EQ(pasted.draft.palette[2], striped().draft.palette[2]);
  EXPECT_EQ(pasted.draft.warp.color, (std::vector<int>{2, 0, 0, 0}));
  EXPECT_TRUE(is_consistent(pasted.draft));
}

TEST(ThreadText, ThicknessesComeBackExactly) {
  const Design d = striped();
  const std::string text = thickness_text(d.draft, System::kWarp, kAll);
  EXPECT_EQ(text, "weftlight thickness: 0.5 - 1.25 -\n");
  const Design pasted = with_properties(d, System::kWeft, std::vector<int>{0, 1, 2, 3}, *read_thread_properties(text));
  EXPECT_EQ(pasted.draft.weft.thickness_mm,
            (std::vector<float>{0.5f, kFromYarn, 1.25f, kFromYarn, kFromYarn, kFromYarn}));
  EXPECT_EQ(pasted.draft.weft.color, d.draft.weft.color);
}

TEST(ThreadText, OtherTextIsRejectedWithAReason) {
  for (const char* text : {"", "1010\n0101", "weftlight colours:", "weftlight colours: #12345",
                           "weftlight colours: #12345G", "weftlight thickness: 0.5 thick", "weftlight thickness: -3",
                           "weftlight thickness: nan", "weftlight thickness: 1e30", "weftlight cells: threading\n#."}) {
    const base::Result<ThreadProperties> read = read_thread_properties(text);
    EXPECT_FALSE(read) << text;
    EXPECT_NE(problem_of(read).find("no colours or thicknesses"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace weftlight::design
