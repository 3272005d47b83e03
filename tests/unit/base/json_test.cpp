// JSON is measured before its values take memory.

#include "base/json.h"

#include <gtest/gtest.h>

#include <string>

#include "../memory_taken.h"

namespace weftlight::base {
namespace {

std::string repeated(const std::string& what, size_t times) {
  std::string out;
  for (size_t i = 0; i < times; ++i) out += what;
  return out;
}

std::string kind_of(const std::string& text) {
  const nlohmann::json read = read_json(text);
  return read.is_discarded() ? "nothing" : read.type_name();
}

TEST(Json, MeasuresNestingAndValues) {
  EXPECT_EQ(json_extent("").depth, 0);
  EXPECT_EQ(json_extent(R"({"a": [1, 2, {"b": 3}], "c": "[[[,\"["})").depth, 3);
  EXPECT_GE(json_extent("[1, 2, 3]").values, 3u);
  EXPECT_EQ(json_extent("\"[[\\").depth, 0) << "a text without end";
  EXPECT_EQ(json_extent("]]]][").depth, 0) << "closed before it is opened: the parser refuses it";
}

TEST(Json, ReadsWhatIsNeitherDeepNorLarge) {
  EXPECT_EQ(read_json(R"({"a": [1, "[["]})")["a"][1], "[[");
  EXPECT_EQ(kind_of(""), "nothing");
  EXPECT_EQ(kind_of("[1, 2"), "nothing");
  const auto nested = [](size_t deep) { return repeated("[", deep) + repeated("]", deep); };
  EXPECT_EQ(kind_of(nested(kMaxJsonDepth)), "array");
  EXPECT_EQ(kind_of(nested(kMaxJsonDepth + 1)), "nothing");
  EXPECT_EQ(kind_of("[0" + repeated(",0", kMaxJsonValues - 3) + "]"), "array");
  EXPECT_EQ(kind_of("[0" + repeated(",0", kMaxJsonValues) + "]"), "nothing");
}

TEST(Json, BombsTakeNoMemory) {
  const size_t most = size_t{16} << 20;  // the longest file of JSON that is read
  for (const char* part : {"[", "{\"\":", "[[],", "{},", "{\"a\":[0]},"}) {
    const std::string lists = repeated(part, most / std::string(part).size());
    for (const std::string& text : {lists, std::string("[").append(lists).append("0]")})
      expect_harmless([&text] { return kind_of(text); }, "nothing");
  }
  // What is still read.
  std::string members = "{";
  for (size_t i = 0; i < kMaxJsonValues / 2 - 2; ++i) members.append(1, '"').append(std::to_string(i)).append("\":{},");
  members += "\"\":0}";
  expect_harmless([&members] { return kind_of(members); }, "object");
}

}  // namespace
}  // namespace weftlight::base
