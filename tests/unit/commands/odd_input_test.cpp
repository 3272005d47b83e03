// Odd names, files and command lines: handled correctly, or rejected in one line with the exit code of the contract.

#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/json.h"
#include "base/utf8.h"
#include "paths.h"
#include "scratch_folder.h"

namespace weftlight::commands {

using base::is_utf8, base::read_file;

namespace {

using OddInput = ScratchFolder;
using Args = std::vector<std::string>;

std::string draft() { return fixture_path("twill.wif"); }

std::string draft_bytes() { return read_file(draft()).value_or(""); }

/// The exit code of the program itself, in a shell: "VARIABLE=value; weftlight ARGS > file".
int shell(const std::string& before, const std::string& args, const std::string& after = ">/dev/null 2>&1") {
  const int status = std::system((before + " '" WEFTLIGHT_BINARY "' " + args + " " + after).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(OddInput, text_that_is_not_utf8_becomes_valid_json) {
  const std::string latin = draft_bytes() +
                            "\n[CONTENTS]\nC\xE9"
                            "f=true\n[CAF\xE9]\n1=x\n[CAF\xE9 2]\n1=y\n";
  const std::string named = written("caf\xE9.wif", latin);
  ASSERT_EQ(shell("", "info --json '" + named + "'", ">'" + path("out.json") + "'"), kDone);
  const std::string json = read_file(path("out.json")).value_or("");
  EXPECT_TRUE(is_utf8(json));
  const nlohmann::json info = nlohmann::json::parse(json, nullptr, false);
  ASSERT_TRUE(info.is_object());
  EXPECT_NE(info["warnings"].dump().find("CAF\xC3\xA9"), std::string::npos) << info["warnings"].dump(1);
}

TEST_F(OddInput, an_escaped_title_becomes_valid_json) {
  const std::string odd = draft_bytes() + "\n[TEXT]\nTitle=caf?\n[PRIVATE WEFTLIGHT TEXT]\nTitle=caf\\xe9\n";
  ASSERT_EQ(shell("", "info --json '" + written("odd.wif", odd) + "'", ">'" + path("out.json") + "'"), kDone);
  EXPECT_TRUE(nlohmann::json::accept(read_file(path("out.json")).value_or("")));
}

TEST_F(OddInput, pipes_and_devices_are_rejected_at_once) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  for (const std::string& name : {std::string("/dev/zero"), path("pipe"), path("")}) {
    const Ran ran = run({"info", name});
    EXPECT_EQ(ran.code, kBadInput) << name;
    EXPECT_NE(ran.said.find(name), std::string::npos) << ran.said;
  }
  EXPECT_EQ(run({"render", draft(), "-o", path("a.png"), "--mesh", path("pipe")}).code, kBadInput);
}

TEST_F(OddInput, a_full_device_is_reported) {
  const std::string file = "'" + draft() + "'";
  EXPECT_EQ(shell("", "info " + file, ">/dev/full 2>/dev/null"), kNotWritten);
  EXPECT_EQ(shell("", "info --json " + file, ">/dev/full 2>/dev/null"), kNotWritten);
  EXPECT_EQ(shell("", "drawdown " + file, ">/dev/full 2>/dev/null"), kNotWritten);
  EXPECT_EQ(shell("", "--help", ">/dev/full 2>/dev/null"), kNotWritten);
  EXPECT_EQ(shell("", "drape plane -o '" + path("plane.glb") + "'", ">/dev/full 2>/dev/null"), kNotWritten);
  EXPECT_EQ(shell("", "export --size 16 --target raw " + file + " -o '" + path("set") + "'", ">/dev/full 2>/dev/null"),
            kNotWritten);
  const Ran ran = run({"convert", draft(), "/dev/full"});
  EXPECT_EQ(ran.code, kNotWritten);
  EXPECT_NE(ran.said.find("/dev/full: cannot be written: the disk is full"), std::string::npos) << ran.said;
}

TEST_F(OddInput, a_draft_can_be_converted_into_a_pipe) {
  ASSERT_EQ(shell("", "convert '" + draft() + "' /dev/stdout", "| cat >'" + path("copy.wif") + "'"), kDone);
  EXPECT_EQ(read_file(path("copy.wif")).value_or(""), draft_bytes());
  ASSERT_EQ(shell("(echo before;", "convert '" + draft() + "' /dev/stdout; echo after)", ">'" + path("all") + "'"), 0);
  EXPECT_EQ(read_file(path("all")).value_or(""), "before\n" + draft_bytes() + "after\n");
}

TEST_F(OddInput, pictures_respect_read_only_files_and_links) {
  written("locked.png", "mine");
  ::chmod(path("locked.png").c_str(), 0444);
  const Ran ran = run({"drawdown", draft(), "-o", path("locked.png")});
  EXPECT_EQ(ran.code, kNotWritten);
  EXPECT_NE(ran.said.find("read-only"), std::string::npos) << ran.said;
  EXPECT_EQ(read_file(path("locked.png")).value_or(""), "mine");
  std::filesystem::create_directory(path("there"));
  std::filesystem::create_symlink("there/real.png", path("link.png"));
  EXPECT_EQ(run({"drawdown", draft(), "-o", path("link.png")}).code, kDone);
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.png")));
  EXPECT_EQ(read_file(path("there/real.png")).value_or("").substr(1, 3), "PNG");
}

TEST_F(OddInput, a_mistyped_verb_names_the_closest) {
  for (const auto& [word, verb] : std::vector<std::pair<std::string, std::string>>{
           {"rendr", "render"}, {"drawdwn", "drawdown"}, {"exprot", "export"}, {"inf", "info"}}) {
    const Ran ran = run({word});
    EXPECT_EQ(ran.code, kUsage) << word;
    EXPECT_NE(ran.said.find("'" + verb + "'"), std::string::npos) << ran.said;
    EXPECT_EQ(run({word, draft(), "-o", path("a.png")}).code, kUsage);
  }
  const Ran far = run({"quilt"});
  EXPECT_EQ(far.code, kUsage);
  EXPECT_NE(far.said.find("render"), std::string::npos) << far.said;
  written("twill", draft_bytes());
  EXPECT_EQ(run({path("twill")}).code, -1) << "a file without an extension opens";
}

TEST_F(OddInput, odd_values_are_bad_usage_in_a_short_line) {
  const std::string out = path("a.png"), digits(300, '9');
  for (const Args& args : std::vector<Args>{
           {"render", draft(), "-o", out, "--yarns-per-pixel", "nan"},
           {"render", draft(), "-o", out, "--yarns-per-pixel", "inf"},
           {"render", draft(), "-o", out, "--yarns-per-pixel", "0"},
           {"render", draft(), "-o", out, "--yarns-per-pixel", digits},
           {"render", draft(), "-o", out, "--size", digits + "x4"},
           {"render", draft(), "-o", out, "--samples", digits},
           {"reference", draft(), "-o", out, "--spp", digits},
           {"reference", draft(), "-o", out, "--spp", "1.5"},
           {"export", draft(), "-o", path("set"), "--size", digits},
           {"render", draft(), "-o", ""},
           {"drawdown", draft(), "-o", ""},
           {"export", draft(), "-o", ""},
           {"drape", "plane", "-o", ""},
           {"convert", draft(), ""},
           {"drawdown", draft(), "-o", path("a.gif")},
           {"drawdown", draft(), "-o", path("a.wif")},
           {"drape", "plane", "-o", path("a.txt")},
       }) {
    const Ran ran = run(args);
    EXPECT_EQ(ran.code, kUsage) << ::testing::PrintToString(args);
    EXPECT_FALSE(ran.said.empty()) << ::testing::PrintToString(args);
    EXPECT_LT(ran.said.size(), 300u) << ran.said;
  }
  EXPECT_TRUE(files().empty());
}

TEST_F(OddInput, the_extension_of_a_drawdown_selects_its_format) {
  const std::vector<std::pair<std::string, std::string>> heads{
      {"a.svg", "<?xml"},   {"a.pdf", "%PDF"}, {"a.jpg", "\xFF\xD8\xFF"},
      {"a.PNG", "\x89PNG"}, {"a.txt", "0"},    {"a", "0"}};
  for (const auto& [name, head] : heads) {
    ASSERT_EQ(run({"drawdown", draft(), "-o", path(name)}).code, kDone) << name;
    const std::string bytes = read_file(path(name)).value_or("");
    if (head == "0") EXPECT_EQ(bytes.find_first_not_of("01\n"), std::string::npos) << name;
    else EXPECT_EQ(bytes.substr(0, head.size()), head) << name;
  }
  EXPECT_EQ(files().size(), heads.size());
}

TEST_F(OddInput, a_broken_lod_table_is_reported_and_replaced) {
  const std::string presets = path("presets");
  std::filesystem::create_directories(presets);
  std::filesystem::copy(WEFTLIGHT_SOURCE_DIR "/presets/lights", presets + "/lights",
                        std::filesystem::copy_options::recursive);
  const std::string line =
      "render '" + draft() + "' --size 32x24 --mesh plane --method flat -o '" + path("a.png") + "'";
  const std::string env = "WEFTLIGHT_PRESETS='" + presets + "'", said = ">/dev/null 2>'" + path("said") + "'";
  for (const char* what : {"folder", "broken", "missing"}) {
    if (what == std::string("folder")) std::filesystem::create_directory(presets + "/lod_table.csv");
    if (what == std::string("broken")) std::ofstream(presets + "/lod_table.csv") << "not,a\ntable";
    const int code = shell(env, line, said);
    if (code == kNoGraphics) GTEST_SKIP() << "no graphics here";
    EXPECT_EQ(code, kDone) << what;
    EXPECT_NE(read_file(path("said")).value_or("").find("lod_table.csv"), std::string::npos) << what;
    std::filesystem::remove(presets + "/lod_table.csv");
  }
}

TEST_F(OddInput, neither_egl_nor_a_display_is_no_graphics) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "a library put before the sanitizer's cannot be loaded";
#endif
  const std::string preload =
      "DISPLAY= WAYLAND_DISPLAY= WEFTLIGHT_OFFSCREEN= LD_PRELOAD='" WEFTLIGHT_TESTS_BINARY_DIR "/libno_egl.so'";
  const std::string line = "render '" + draft() + "' --size 32x24 -o '" + path("a.png") + "'";
  EXPECT_EQ(shell(preload, line, ">/dev/null 2>'" + path("said") + "'"), kNoGraphics);
  EXPECT_NE(read_file(path("said")).value_or("").find("libEGL.so.1"), std::string::npos);
}

TEST_F(OddInput, memory_that_is_not_there_is_told_in_one_line) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "a library put before the sanitizer's cannot be loaded";
#endif
  ASSERT_EQ(shell("", "weave satin --ends 4000 --picks 4000 -o '" + path("large.wif") + "'"), kDone);
  const std::string scarce =
      "WEFTLIGHT_MOST_BYTES=1000000 LD_PRELOAD='" WEFTLIGHT_TESTS_BINARY_DIR "/libscarce_memory.so'";
  const auto said = [&](const std::string& args, int code) {
    EXPECT_EQ(shell(scarce, args, ">/dev/null 2>'" + path("said") + "'"), code) << args;
    const std::string words = read_file(path("said")).value_or("");
    EXPECT_NE(words.find("not enough memory"), std::string::npos) << args << ": " << words;
    return std::count(words.begin(), words.end(), '\n');
  };
  EXPECT_EQ(said("info '" + path("large.wif") + "'", kBadInput), 1);
  EXPECT_EQ(said("drawdown '" + path("large.wif") + "' -o '" + path("a.png") + "'", kNotWritten), 1);
  EXPECT_FALSE(std::filesystem::exists(path("a.png")));
  std::filesystem::create_directory(path("out"));
  // Of two sets neither is written, and both are told.
  EXPECT_EQ(
      said("export '" + draft() + "' '" + path("large.wif") + "' --target raw --size 1024 -o '" + path("out") + "'",
           kNotWritten),
      3);
  EXPECT_TRUE(std::filesystem::is_empty(path("out")));
}

}  // namespace
}  // namespace weftlight::commands
