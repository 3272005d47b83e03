#include "base/utf8.h"

#include <gtest/gtest.h>

namespace weftlight::base {
namespace {

TEST(Utf8, valid_text_is_unchanged) {
  for (const std::string text : {"", "plain", "caf\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\xA7\xB5"}) {
    EXPECT_TRUE(is_utf8(text));
    EXPECT_EQ(as_utf8(text), text);
  }
}

TEST(Utf8, invalid_bytes_are_replaced_one_by_one) {
  const std::string gone = "\xEF\xBF\xBD";
  EXPECT_EQ(as_utf8("caf\xE9.wif"), "caf" + gone + ".wif");
  EXPECT_EQ(as_utf8("\xE2\x82"), gone + gone);             // cut short
  EXPECT_EQ(as_utf8("\xC0\xAF"), gone + gone);             // overlong
  EXPECT_EQ(as_utf8("\xED\xA0\x80"), gone + gone + gone);  // half of a pair
  EXPECT_EQ(as_utf8("\xF5\x80"), gone + gone);
  for (int byte = 0x80; byte < 0x100; ++byte) EXPECT_TRUE(is_utf8(as_utf8(std::string(3, static_cast<char>(byte)))));
}

TEST(Utf8, latin_letters_lose_their_marks) {
  EXPECT_EQ(plain_latin(0xF6), "o");
  EXPECT_EQ(plain_latin(0x141), "L");
  EXPECT_EQ(plain_latin(0x17E), "z");
  EXPECT_EQ(plain_latin(0xDF), "ss");
  EXPECT_EQ(plain_latin(0x153), "oe");
  for (const uint32_t code : {0x0u, 0x41u, 0xBFu, 0xD7u, 0xF7u, 0x180u, 0x7D9Eu})
    EXPECT_EQ(plain_latin(code), "") << code;
}

TEST(Utf8, is_cut_between_characters) {
  const std::string text = "a\xC3\xA9\xE2\x82\xAC\xF0\x9F\xA7\xB5";
  for (size_t bytes = 0; bytes <= text.size() + 1; ++bytes) {
    const std::string_view head = cut_utf8(text, bytes);
    EXPECT_LE(head.size(), bytes);
    EXPECT_GT(head.size() + 4, std::min(bytes, text.size()));
    EXPECT_TRUE(is_utf8(head)) << bytes;
  }
  EXPECT_EQ(cut_utf8(std::string(9, '\x80'), 5).size(), 5u);
}

}  // namespace
}  // namespace weftlight::base
