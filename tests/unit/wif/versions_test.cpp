// Versions in a file: there again when it is opened, small, harmless to other programs, and to the byte where
// untouched.

#include "design/versions.h"

#include <gtest/gtest.h>

#include "design/edits.h"
#include "lines.h"
#include "wif/wif.h"

namespace weftlight::wif {

using design::Design, design::at_version, design::kMaxVersions, design::with_renamed_version, design::with_tieup,
    design::with_version, design::without_version;

namespace {

size_t count_of(const std::string& bytes, std::string_view words) {
  size_t count = 0;
  for (size_t at = bytes.find(words); at != std::string::npos; at = bytes.find(words, at + 1)) ++count;
  return count;
}

/// The fixture, a colourway of it, and a version with another tie-up; the draft is the last one.
Design with_three(Design d) {
  d = with_version(std::move(d), "As drawn");
  d.draft.palette[1] = {0.123f, 0.5f, 0.25f};
  d = with_version(std::move(d), "Gr\xC3\xBCn; nr = 2");
  d = with_tieup(std::move(d), 0, 3, true);
  return with_version(std::move(d), "Other tie-up");
}

TEST(versions, are_there_again_when_the_file_is_opened_again) {
  const WifFile file = opened(fixture("twill.wif"));
  const Design now = with_three(file.design);
  ASSERT_EQ(now.versions.size(), 3u);
  for (const std::string& bytes : {write_wif(file, now), write_new_wif(now)}) {
    const WifFile again = opened(bytes);
    EXPECT_TRUE(again.design == now) << bytes;
    EXPECT_EQ(at_version(again.design, again.design.versions[0]).draft, file.design.draft);
    EXPECT_EQ(write_wif(again, again.design), bytes) << "an unedited file keeps its bytes";
  }
}

TEST(versions, leave_every_other_line_as_it_was) {
  const WifFile file = opened(fixture("untidy.wif"));
  const Design now = with_version(file.design, "One");
  const std::string bytes = write_wif(file, now);
  EXPECT_TRUE(opened(bytes).design == now);
  EXPECT_TRUE(line_diff(file.bytes, bytes).removed.empty());
  Design none = opened(bytes).design;
  none.versions.clear();
  EXPECT_EQ(write_wif(opened(bytes), none).find("VERSION "), std::string::npos);
  EXPECT_EQ(write_plain_wif(now).find("PRIVATE"), std::string::npos);
}

TEST(versions, are_private_sections_that_other_programs_skip) {
  const WifFile file = opened(fixture("twill.wif"));
  const std::string bytes = write_wif(file, with_three(file.design));
  EXPECT_NE(bytes.find("PRIVATE WEFTLIGHT VERSION 2=true"), std::string::npos) << "listed in [CONTENTS]";
  for (size_t at = bytes.find("\n["); at != std::string::npos; at = bytes.find("\n[", at + 1)) {
    const std::string heading = bytes.substr(at + 2, bytes.find(']', at) - at - 2);
    EXPECT_TRUE(heading.find("VERSION") == std::string::npos || heading.starts_with("PRIVATE ")) << heading;
  }
}

TEST(versions, write_what_they_share_once) {
  const WifFile file = opened(fixture("twill.wif"));
  const std::string bytes = write_wif(file, with_three(file.design));
  EXPECT_EQ(count_of(bytes, "[PRIVATE WEFTLIGHT VERSION 1 THREADING]"), 1u);
  EXPECT_EQ(count_of(bytes, "VERSION 2 THREADING"), 0u);
  EXPECT_EQ(count_of(bytes, "THREADING As In Version=1"), 2u);
  EXPECT_EQ(count_of(bytes, "COLOR TABLE As In Version=2"), 1u) << "the third has the colours of the second";
  EXPECT_EQ(count_of(bytes, "[PRIVATE WEFTLIGHT VERSION 2 "), 2u) << "its colours, and the exact one";
}

TEST(versions, can_be_renamed_and_deleted_in_the_file) {
  const WifFile file = opened(fixture("twill.wif"));
  const WifFile kept = opened(write_wif(file, with_three(file.design)));
  const Design renamed = with_renamed_version(kept.design, 1, "Red");
  const std::string bytes = write_wif(kept, renamed);
  EXPECT_TRUE(opened(bytes).design == renamed);
  EXPECT_EQ(line_diff(kept.bytes, bytes).added.size(), 1u);
  const Design fewer = without_version(kept.design, 0);
  EXPECT_TRUE(opened(write_wif(kept, fewer)).design == fewer) << "what the others shared with it is written with them";
}

TEST(versions, stay_as_they_were_if_another_program_edits_the_draft) {
  const WifFile file = opened(fixture("twill.wif"));
  std::string bytes = write_wif(file, with_three(file.design));
  const size_t at = bytes.find("\r\n[THREADING]\r\n1=1");
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, 18, "\r\n[THREADING]\r\n1=4");
  const Design read = opened(bytes).design;
  EXPECT_TRUE(read.draft.threading.get(0, 3));
  EXPECT_EQ(read.versions[0].design->draft.threading, file.design.draft.threading);
}

TEST(versions, that_are_broken_are_left_out_with_a_remark) {
  const WifFile file = opened(fixture("twill.wif"));
  std::string bytes = write_wif(file, with_three(file.design));
  const std::string cut = "Threads=8";
  const size_t at = bytes.find(cut, bytes.find("[PRIVATE WEFTLIGHT VERSION 1 WARP]"));
  bytes.replace(at, cut.size(), "Threads=999999999");
  const WifRead read = read_wif(bytes);
  ASSERT_TRUE(read.file);
  EXPECT_TRUE(says(read, 0, "version 1") || !read.diagnostics.empty());
  EXPECT_LT(read.file->design.versions.size(), 3u);
  EXPECT_EQ(write_wif(*read.file, read.file->design), bytes);
}

TEST(versions, with_odd_lines_can_be_changed) {
  const WifFile file = opened(fixture("twill.wif"));
  std::string bytes = write_wif(file, with_version(file.design, "One"));
  bytes += "[PRIVATE WEFTLIGHT VERSION 7]\r\nname=Seven\r\nno key\r\n";
  for (const char* name : {"THREADING", "WARP", "WEFT", "TREADLING"}) bytes.append(name).append(" As In Version=1\r\n");
  bytes += "[PRIVATE WEFTLIGHT VERSION 1 PRIVATE WEFTLIGHT VERSION 2]\r\n1=1\r\n";
  const WifFile odd = opened(bytes);
  ASSERT_EQ(odd.design.versions.size(), 2u);
  EXPECT_EQ(odd.design.versions[1].name, "Seven");
  for (const Design& now : {with_version(odd.design, "Two"), without_version(odd.design, 1), file.design})
    EXPECT_TRUE(opened(write_wif(odd, now)).design == now);
}

TEST(versions, of_a_small_file_take_no_endless_memory) {
  // Each version refers to the first, which states the largest grids there are.
  std::string bytes = fixture("twill.wif");
  bytes +=
      "\r\n[PRIVATE WEFTLIGHT VERSION 1]\r\nName=a\r\n"
      "[PRIVATE WEFTLIGHT VERSION 1 WEAVING]\r\nShafts=4096\r\nTreadles=4096\r\n"
      "[PRIVATE WEFTLIGHT VERSION 1 WARP]\r\nThreads=9000\r\n"
      "[PRIVATE WEFTLIGHT VERSION 1 WEFT]\r\nThreads=40000\r\n"
      "[PRIVATE WEFTLIGHT VERSION 1 THREADING]\r\n1=1\r\n"
      "[PRIVATE WEFTLIGHT VERSION 1 PRIVATE WEFTLIGHT VERSION 1 THREADING]\r\n1=1\r\n";
  for (size_t i = 2; i <= kMaxVersions; ++i) {
    bytes.append("[PRIVATE WEFTLIGHT VERSION ").append(std::to_string(i)).append("]\r\n");
    for (const char* name : {"WEAVING", "WARP", "WEFT", "THREADING"}) bytes.append(name).append(" As In Version=1\r\n");
  }
  const WifRead read = read_wif(bytes);
  ASSERT_TRUE(read.file);
  int64_t cells = 0;
  for (const design::Version& version : read.file->design.versions) cells += design::grid_cells(version.design->draft);
  EXPECT_LE(cells, design::kMaxVersionCells);
  EXPECT_FALSE(read.diagnostics.empty());
}

}  // namespace
}  // namespace weftlight::wif
