// No command replaces what it reads, nor one of its outputs another, whatever the names are by which they are given.

#include <filesystem>

#include "../yarns.h"
#include "scratch_folder.h"
#include "weaves/weaves.h"

namespace weftlight::commands {

using base::read_file;

namespace {

namespace fs = std::filesystem;
using Args = std::vector<std::string>;

class OwnInput : public ScratchFolder {
 protected:
  void SetUp() override {
    written("v.wif", draft_bytes());
    fs::copy_file(fixture_path("twill.wif"), path("other.wif"));
    fs::create_directory(path("below"));
    const std::string art = path("art.png");
    ASSERT_EQ(run({"drawdown", path("v.wif"), "--points", "-o", art}).code, kDone);
    fs::copy_file(art, path("art_001.png"));
    fs::copy_file(art, path("art-1.png"));
  }

  static std::string draft_bytes() { return read_file(fixture_path("twill.wif")).value_or(""); }

  /// The command is refused and changes nothing.
  void expect_refused(const Args& args, const std::string& why) const {
    const auto all = [this] {
      std::string bytes;
      for (const std::string& name : files()) bytes += name + "\n" + read_file(path(name)).value_or("");
      return bytes;
    };
    const std::string before = all();
    const Ran ran = run(args);
    EXPECT_EQ(ran.code, kUsage) << ::testing::PrintToString(args) << ran.said;
    EXPECT_NE(ran.said.find(why), std::string::npos) << ::testing::PrintToString(args) << ran.said;
    EXPECT_TRUE(all() == before) << ::testing::PrintToString(args);
  }
};

TEST_F(OwnInput, is_not_replaced) {
  const std::string draft = path("v.wif"), art = path("art.png"), out = path("q.png");
  for (const Args& args : std::vector<Args>{
           {"render", draft, "-o", out, "--size", "32x32", "--stats", draft},
           {"render", art, "-o", art},
           {"reference", art, "-o", art},
           {"drawdown", art, "-o", art},
           {"print", art, "-o", art},
           {"join", draft, path("other.wif"), "-o", draft, "--ends", "1:1"},
           {"join", draft, path("other.wif"), "-o", path("other.wif"), "--picks", "1:1"},
           {"convert", art, path("other.wif"), "--weave", "1=plain", "--weave", "2=" + path("other.wif")},
           {"render", path("art_001.png"), "-o", art, "--turntable", "2"},
           {"print", path("art-1.png"), "-o", art, "--paper", "a5", "--scale", "20"},
       })
    expect_refused(args, "is read by the command");
}

TEST_F(OwnInput, is_known_by_each_of_its_names) {
  fs::create_symlink(path("v.wif"), path("link.csv"));
  fs::create_hard_link(path("v.wif"), path("hard.csv"));
  fs::create_hard_link(path("v.wif"), path("same.csv"));
  for (const char* name : {"link.csv", "hard.csv", "./below/../same.csv"})
    expect_refused({"response", path("v.wif"), "-o", path(name)}, "is read by the command");
}

TEST_F(OwnInput, two_outputs_are_two_files) {
  for (const std::string& stats : {path("same.png"), path("below/../same.png")})
    expect_refused({"render", path("v.wif"), "-o", path("same.png"), "--stats", stats}, "is named as two outputs");
}

TEST_F(OwnInput, is_changed_in_place_by_commands_that_change_it) {
  ASSERT_EQ(run({"convert", path("v.wif"), path("v.wif")}).code, kDone);
  EXPECT_EQ(read_file(path("v.wif")).value_or(""), draft_bytes());
  EXPECT_EQ(run({"convert", path("v.wif"), path("v.wif"), "--tidy"}).code, kDone);
  const std::string metal =
      written("metal.wif",
              wif::write_new_wif(with_yarns(weaves::plain({8, 8}), yarn_preset("Metallic"), yarn_preset("Metallic"))));
  EXPECT_EQ(run({"lobes", metal, "-o", metal}).code, kDone) << "nothing is traced of metal";
  ASSERT_EQ(run({"yarns", path("v.wif"), "-o", path("list.txt")}).code, kDone);
  EXPECT_EQ(run({"yarns", path("v.wif"), path("list.txt"), "-o", path("list.txt")}).code, kDone);
}

TEST_F(OwnInput, outputs_have_the_extension_of_their_format_in_any_case) {
  const std::string draft = path("v.wif");
  for (const auto& [args, format] : std::vector<std::pair<Args, std::string>>{
           {{"convert", draft, path("out.dtx")}, ".wif"},
           {{"convert", draft, path("out.xyz")}, ".wif"},
           {{"convert", path("art.png"), path("art.png")}, ".wif"},
           {{"response", draft, "-o", path("r.txt")}, ".csv"},
           {{"response", draft, "-o", draft}, ".csv"},
           {{"weave", "plain", "-o", path("w.txt")}, ".wif"},
           {{"join", draft, draft, "-o", path("w.dtx"), "--ends", "1:1"}, ".wif"},
           {{"lobes", draft, "-o", path("w.png")}, ".wif"},
           {{"yarns", draft, "-o", path("w.wif")}, ".txt"},
           {{"curves", draft, "-o", path("w.obj")}, ".usda"},
           {{"print", draft, "-o", path("w.txt")}, ".pdf, .svg or .png"},
           {{"print", draft, "-o", path("w")}, ".pdf, .svg or .png"},
           {{"render", draft, "-o", path("w.gif")}, ".png or .exr"},
       })
    expect_refused(args, "must end in " + format);
  for (const char* name : {"d.PNG", "d.Svg", "d.PDF", "d.TXT"})
    EXPECT_EQ(run({"drawdown", draft, "-o", path(name)}).code, kDone) << name;
  EXPECT_EQ(run({"print", draft, "-o", path("p.PDF")}).code, kDone);
  EXPECT_TRUE(read_file(path("p.PDF")).value_or("").starts_with("%PDF"));
  EXPECT_EQ(run({"drape", "plane", "-o", path("p.GLTF")}).code, kDone);
  EXPECT_TRUE(read_file(path("p.GLTF")).value_or("").starts_with("{"));
  EXPECT_EQ(run({"convert", draft, path("V.WIF")}).code, kDone);
  EXPECT_EQ(run({"yarns", draft, "-o", path("y.TXT")}).code, kDone);
  EXPECT_EQ(run({"yarns", path("y.TXT")}).code, kDone);
}

}  // namespace
}  // namespace weftlight::commands
