#include "session/document_view.h"

#include <gtest/gtest.h>

namespace weftlight::session {
namespace {

TEST(DocumentView, PagesKeepATenthInSight) {
  DocumentView w;
  w.seen_ends = 40;
  w.seen_picks = 100;
  page_picks(w, 1);
  EXPECT_EQ(w.scroll_pick, 90);
  page_picks(w, -1);
  EXPECT_EQ(w.scroll_pick, 0);
  page_ends(w, 2);
  EXPECT_EQ(w.scroll_end, 72);
}

TEST(DocumentView, AThreadIsBroughtToTheMiddle) {
  DocumentView w;
  w.seen_ends = 41;
  w.seen_picks = 21;
  scroll_to(w, System::kWarp, 100);
  EXPECT_EQ(w.scroll_end, 80);
  scroll_to(w, System::kWeft, 100);
  EXPECT_EQ(w.scroll_pick, 90);
}

}  // namespace
}  // namespace weftlight::session
