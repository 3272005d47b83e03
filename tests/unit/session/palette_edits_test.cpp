// Deleting colours and yarns of the draft in the window's words; the active ones keep their place by what they are.

#include <gtest/gtest.h>

#include "session/editing/palette_deletion.h"

namespace weftlight::session {

using design::ColorOrder, design::with_sorted_colors;
using draft::blank_draft;

namespace {

Design three_colors() {
  Design d;
  d.draft = blank_draft(4, 3, 2, 2);
  d.draft.palette = {{0, 0, 0}, {0.9f, 0.9f, 0.9f}, {1, 1, 1}};
  d.draft.warp.color = {1, 1, 1, 0}, d.draft.weft.color = {1, 0, 0};
  d.yarns.resize(2);
  d.yarns[1].name = "Silk";
  return d;
}

TEST(PaletteEditWords, SayWhatTakesThePlace) {
  const Design d = three_colors();
  const Deletion color = color_deletion(d, 1);
  EXPECT_EQ(color.heir, 2);
  EXPECT_EQ(color_deletion_words(color),
            "It is used by 3 ends and 1 pick. Colour 3, the closest one, takes its place.");
  EXPECT_FALSE(color_deletion(d, 2).is_used());
  EXPECT_EQ(yarn_deletion_words(d, yarn_deletion(d, 0)),
            "It is used by 4 ends and 3 picks. Silk, the most similar one, takes its place.");
  EXPECT_EQ(delete_yarn_edit(d, yarn_deletion(d, 1)).label, "Delete yarn Silk");
  EXPECT_EQ(delete_color_edit(color).apply(d).draft.warp.color, (std::vector<int>{1, 1, 1, 0}));
}

TEST(PaletteEditWords, TheActiveColourIsTheSameAfterSorting) {
  Document document(three_colors());
  DrawingState drawing;
  drawing.color = 2, drawing.yarn = 1;
  keeping_active(drawing, document, [&] {
    document.commit({"Sort", [](Design d) { return with_sorted_colors(std::move(d), ColorOrder::kLightness); }}, 1);
  });
  EXPECT_EQ(drawing.color, 0) << "white is first";
  EXPECT_EQ(drawing.yarn, 1);
}

}  // namespace
}  // namespace weftlight::session
