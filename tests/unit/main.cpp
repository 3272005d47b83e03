// gtest's main, and 77 where a test could not run: ctest counts the suite as skipped, never as passed. A test that
// skips with the words "no graphics" leaves a file behind until it can draw; tests/house/drawing.sh lists these files.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "paths.h"
#include "platform/environment_variables.h"

namespace {

class DrawingRecord : public testing::EmptyTestEventListener {
 public:
  explicit DrawingRecord(std::filesystem::path folder) : folder_(std::move(folder)) {}

 private:
  void OnTestEnd(const testing::TestInfo& test) override {
    std::string name = std::string(test.test_suite_name()) + "." + test.name();
    std::replace(name.begin(), name.end(), '/', '.');  // of tests with parameters
    std::error_code ignored;
    std::filesystem::remove(folder_ / name, ignored);
    const testing::TestResult& result = *test.result();
    for (int i = 0; result.Skipped() && i < result.total_part_count(); ++i) {
      const std::string why = result.GetTestPartResult(i).message();
      if (why.find("no graphics") == std::string::npos) continue;
      std::filesystem::create_directories(folder_, ignored);
      std::ofstream(folder_ / name) << why << '\n';
    }
  }
  std::filesystem::path folder_;
};

}  // namespace

int main(int argc, char** argv) {
  weftlight::platform::set_variable("LANGUAGE", "en");  // tests read English, whatever the system speaks
  testing::InitGoogleTest(&argc, argv);
  const char* const folder = std::getenv("WEFTLIGHT_NOT_DRAWN");
  testing::UnitTest::GetInstance()->listeners().Append(  // gtest owns it
      new DrawingRecord(folder != nullptr ? folder : WEFTLIGHT_TESTS_BINARY_DIR "/not_drawn"));
  if (const int failed = RUN_ALL_TESTS(); failed != 0) return failed;
  constexpr int kSkipped = 77;
  return testing::UnitTest::GetInstance()->skipped_test_count() > 0 ? kSkipped : 0;
}
