#include "base/result.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "base/caught.h"

namespace weftlight::base {
namespace {

TEST(Result, AMessageNamesFileAndLineWhereTheyAreKnown) {
  EXPECT_EQ(message({ErrorKind::kInput, "is cut short; copy it again", "a.glb", 12}),
            "a.glb:12: is cut short; copy it again");
  EXPECT_EQ(message({ErrorKind::kInput, "no such file", "a.glb"}), "a.glb: no such file");
  EXPECT_EQ(message({ErrorKind::kUsage, "give --mesh"}), "give --mesh");
}

TEST(Result, AnErrorIsPassedOnWhole) {
  const Result<int> read = failure(ErrorKind::kOutput, "the disk is full", "a.png", 3);
  const Result<void> passed = failed(read);
  EXPECT_EQ(passed.error().kind, ErrorKind::kOutput);
  EXPECT_EQ(problem_of(passed), "a.png:3: the disk is full");
  EXPECT_EQ(problem_of(Result<int>(7)), "");
}

TEST(Result, WhatALibraryThrowsBecomesAnError) {
  const auto error_of = [](const auto& exception) -> Result<void> {
    try {
      throw exception;
    } catch (...) {
      return thrown(ErrorKind::kInput, "a.glb");
    }
  };
  const Result<void> broken = error_of(std::runtime_error("a chunk is missing")), memory = error_of(std::bad_alloc());
  EXPECT_EQ(problem_of(broken), "a.glb: a chunk is missing");
  EXPECT_EQ(broken.error().kind, ErrorKind::kInput);
  EXPECT_EQ(problem_of(memory), "a.glb: there is not enough memory");
  EXPECT_EQ(memory.error().kind, ErrorKind::kMemory);
}

TEST(Result, AJobIsCaughtWithItsOwnResult) {
  EXPECT_TRUE(caught([] {}));
  EXPECT_EQ(problem_of(caught([]() -> Result<void> { return failure(ErrorKind::kInput, "no ends", "a.wif"); })),
            "a.wif: no ends");
  const Result<void> broken = caught([] { throw std::runtime_error("the line broke"); }, ErrorKind::kOutput);
  EXPECT_EQ(problem_of(broken), "the line broke");
  EXPECT_EQ(broken.error().kind, ErrorKind::kOutput);
  EXPECT_EQ(caught([] { throw std::bad_alloc(); }).error().kind, ErrorKind::kMemory);
}

}  // namespace
}  // namespace weftlight::base
