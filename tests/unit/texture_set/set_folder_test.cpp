// Whose a folder that is being filled is: its owner's for as long as that lives, wherever it runs.

#include "texture_set/set_folder.h"

#include <gtest/gtest.h>

#include <barrier>
#include <fstream>
#include <thread>

#include "../heir.h"
#include "../memory_taken.h"
#include "../no_locks.h"
#include "../scratch.h"

namespace weftlight::texture_set {
namespace {

namespace fs = std::filesystem;

const SetIdentity kSet{"x.wif", "x.wif", "gltf"};

/// As an export does it: `text` in every file, so that files of two sets are told apart.
void fill(const fs::path& made, const std::string& text) {
  for (const char* name : {"a.png", "b.png", "c.png"}) std::ofstream(made / name) << text;
  std::ofstream(made / "texture_set.json")
      << R"({"format": "weftlight texture set", "draft": "x.wif", "source": "x.wif", "target": "gltf", )"
      << R"("files": ["a.png", "b.png", "c.png"]})";
}

std::string text_in(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string write_set(const fs::path& folder, const std::string& text) {
  base::Result<Staging> made = make_staging(folder);
  if (!made) return problem_of(made);
  fill(made->folder, text);
  return problem_of(put_in_place(std::move(*made), folder, kSet, false));
}

/// Somebody who writes a set and does not come to its end.
Heir::Own writer_into(const fs::path& folder) {
  return [folder](const auto& inherit) {
    Staging made = make_staging(folder).value();
    std::ofstream(made.folder / "a.png") << "half";
    inherit(made.folder.string());
    fill(made.folder, "late");
    put_in_place(std::move(made), folder, kSet, false);
  };
}

TEST(SetFolder, AnOwnerWithoutANumberHereIsLeftAlone) {
  const Scratch scratch("owner");
  Heir heir(writer_into(scratch / "set"));
  ASSERT_TRUE(fs::exists(heir.name()));
  ASSERT_EQ(write_set(scratch / "set", "mine"), "");
  EXPECT_TRUE(fs::exists(fs::path(heir.name()) / "a.png")) << "it lives";
  heir.finish();
  EXPECT_EQ(text_in(scratch / "set/a.png"), "late");
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.folder), {}), 1);
}

TEST(SetFolder, WhatTheDeadLeftGoesAndNothingElse) {
  const Scratch scratch("dead");
  Heir heir(writer_into(scratch / "set"));
  const std::string mark = "0123456789abcdef";
  for (const char* name : {"set.part-time", "other.part-0123456789abcdef", "set.part-0123456789abcdef"})
    fs::create_directories(scratch / name);
  std::ofstream(scratch / "set.part-time/.weftlight_texture_set") << "";
  std::ofstream(scratch / "other.part-0123456789abcdef/.weftlight_texture_set") << "";
  fs::create_directory_symlink(scratch / "other.part-0123456789abcdef", scratch / "set.part-1111111111111111");
  heir.kill();
  ASSERT_EQ(write_set(scratch / "set", "mine"), "");
  EXPECT_FALSE(fs::exists(heir.name()));
  EXPECT_TRUE(fs::exists(scratch / "set.part-time"));
  EXPECT_TRUE(fs::exists(scratch / "other.part-0123456789abcdef/.weftlight_texture_set"));
  EXPECT_TRUE(fs::exists(scratch / "set.part-0123456789abcdef")) << "without a mark it may be anyone's";
  EXPECT_TRUE(fs::exists(scratch / "set.part-1111111111111111"));
}

TEST(SetFolder, WhatTheDeadLeftOfSeveralTargetsIsNotInTheWayOfOne) {
  const Scratch scratch("targets");
  const fs::path folder = scratch / "set";
  Heir heir(writer_into(folder / "gltf"));
  EXPECT_FALSE(check_place(folder, kSet)) << "it lives";
  heir.kill();
  EXPECT_EQ(problem_of(check_place(folder, kSet)), "");
  EXPECT_TRUE(fs::exists(heir.name())) << "who only asks removes nothing";
  ASSERT_EQ(write_set(folder, "mine"), "");
  EXPECT_EQ(text_in(folder / "a.png"), "mine");
  EXPECT_FALSE(fs::exists(heir.name()));
}

TEST(SetFolder, OnlyWhatIsMarkedAsStaleIsLeftOutOfAccount) {
  const Scratch scratch("marked");
  const fs::path folder = scratch / "set", left = folder / "gltf.part-0123456789abcdef";
  fs::create_directories(left);
  EXPECT_FALSE(check_place(folder, kSet)) << "without a mark it may be anyone's";
  std::ofstream(left / ".weftlight_texture_set") << "";
  EXPECT_EQ(problem_of(check_place(folder, kSet)), "");
  std::ofstream(folder / "notes.txt") << "mine";
  EXPECT_FALSE(check_place(folder, kSet));
}

