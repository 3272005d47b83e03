// Temporary files of dead processes go; nothing else does.

#include "session/stale_files.h"

#include <sys/wait.h>

#include <set>

#include "../scratch_fixture.h"

namespace weftlight::session {
namespace {

namespace fs = std::filesystem;
using StaleFiles = ScratchTest;

TEST_F(StaleFiles, GoWithTheirProcessAndNothingElseDoes) {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  const std::string dead = std::to_string(child), living = std::to_string(getpid());
  const std::string own = "a.part-" + dead + "-0.wif";
  const std::set<std::string> kept{"a.wif",
                                   "a.part-" + living + "-0.wif",
                                   "b.part-" + dead + "-0.wif",
                                   "a.part-" + dead + "-0.png",
                                   "a.part-" + dead + ".wif",
                                   "a.part-" + dead + "-0x.wif",
                                   "a.part-0-0.wif",
                                   "a.part-2-of-3.wif",
                                   "a.part-.wif"};
  written(own, "half");
  for (const std::string& name : kept) written(name, "whole");
  fs::create_directory(path("a.part-" + dead + "-7.wif"));
  remove_stale_files(path("a.wif"));
  EXPECT_FALSE(fs::exists(path(own)));
  for (const std::string& name : kept) EXPECT_TRUE(fs::exists(path(name))) << name;
  EXPECT_TRUE(fs::exists(path("a.part-" + dead + "-7.wif")));
  remove_stale_files(path("no folder/a.wif"));
  remove_stale_files("");
}

}  // namespace
}  // namespace weftlight::session
