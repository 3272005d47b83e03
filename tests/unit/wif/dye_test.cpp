// Colours along the threads of a yarn in a file: saved, and there again.

#include <gtest/gtest.h>

#include "lines.h"
#include "wif/wif.h"

namespace weftlight::wif {

using design::Design, design::Dye, design::Yarn;

namespace {

Yarn painted() {
  Yarn yarn;
  yarn.name = "Painted";
  yarn.dye = {{{12, draft::Rgb{0, 0, 1}, true}, {8, {}, false}}, -3, 2};
  return yarn;
}

TEST(dye, is_there_again_when_the_file_is_opened_again) {
  const WifFile file = opened(fixture("twill.wif"));
  Design dyed = file.design;
  dyed.yarns.push_back(painted());
  dyed.draft.warp.yarn[1] = 1;
  for (const std::string& bytes : {write_wif(file, dyed), write_new_wif(dyed)}) {
    EXPECT_NE(bytes.find("2 Dye=12 #0000FF fades, 8 own"), std::string::npos) << bytes;
    EXPECT_TRUE(opened(bytes).design == dyed) << bytes;
  }
}

TEST(dye, is_changed_and_taken_out_in_its_lines) {
  const WifFile file = opened(fixture("twill.wif"));
  Design dyed = file.design;
  dyed.yarns.push_back(painted());
  const WifFile saved = opened(write_wif(file, dyed));
  dyed.yarns[1].dye.stretches[0].threads = 120;
  const LineDiff longer = line_diff(saved.bytes, write_wif(saved, dyed));
  EXPECT_EQ(longer.removed.size(), 1u) << "its first number alone is not the value";
  EXPECT_EQ(longer.added.size(), 1u);
  dyed.yarns[1].dye = {};
  const std::string bytes = write_wif(saved, dyed);
  EXPECT_TRUE(opened(bytes).design == dyed);
  const LineDiff without = line_diff(saved.bytes, bytes);
  EXPECT_EQ(without.removed.size(), 3u) << "stretches, shift and scatter";
  EXPECT_TRUE(without.added.empty());
}

TEST(dye, that_cannot_be_read_is_said_and_kept) {
  const WifFile file = opened(fixture("twill.wif"));
  Design dyed = file.design;
  dyed.yarns.push_back(painted());
  std::string bytes = write_wif(file, dyed);
  const std::string from = "2 Dye=12 #0000FF fades, 8 own";
  bytes.replace(bytes.find(from), from.size(), "2 Dye=twelve blue");
  const auto read = read_wif(bytes);
  ASSERT_TRUE(read.file);
  EXPECT_TRUE(read.file->design.yarns[1].dye.stretches.empty());
  EXPECT_FALSE(read.diagnostics.empty());
  Design now = read.file->design;
  now.title = "Another";
  EXPECT_NE(write_wif(*read.file, now).find("2 Dye=twelve blue"), std::string::npos);
}

}  // namespace
}  // namespace weftlight::wif
