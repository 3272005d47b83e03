// What readers collect about a file, without one.

#include <gtest/gtest.h>

#include "wif/foreign.h"
#include "wif/parse.h"

namespace weftlight::wif {
namespace {

TEST(diagnostics, words_of_a_file_stand_between_single_quotes) { EXPECT_EQ(quoted("3/1 twill"), "'3/1 twill'"); }

TEST(diagnostics, a_collection_begins_anew_once_it_is_released) {
  Diagnostics found;
  found.warn(6, "width", "first", "mend it");
  found.warn(8, "width", "again", "mend it");
  const std::vector<Diagnostic> merged = found.release();
  ASSERT_EQ(merged.size(), 1u);
  EXPECT_EQ(merged[0].text, "first (and 1 more like it: line 9)");
  found.warn(2, "width", "another file", "mend it");
  const std::vector<Diagnostic> next = found.release();
  ASSERT_EQ(next.size(), 1u);
  EXPECT_EQ(next[0].text, "another file");
  EXPECT_EQ(next[0].line, 3);
}

}  // namespace
}  // namespace weftlight::wif
