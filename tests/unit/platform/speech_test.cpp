#include "platform/speech.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "../scratch.h"
#include "../variable.h"

namespace weftlight::platform {
namespace {

using Words = std::vector<std::string>;

TEST(Speech, FindsTheProgramThatIsInstalled) {
  const Scratch scratch;
  const Variable folders("PATH", scratch.folder.string());
  EXPECT_EQ(speaking_program(), "");
  for (const char* name : {"spd-say", "espeak-ng"}) {
    std::ofstream(scratch.folder / name) << "#!/bin/sh\n";
    std::filesystem::permissions(scratch.folder / name, std::filesystem::perms::owner_all);
    EXPECT_EQ(speaking_program(), name) << "the better one first";
  }
}

TEST(Speech, ATextIsNeverAnOption) {
  EXPECT_EQ(speaking_words("espeak-ng", "-f /etc/passwd", "de"),
            (Words{"espeak-ng", "-v", "de", "--", "-f /etc/passwd"}));
  EXPECT_EQ(speaking_words("spd-say", "Pick 3", "C"), (Words{"spd-say", "--wait", "--language", "en", "--", "Pick 3"}));
  EXPECT_EQ(speaking_words("espeak", "Pick 3", ""), (Words{"espeak", "-v", "en", "--", "Pick 3"}));
}

}  // namespace
}  // namespace weftlight::platform
