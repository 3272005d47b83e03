// Writes in the background are retried until they succeed, and their error is shown until then.

#include "session/jobs/background_writer.h"

#include <atomic>
#include <latch>

#include "../comes_true.h"
#include "../scratch_fixture.h"

namespace weftlight::session {

using base::read_file, base::write_file_atomically;

namespace {

class BackgroundWriterTest : public ScratchTest {};

TEST_F(BackgroundWriterTest, RetriesUntilTheFolderExists) {
  BackgroundWriter writer;
  const std::string file = path("folder/live.wif");
  writer.keep(file, [file] { return write_file_atomically(file, "draft"); });
  ASSERT_TRUE(comes_true([&] { return !writer.problem().empty(); }));
  EXPECT_NE(writer.problem().find(file), std::string::npos) << writer.problem();
  EXPECT_TRUE(writer.busy());
  std::filesystem::create_directory(path("folder"));
  EXPECT_TRUE(comes_true([&] { return writer.problem().empty() && !writer.busy(); }));
  EXPECT_EQ(read_file(file).value_or(""), "draft");
}

TEST_F(BackgroundWriterTest, AFailingPathDoesNotDelayOthers) {
  BackgroundWriter writer;
  writer.keep("a", []() -> base::Result<void> { return base::failure(base::ErrorKind::kOutput, "no"); });
  ASSERT_TRUE(comes_true([&] { return writer.problem() == "no"; }));
  std::atomic<bool> done{false};
  writer.keep("b", [&done] {
    done = true;
    return base::Result<void>();
  });
  EXPECT_TRUE(comes_true([&] { return done.load(); }));
  EXPECT_EQ(writer.problem(), "no");
  writer.drop("a");
  EXPECT_TRUE(comes_true([&] { return writer.problem().empty(); }));
}

TEST_F(BackgroundWriterTest, OfSeveralWaitingWritesOnlyTheNewestIsDone) {
  std::atomic<int> last{0}, runs{0};
  std::latch taken{1}, queued{1};
  {
    BackgroundWriter writer;
    // The first holds the writer up until all others wait. Before it is taken, one of them would take its place.
    writer.keep("a", [&taken, &queued] {
      taken.count_down();
      queued.wait();
      return base::Result<void>();
    });
    taken.wait();
    for (int i = 1; i <= 1000; ++i)
      writer.keep("a", [&last, &runs, i] {
        last = i;
        ++runs;
        return base::Result<void>();
      });
    queued.count_down();
  }
  EXPECT_EQ(last, 1000) << "the newest is written even where the writer ends";
  EXPECT_EQ(runs, 1) << "those between were skipped";
}

TEST_F(BackgroundWriterTest, AFailingWriteDoesNotDelayTheEnd) {
  std::atomic<int> tries{0};
  {
    BackgroundWriter writer;
    writer.keep("a", [&tries]() -> base::Result<void> {
      ++tries;
      throw std::bad_alloc();
    });
    ASSERT_TRUE(comes_true([&] { return tries > 0; }));
  }
  EXPECT_LE(tries, 3);
}

}  // namespace
}  // namespace weftlight::session
