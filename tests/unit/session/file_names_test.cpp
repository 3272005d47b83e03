#include "session/file_names.h"

#include <gtest/gtest.h>

namespace weftlight::session {
namespace {

TEST(FileNames, ADraftEndsInWif) {
  EXPECT_EQ(with_wif_ending("/home/a/scarf"), "/home/a/scarf.wif");
  EXPECT_EQ(with_wif_ending("scarf.2026"), "scarf.2026.wif");
  EXPECT_EQ(with_wif_ending("scarf.wif"), "scarf.wif");
  EXPECT_EQ(with_wif_ending("SCARF.WIF"), "SCARF.WIF");
  EXPECT_EQ(with_wif_ending(".hidden"), ".hidden.wif");
  EXPECT_EQ(with_wif_ending(""), "") << "no name is no name";
}

}  // namespace
}  // namespace weftlight::session
