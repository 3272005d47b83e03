// Temporary files of processes that ended are removed, and no others.

#include "session/files/stale_files.h"

#include <fstream>
#include <set>

#include "../heir.h"
#include "../no_locks.h"
#include "../scratch_fixture.h"

namespace weftlight::session {
namespace {

namespace fs = std::filesystem;

class StaleFiles : public ScratchTest {
 protected:
  /// Somebody who writes "a.wif" and does not come to its end.
  Heir::Own writer() const {
    return [this](const auto& inherit) {
      base::write_through(path("a.wif"), [&](const std::string& beside) {
        std::ofstream(beside) << "half";
        inherit(beside);
        std::ofstream(beside) << "whole";
        return base::Result<void>();
      });
    };
  }
};

TEST_F(StaleFiles, FilesOfAnOwnerWithUnknownProcessIdStayWhileItLives) {
  Heir heir(writer());
  ASSERT_TRUE(fs::exists(heir.name()));
  remove_stale_files(path("a.wif"));
  EXPECT_TRUE(fs::exists(heir.name())) << "it lives";
  heir.kill();
  remove_stale_files(path("b.wif"));
  remove_stale_files(path("a.png"));
  EXPECT_TRUE(fs::exists(heir.name())) << "of another file";
  remove_stale_files(path("a.wif"));
  EXPECT_FALSE(fs::exists(heir.name()));
  EXPECT_TRUE(fs::is_empty(dir_));
}

TEST_F(StaleFiles, FilesOfAnOwnerWithUnknownProcessIdGoAfterItsEnd) {
  Heir heir(writer());
  remove_stale_files(path("a.wif"));
  heir.finish();
  EXPECT_EQ(base::read_file(path("a.wif")).value_or(""), "whole");
  EXPECT_EQ(std::distance(fs::directory_iterator(dir_), {}), 1);
}

TEST_F(StaleFiles, FilesStayWhenAForkOfTheirOwnerEnds) {
  const base::Result<void> done = base::write_through(path("a.wif"), [&](const std::string& beside) {
    std::ofstream(beside) << "half";
    const pid_t child = fork();
    if (child == 0) _exit(0);
    EXPECT_EQ(waitpid(child, nullptr, 0), child);
    remove_stale_files(path("a.wif"));
    EXPECT_TRUE(fs::exists(beside));
    return base::Result<void>();
  });
  EXPECT_EQ(problem_of(done), "");
}

TEST_F(StaleFiles, OtherFilesStay) {
  const std::string mark = "0123456789abcdef";
  const std::set<std::string> kept{"a.wif",
                                   "b.part-" + mark + ".wif",
                                   "a.part-" + mark + ".png",
                                   "a.part-" + mark + "0.wif",
                                   "a.part-" + mark + "-0.wif",
                                   "a.part-4194303-0.wif",
                                   "a.part-0123456789abcdeF.wif",
                                   "a.part-2-of-3.wif",
                                   "a.part-.wif"};
  for (const std::string& name : kept) written(name, "whole");
  written("a.part-" + mark + ".wif", "half");
  fs::create_directory(path("a.part-fedcba9876543210.wif"));
  fs::create_symlink(path("b.part-" + mark + ".wif"), path("a.part-1111111111111111.wif"));
  remove_stale_files(path("a.wif"));
  for (const std::string& name : kept) EXPECT_TRUE(fs::exists(path(name))) << name;
  EXPECT_FALSE(fs::exists(path("a.part-" + mark + ".wif")));
  EXPECT_TRUE(fs::exists(path("a.part-fedcba9876543210.wif")));
  EXPECT_TRUE(fs::exists(path("a.part-1111111111111111.wif")));
  remove_stale_files(path("no folder/a.wif"));
  remove_stale_files("");
}

TEST_F(StaleFiles, WithoutFileLocksNothingIsRemoved) {
  const std::string left = written("a.part-0123456789abcdef.wif", "half");
  const int answer = without_locks([&] {
    remove_stale_files(path("a.wif"));
    return fs::exists(left) && base::write_file_atomically(path("a.wif"), "whole") && fs::exists(path("a.wif"));
  });
  if (answer < 0) GTEST_SKIP() << "the system filters no calls";
  EXPECT_EQ(answer, 1);
}

}  // namespace
}  // namespace weftlight::session
