// render, reference, export and drape: exit codes, and the files that remain after a failure.

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "paths.h"
#include "scratch_folder.h"

namespace weftlight::commands {

using base::read_file;

namespace {

using ExitCodes = ScratchFolder;
using Args = std::vector<std::string>;

Args operator+(Args a, const Args& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string draft() { return fixture_path("twill.wif"); }

/// Options for a picture that is drawn quickly.
const Args kSmall{"--size", "32x24", "--mesh", "plane", "--method", "flat"};

/// `weftlight ARGS` where no file may grow past `blocks` of 512 bytes, as on a disk that is full.
int run_on_a_full_disk(const Args& args, int blocks) {
  std::string line = "ulimit -f " + std::to_string(blocks) + "; exec '" WEFTLIGHT_BINARY "'";
  for (const std::string& arg : args) line += " '" + arg + "'";
  const int status = std::system((line + " >/dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The output of `weftlight ARGS` on a terminal.
std::string said_on_a_terminal(const Args& args) {
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    std::vector<std::string> words = Args{WEFTLIGHT_BINARY} + args;
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(127);
  }
  std::string said;
  char some[512];
  for (ssize_t n; (n = read(terminal, some, sizeof some)) > 0;) said.append(some, static_cast<size_t>(n));
  close(terminal);
  waitpid(child, nullptr, 0);
  return said;
}

TEST_F(ExitCodes, progress_is_shown_on_a_terminal_only) {
  const Args args = Args{"render", draft(), "-o", path("out.png")} + kSmall;
  const std::string said = said_on_a_terminal(args);
  for (const char* what : {"weaving ", " picks: step ", "drawing 32 x 24 pixels"})
    EXPECT_NE(said.find(what), std::string::npos) << said;
  EXPECT_EQ(said.back(), '\r') << "the line is cleared at the end";
  EXPECT_EQ(run(args).said, "");
}

TEST_F(ExitCodes, bad_usage_is_2) {
  const std::string out = path("out.png");
  for (const Args& args : std::vector<Args>{
           {"render"},
           {"render", draft()},
           {"render", draft(), "-o", path("out.gif")},
           {"render", draft(), "-o", out, "--size", "0x10"},
           {"render", draft(), "-o", out, "--size", "wide"},
           {"render", draft(), "-o", out, "--method", "magic"},
           {"render", draft(), "-o", out, "--view", "10"},
           {"render", draft(), "-o", out, "--yarns-per-pixel", "-1"},
           {"render", draft(), "-o", out, "--face", "side"},
           {"render", draft(), "-o", out, "--no-such-option"},
           {"render", draft(), "-o", out, "--surroundings"},
           {"reference", draft(), "-o", out, "--surroundings", "--lights", "window"},
           {"render", draft(), "-o", out, "--transparent", "--environment", "sky.hdr", "--surroundings"},
           {"reference", draft(), "-o", out, "--transparent", "--environment", "sky.hdr", "--surroundings"},
           {"render", draft(), "-o", out, "--mesh", "no_such_drape"},
           {"reference", draft(), "-o", out, "--mesh", "no_such_drape"},
           {"export", draft(), "-o", path("set"), "--mesh", "no_such_drape"},
           {"reference", draft(), "-o", out, "--spp", "0"},
           {"reference", draft(), "-o", out, "--seed", "-1"},
           {"reference", draft(), "-o", path("out.png"), "--layers"},
           {"reference", draft(), "-o", path("out.exr"), "--layers", "--fibres"},
           {"reference", draft(), "-o", path("out.exr"), "--layers", "--size", "8192x8192"},
           {"reference", draft(), "-o", path("out")},
           {"export", draft()},
           {"export", draft(), "-o", path("set"), "--target", "crayon"},
           {"export", draft(), "-o", path("set"), "--size", "100"},
           {"export", draft(), "-o", path("set"), "--jobs", "0"},
           {"drape", "tent", "-o", path("tent.glb")},
           {"drape", "plane"},
           {"drape", "skirt", "-o", path("skirt.glb"), "--mesh", "tunic"},
           {"drape", draft(), "-o", path("own.glb"), "--stiffness", "limp"},
           {"drape", draft(), "-o", path("own.glb"), "--hang", "limp"},
           {"drape", "plane", "-o", path("plane.glb"), "--stiffness", "limp", "--hang", "stiff"},
           {"drape", "plane", "-o", path("plane.glb"), "--stiffness", "soft"},
           {"drape", draft(), "-o", path("own.glb"), "--mesh", "plane"},
           {"drape", draft(), "-o", path("own.glb"), "--mesh", "tent"},
           {"drape", draft(), "-o", path("own.png")},
           {"curves", draft(), "-o", path("curves.obj")},
           {"curves", draft()},
           {"curves", draft(), "-o", path("curves.usda"), "--as", "ropes"},
           {"curves", draft(), "-o", path("curves.usda"), "--patch", "0x5"},
           {"curves", draft(), "-o", path("curves.usda"), "--patch", "5"},
       }) {
    const Ran ran = run(args);
    EXPECT_EQ(ran.code, kUsage) << ::testing::PrintToString(args);
    EXPECT_FALSE(ran.said.empty()) << ::testing::PrintToString(args);
  }
  EXPECT_TRUE(files().empty());
}

TEST_F(ExitCodes, a_bad_draft_is_3_and_the_line_is_named) {
  const std::string bad = written("bad.wif", "[WARP]\nThreads=4\n[WEFT]\nThreads=200000\n");
  const std::string none = path("none.wif");
  for (const Args& args : std::vector<Args>{{"render", bad, "-o", path("out.png")},
                                            {"reference", bad, "-o", path("out.exr")},
                                            {"export", bad, "-o", path("set"), "--size", "16"}}) {
    const Ran ran = run(args);
    EXPECT_EQ(ran.code, kBadInput) << args[0];
    EXPECT_NE(ran.said.find(bad + ":4: "), std::string::npos) << ran.said;
  }
  for (const Args& args : std::vector<Args>{{"render", none, "-o", path("out.png")},
                                            {"drape", none, "-o", path("own.glb")},
                                            {"curves", none, "-o", path("curves.usda")},
                                            {"reference", none, "-o", path("out.exr")},
                                            {"export", none, "-o", path("set"), "--size", "16"}}) {
    const Ran ran = run(args);
    EXPECT_EQ(ran.code, kBadInput) << args[0];
    EXPECT_NE(ran.said.find(none), std::string::npos) << ran.said;
  }
  EXPECT_EQ(files(), std::set<std::string>{"bad.wif"});
}

TEST_F(ExitCodes, a_bad_mesh_is_3_and_is_named) {
  written("broken.glb", "glTF, but not really");
  for (const std::string& mesh : {path("none.glb"), path("broken.glb")}) {
    for (const Args& args : std::vector<Args>{{"render", draft(), "-o", path("out.png"), "--method", "flat"},
                                              {"reference", draft(), "-o", path("out.png"), "--size", "32x24"},
                                              {"export", draft(), "-o", path("set"), "--size", "16"}}) {
      const Ran ran = run(args + Args{"--mesh", mesh});
      EXPECT_EQ(ran.code, kBadInput) << args[0] << " " << mesh;
      EXPECT_NE(ran.said.find(mesh), std::string::npos) << ran.said;
    }
  }
  EXPECT_EQ(files(), std::set<std::string>{"broken.glb"});
}

TEST_F(ExitCodes, a_draft_that_names_no_drape_is_3_and_is_named) {
  const std::string tent =
      written("tent.wif", read_file(draft()).value_or("") + "\n[PRIVATE WEFTLIGHT SCENE]\nMesh=tent\n");
  for (const char* verb : {"render", "reference"}) {
    const Ran ran = run({verb, tent, "-o", path("out.png"), "--size", "32x24"});
    EXPECT_EQ(ran.code, kBadInput) << verb;
    EXPECT_TRUE(ran.said.starts_with(tent + ": no drape is called 'tent'")) << ran.said;
  }
}

TEST_F(ExitCodes, a_bad_environment_map_is_3_and_is_named) {
  written("words.hdr", "these are words\n");
  written("broken.exr", "v/1\x01, but not really");
  written("square.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 64\n");
  written("huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 30000 +X 60000\n");
  const std::pair<const char*, const char*> refused[] = {{"none.exr", "no such file"},
                                                         {"words.hdr", "give an undamaged .hdr or .exr"},
                                                         {"broken.exr", "give an undamaged .hdr or .exr"},
                                                         {"square.hdr", "twice as wide as high"},
                                                         {"huge.hdr", "scale it down"}};
  for (const auto& [name, why] : refused) {
    for (const char* verb : {"render", "reference"}) {
      const Args quick = verb == std::string("render") ? Args{"--method", "flat"} : Args{};
      const Ran ran =
          run(Args{verb, draft(), "-o", path("out.png"), "--size", "32x24", "--environment", path(name)} + quick);
      EXPECT_EQ(ran.code, kBadInput) << verb << " " << name;
      EXPECT_NE(ran.said.find(path(name)), std::string::npos) << ran.said;
      EXPECT_NE(ran.said.find(why), std::string::npos) << ran.said;
    }
  }
  EXPECT_EQ(files(), (std::set<std::string>{"broken.exr", "huge.hdr", "square.hdr", "words.hdr"}));
}

TEST_F(ExitCodes, an_output_that_cannot_be_written_is_5) {
  written("file", "in the way");
  std::filesystem::create_directories(path("folder.png"));
  std::filesystem::create_directories(path("folder.glb"));
  for (const Args& args : std::vector<Args>{
           Args{"render", draft(), "-o", path("no/out.png")} + kSmall,
           Args{"render", draft(), "-o", path("folder.png")} + kSmall,
           Args{"render", draft(), "-o", path("file/out.png")} + kSmall,
           Args{"reference", draft(), "-o", path("no/out.png"), "--spp", "1"} + kSmall,
           {"export", draft(), "-o", path("file"), "--target", "raw", "--size", "16"},
           {"drape", "plane", "-o", path("no/plane.glb")},
           {"curves", draft(), "-o", path("no/curves.usda")},
           {"drape", "plane", "-o", path("folder.glb")},
           {"drape", "all", "-o", path("file")},
           {"drape", draft(), "-o", path("no/own.glb"), "--mesh", "sphere"},
           {"response", draft(), "-o", path("no/out.csv")},
           {"print", draft(), "-o", path("no/out.pdf")},
           {"weave", "plain", "-o", path("no/out.wif")},
           {"convert", draft(), path("no/out.wif")},
           {"drawdown", draft(), "-o", path("no/out.png")},
       }) {
    const Ran ran = run(args);
    EXPECT_EQ(ran.code, kNotWritten) << ::testing::PrintToString(args) << ran.said;
    EXPECT_FALSE(ran.said.empty()) << ::testing::PrintToString(args);
    const size_t named = ran.said.find(dir_.string());
    EXPECT_TRUE(named == std::string::npos || ran.said.find(dir_.string(), named + 1) == std::string::npos)
        << "the path is named once: " << ran.said;
  }
  EXPECT_EQ(files(), std::set<std::string>{"file"});
  EXPECT_EQ(read_file(path("file")).value_or(""), "in the way");
}

TEST_F(ExitCodes, the_editor_opens_every_file_that_is_named) {
  const Ran ran = run({"a.wif", "--ui-map", "map.json", "b.wif", "none"});
  EXPECT_EQ(ran.code, -1) << ran.said;
  EXPECT_EQ(ran.opened, (Args{"a.wif", "b.wif", "none"}));
}

TEST_F(ExitCodes, a_folder_that_takes_no_files_is_not_said_to_be_missing) {
  const Ran ran = run({"weave", "plain", "-o", "/proc/x.wif"});
  EXPECT_EQ(ran.code, kNotWritten);
  EXPECT_NE(ran.said.find("/proc/x.wif: cannot be written: its folder cannot be written to"), std::string::npos)
      << ran.said;
}

TEST_F(ExitCodes, an_output_that_cannot_be_written_fails_before_the_work) {
  for (const char* verb : {"render", "reference"}) {
    for (const Args& args : std::vector<Args>{{verb, draft(), "-o", path("no/out.png")},
                                              {verb, draft(), "-o", path("out.png"), "--stats", path("no/out.json")}}) {
      const std::string said = said_on_a_terminal(args + kSmall);
      EXPECT_NE(said.find(path("no/out.")), std::string::npos) << said;
      EXPECT_EQ(said.find("weaving "), std::string::npos) << said;
    }
  }
}

TEST_F(ExitCodes, a_turn_that_cannot_be_written_fails_before_its_first_picture) {
  const Args args{"render", draft(), "-o", path("no/out.png"), "--turntable", "2"};
  const std::string said = said_on_a_terminal(args + kSmall);
  EXPECT_NE(said.find(path("no/out_001.png")), std::string::npos) << said;
  EXPECT_EQ(said.find("weaving "), std::string::npos) << said;
}

TEST_F(ExitCodes, a_full_disk_keeps_the_old_picture_without_temporary_files) {
  for (const std::string name : {"cloth.png", "cloth.exr"}) written(name, "the old picture");
  for (const std::string name : {"cloth.png", "cloth.exr"}) {
    const Args args{"render", draft(), "-o", path(name), "--size", "128x128", "--mesh", "plane", "--method", "flat"};
    EXPECT_EQ(run_on_a_full_disk(args, 8), kNotWritten) << name;
    EXPECT_TRUE(read_file(path(name)).value_or("") == "the old picture") << name;
  }
  EXPECT_EQ(files(), (std::set<std::string>{"cloth.png", "cloth.exr"}));
}

TEST_F(ExitCodes, a_full_disk_keeps_the_old_mesh) {
  written("plane.glb", "the old mesh");
  EXPECT_EQ(run_on_a_full_disk({"drape", "plane", "-o", path("plane.glb")}, 8), kNotWritten);
  EXPECT_EQ(read_file(path("plane.glb")).value_or(""), "the old mesh");
  EXPECT_EQ(files(), std::set<std::string>{"plane.glb"});
}

TEST_F(ExitCodes, a_full_disk_keeps_the_old_texture_set_complete) {
  const Args args{"export", draft(), "-o", path("sets"), "--target", "raw", "--size", "64"};
  ASSERT_EQ(run(args).code, kDone);
  const std::set<std::string> before = files();
  EXPECT_TRUE(before.contains("sets/twill/texture_set.json"));
  EXPECT_EQ(run_on_a_full_disk(args, 8), kNotWritten);
  EXPECT_EQ(files(), before);
}

}  // namespace
}  // namespace weftlight::commands
