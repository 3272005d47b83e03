// Files hold these hashes: they are the same on every machine and in every version.

#include "base/hash.h"

#include <gtest/gtest.h>

namespace weftlight::base {
namespace {

// From the authors' own test: Noll, http://www.isthe.com/chongo/src/fnv/test_fnv.c.
TEST(Hash, is_the_published_one) {
  EXPECT_EQ(content_hash(""), 0xcbf29ce484222325u);
  EXPECT_EQ(content_hash("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(content_hash("foobar"), 0x85944171f73967e8u);
}

TEST(Hash, of_pieces_is_that_of_the_whole) {
  EXPECT_EQ(content_hash("bar", content_hash("foo")), content_hash("foobar"));
}

}  // namespace
}  // namespace weftlight::base
