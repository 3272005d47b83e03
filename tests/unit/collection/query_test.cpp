#include "collection/query.h"

#include <gtest/gtest.h>

namespace weftlight::collection {
namespace {

DraftEntry draft(const char* path, const char* title, int shafts, int treadles, WeaveFamily family, uint32_t colours) {
  DraftEntry e;
  e.path = path, e.title = title;
  e.readable = true;
  e.shafts = shafts, e.treadles = treadles, e.ends = 40;
  e.family = family, e.colours = colours;
  return with_search_text(e);
}

class Query : public testing::Test {
 protected:
  Query() {
    DraftEntry unreadable;
    unreadable.path = "/d/broken twill.wif";
    entries_ = {draft("/d/a.wif", "Blue Scarf", 8, 10, WeaveFamily::kTwill, 0b011),
                draft("/d/b.wif", "Towel", 4, 0, WeaveFamily::kPlain, 0b001),
                draft("/d/scarves/c.wif", "", 4, 6, WeaveFamily::kTwill, 0b110), with_search_text(unreadable)};
  }
  std::vector<int> found(const DraftQuery& query) const { return found_drafts(entries_, query); }
  std::vector<DraftEntry> entries_;
};

TEST_F(Query, FindsByEveryWordInTitleAuthorOrPath) {
  EXPECT_EQ(found({}), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(found({.words = "SCAR"}), (std::vector<int>{0, 2}));
  EXPECT_EQ(found({.words = "  scarf blue "}), (std::vector<int>{0}));
  EXPECT_EQ(found({.words = "twill"}), (std::vector<int>{3})) << "an unreadable file has only its path";
  EXPECT_TRUE(found({.words = "scarf towel"}).empty());
}

TEST_F(Query, FindsByWhatTheDraftIs) {
  EXPECT_EQ(found({.shafts = {4, 4}}), (std::vector<int>{1, 2}));
  EXPECT_EQ(found({.shafts = {5, 0}}), (std::vector<int>{0}));
  EXPECT_EQ(found({.treadles = {1, 8}}), (std::vector<int>{2}));
  EXPECT_EQ(found({.family = WeaveFamily::kTwill}), (std::vector<int>{0, 2}));
  EXPECT_EQ(found({.colours = 0b011}), (std::vector<int>{0})) << "all of the colours";
  EXPECT_EQ(found({.words = "wif", .shafts = {0, 4}, .family = WeaveFamily::kTwill}), (std::vector<int>{2}));
}

TEST(QuerySpan, IsWrittenAsANumberOrARange) {
  EXPECT_EQ(span_from("8"), (Span{8, 8}));
  EXPECT_EQ(span_from("4-8"), (Span{4, 8}));
  EXPECT_EQ(span_from("-16"), (Span{0, 16}));
  EXPECT_EQ(span_from("5-"), (Span{5, 0}));
  for (const char* bad : {"", "-", "0", "8-4", "four", "4-8-9", "-0", "99999999999"})
    EXPECT_FALSE(span_from(bad)) << bad;
}

}  // namespace
}  // namespace weftlight::collection
