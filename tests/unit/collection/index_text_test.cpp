#include "collection/index_text.h"

#include <gtest/gtest.h>

namespace weftlight::collection {
namespace {

DraftEntry some() {
  DraftEntry e;
  e.path = "/home/anna/drafts/a\tb\nc\\d.wif";
  e.size = 1234567890123, e.modified_ns = -5;
  e.readable = true;
  e.ends = 120, e.picks = 96, e.shafts = 8, e.treadles = 10;
  e.family = WeaveFamily::kSatin;
  e.colours = 0x405;
  e.title = "Gr\xC3\xBCner Schal \\n", e.author = "Anna";
  return with_search_text(e);
}

TEST(IndexText, GivesBackWhatWasWritten) {
  DraftEntry unreadable;
  unreadable.path = "/home/\xFF\xFE.wif";
  const std::vector<DraftEntry> entries{some(), with_search_text(unreadable)};
  const auto read = entries_from(index_text(entries));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, entries);
  EXPECT_TRUE(entries_from(index_text({}))->empty());
}

TEST(IndexText, ADamagedOneIsMadeAnew) {
  const std::string good = index_text({some(), some()});
  for (size_t cut = 0; cut + 1 < good.size(); ++cut) {
    const auto read = entries_from(good.substr(0, cut));
    EXPECT_TRUE(!read || read->size() < 2) << cut;
  }
  for (const char* bad : {"", "weftlight drafts 0\n", "x", "weftlight drafts 1\na\t1\n"})
    EXPECT_FALSE(entries_from(bad));
  std::string family = good;
  family.replace(family.find("\t4\t1029\t"), 3, "\t99\t");
  EXPECT_FALSE(entries_from(family)) << "a family that there is not";
}

}  // namespace
}  // namespace weftlight::collection
