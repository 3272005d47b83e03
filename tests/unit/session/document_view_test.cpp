#include "session/editing/document_view.h"

#include <gtest/gtest.h>

namespace weftlight::session {

using draft::System;

namespace {

TEST(DraftView, ScrollsAsLittleAsNeededToShowACell) {
  DraftView v;
  v.seen_ends = v.seen_picks = 10;
  v.seen_shafts = v.seen_treadles = 4;
  bring_into_sight(v, GridId::kThreading, {5, 1});
  EXPECT_EQ(v.scroll_end, 0) << "it was in sight";
  bring_into_sight(v, GridId::kThreading, {20, 6});
  EXPECT_EQ(v.scroll_end, 12) << "with its neighbour";
  EXPECT_EQ(v.scroll_shaft, 4);
  EXPECT_EQ(v.scroll_pick, 0);
  bring_into_sight(v, GridId::kTreadling, {2, 30});
  EXPECT_EQ(v.scroll_pick, 22);
  EXPECT_EQ(v.scroll_treadle, 0);
  bring_into_sight(v, GridId::kDrawdown, {3, 40});
  EXPECT_EQ(v.scroll_end, 2);
}

TEST(DraftView, ATenthOfThePageStaysVisible) {
  DraftView w;
  w.seen_ends = 40;
  w.seen_picks = 100;
  page_picks(w, 1);
  EXPECT_EQ(w.scroll_pick, 90);
  page_picks(w, -1);
  EXPECT_EQ(w.scroll_pick, 0);
  page_ends(w, 2);
  EXPECT_EQ(w.scroll_end, 72);
}

TEST(DraftView, ADraftThatHasGrownIsFittedAgainIfItWasBefore) {
  DraftView v;
  v.pitch = v.fitted_pitch = 12;
  fit_grown(v);
  EXPECT_EQ(v.pitch, 12) << "it has not grown";
  v.has_grown = true;
  fit_grown(v);
  EXPECT_EQ(v.pitch, 0);
  EXPECT_FALSE(v.has_grown);
  v.pitch = zoomed_pitch(v.fitted_pitch, 1);
  v.has_grown = true;
  fit_grown(v);
  EXPECT_EQ(v.pitch, 14) << "zoomed by hand";
  EXPECT_FALSE(v.has_grown);
}

TEST(DraftView, ScrollsAThreadToTheMiddle) {
  DraftView w;
  w.seen_ends = 41;
  w.seen_picks = 21;
  scroll_to(w, System::kWarp, 100);
  EXPECT_EQ(w.scroll_end, 80);
  scroll_to(w, System::kWeft, 100);
  EXPECT_EQ(w.scroll_pick, 90);
}

}  // namespace
}  // namespace weftlight::session
