// Other programs: what they print and how they end.

#include "platform/process.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>

#include <string>
#include <utility>

namespace weftlight::platform {
namespace {

void wait_for_end(Process& program) {
  for (int i = 0; i < 10000 && program.running(); ++i) {
    program.look();
    ::poll(nullptr, 0, 1);
  }
}

TEST(ProcessTest, what_it_prints_is_read_to_the_end) {
  Process program({"sh", "-c", "head -c 200000 /dev/zero; echo end"});
  ASSERT_TRUE(program.running());
  wait_for_end(program);
  EXPECT_TRUE(program.succeeded());
  EXPECT_EQ(program.output().size(), 200004u);
  EXPECT_TRUE(program.output().ends_with("end\n"));
}

TEST(ProcessTest, a_failure_is_told_from_success) {
  Process failing({"sh", "-c", "exit 3"});
  Process moved;
  moved = std::move(failing);
  wait_for_end(moved);
  EXPECT_FALSE(moved.running() || moved.succeeded());
}

TEST(ProcessTest, what_it_started_is_not_waited_for) {
  Process program({"sh", "-c", "sleep 100 & echo $!; kill -9 $$"});
  wait_for_end(program);
  EXPECT_FALSE(program.running() || program.succeeded());
  ASSERT_NE(program.output(), "");
  ::kill(std::stoi(program.output()), SIGKILL);  // which still has the output open
}

TEST(ProcessTest, one_that_prints_without_end_is_not_hoarded) {
  Process program({"sh", "-c", "exec cat /dev/zero"});
  for (int i = 0; i < 20; ++i) program.look();
  EXPECT_TRUE(program.running());
  EXPECT_LE(program.output().size(), size_t{1} << 20);
}

// The window ignores broken pipes: of a filter that a program starts, each would run on without a reader. So it is with
// the limit on the size of files.
TEST(ProcessTest, a_broken_pipe_ends_it_and_so_does_the_limit_on_files) {
  for (const auto& [ignored, name] : {std::pair{SIGPIPE, "PIPE"}, {SIGXFSZ, "XFSZ"}}) {
    void (*const before)(int) = ::signal(ignored, SIG_IGN);
    Process program({"sh", "-c", std::string("kill -s ") + name + " $$; echo alive"});
    wait_for_end(program);
    ::signal(ignored, before);
    EXPECT_FALSE(program.succeeded()) << name;
    EXPECT_EQ(program.output(), "") << name;
  }
}

TEST(ProcessTest, a_program_that_is_not_there_does_not_start) {
  const std::vector<std::string> words = {"no-such-program-71"};
  Process program(words);
  program.look();
  EXPECT_FALSE(program.running() || program.succeeded());
  EXPECT_FALSE(start_program(words));
  EXPECT_TRUE(start_program({"true"}));
}

}  // namespace
}  // namespace weftlight::platform
