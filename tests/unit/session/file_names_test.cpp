#include "session/files/file_names.h"

#include <gtest/gtest.h>

namespace weftlight::session {
namespace {

TEST(FileNames, ADraftEndsInWif) {
  EXPECT_EQ(with_file_ending("/home/a/scarf", ".wif"), "/home/a/scarf.wif");
  EXPECT_EQ(with_file_ending("scarf.2026", ".wif"), "scarf.2026.wif");
  EXPECT_EQ(with_file_ending("scarf.wif", ".wif"), "scarf.wif");
  EXPECT_EQ(with_file_ending("SCARF.WIF", ".wif"), "SCARF.WIF");
  EXPECT_EQ(with_file_ending("scarf.wifw", ".wif"), "scarf.wifw");
  EXPECT_EQ(with_file_ending("scarf.wifw", ".pdf"), "scarf.wifw.pdf");
  EXPECT_EQ(with_file_ending(".hidden", ".wif"), ".hidden.wif");
  EXPECT_EQ(with_file_ending("", ".wif"), "") << "no name is no name";
}

}  // namespace
}  // namespace weftlight::session
