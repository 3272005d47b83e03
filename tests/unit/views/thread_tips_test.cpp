// What the panel of threads says of its numbers.

#include <gtest/gtest.h>

#include <string_view>

#include "views/inspector/threads_panel.h"

namespace weftlight::views {
namespace {

TEST(ThreadTips, TheSettIsSaidToBeThatOfTheFinishedCloth) {
  for (const draft::System system : {draft::System::kWarp, draft::System::kWeft}) {
    const std::string_view tip = sett_tip(system);
    EXPECT_NE(tip.find("finished cloth"), std::string_view::npos) << tip;
    EXPECT_NE(tip.find("Plan page has the sett on the loom"), std::string_view::npos) << tip;
  }
}

}  // namespace
}  // namespace weftlight::views