TEST(SetFolder, AForkThatEndsTakesNothingWithIt) {
  const Scratch scratch("forks");
  Staging made = make_staging(scratch / "set").value();
  const pid_t child = fork();
  if (child == 0) {
    { const Staging ended = std::move(made); }
    _exit(0);
  }
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  ASSERT_EQ(write_set(scratch / "set", "other"), "");
  EXPECT_TRUE(fs::exists(made.folder));
}

TEST(SetFolder, TwoExportsIntoOneFolderAtOnceGiveOneWholeSet) {
  const Scratch scratch("two");
  constexpr int kRounds = 200;
  for (int round = 0; round < kRounds; ++round) {
    const fs::path folder = scratch.folder / "set";
    Staging a = make_staging(folder).value(), b = make_staging(folder).value();
    fill(a.folder, "a"), fill(b.folder, "b");
    base::Result<void> theirs;
    std::barrier both(2);
    std::thread other([&] {
      both.arrive_and_wait();
      theirs = put_in_place(std::move(b), folder, kSet, false);
    });
    both.arrive_and_wait();
    const base::Result<void> mine = put_in_place(std::move(a), folder, kSet, false);
    other.join();
    ASSERT_EQ(problem_of(mine) + problem_of(theirs), "") << round;
    const std::string one = text_in(folder / "a.png");
    ASSERT_FALSE(one.empty()) << round;
    for (const char* name : {"b.png", "c.png"}) ASSERT_EQ(text_in(folder / name), one) << round;
    ASSERT_EQ(std::distance(fs::directory_iterator(scratch.folder), {}), 1) << round;
    if (round % 2 == 1) fs::remove_all(folder);  // the first set is put in place in another way
  }
}

TEST(SetFolder, WithoutLocksNothingGoesAndNoneIsTakenForADeadOnes) {
  const Scratch scratch("none");
  const std::string left = scratch / "set.part-0123456789abcdef";
  fs::create_directory(left);
  std::ofstream(left + "/.weftlight_texture_set") << "";
  const int answer = without_locks([&] {
    const bool wrote = write_set(scratch / "set", "mine").empty() && fs::exists(left);
    const base::Result<Staging> cut_short = make_staging(scratch / "set");
    if (cut_short) std::ofstream(scratch / "name") << cut_short->folder.string();
    return wrote && cut_short;
  });
  if (answer < 0) GTEST_SKIP() << "the system filters no calls";
  EXPECT_EQ(answer, 1);
  ASSERT_EQ(write_set(scratch / "set", "mine"), "");
  EXPECT_TRUE(fs::exists(text_in(scratch / "name"))) << "its owner could say nothing of itself";
  EXPECT_FALSE(fs::exists(left));
}

TEST(SetFolder, AnothersSetThatCameMeanwhileIsNotReplaced) {
  const Scratch scratch("meanwhile");
  Staging late = make_staging(scratch / "set").value();
  fill(late.folder, "late");
  ASSERT_EQ(write_set(scratch / "set", "mine"), "");
  EXPECT_FALSE(put_in_place(std::move(late), scratch / "set", {"y.wif", "y.wif", "gltf"}, false));
  EXPECT_EQ(text_in(scratch / "set/a.png"), "mine");
}

TEST(SetFolder, AListThatIsABombIsNoSet) {
  const Scratch scratch("bomb");
  fs::create_directories(scratch / "set");
  const auto set = [&](const std::string& rest) {
    std::ofstream(scratch / "set/texture_set.json") << R"({"format": "weftlight texture set", "key": "k", )" << rest;
    return [folder = scratch / "set"] {
      return std::to_string(listed_files(folder).size()) + (is_complete(folder, "k") ? " whole" : " not whole") +
             (lists_archive(folder) ? " archived" : "");
    };
  };
  expect_harmless(set(R"("files": )" + std::string(16'000'000, '[')), "0 not whole");
  std::string names = R"("files": ["a")";
  for (int i = 0; i < 5'000'000; ++i) names += ",[]";
  expect_harmless(set(names + "]}"), "0 not whole");
  expect_harmless(set(R"("files": [], "about": ")" + std::string(20'000'000, 'a') + "\"}"), "0 not whole");
  expect_harmless(set(R"("files": ["a"], "archived": "yes"})"), "2 not whole");
}

}  // namespace
}  // namespace weftlight::texture_set
