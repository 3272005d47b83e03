// What the command line says about arguments that it cannot use, and its help: the program's own words, in one line.

#include "../scratch_fixture.h"
#include "commands/verbs.h"
#include "scratch_folder.h"

namespace weftlight::commands {
namespace {

using Args = std::vector<std::string>;

std::string draft() { return fixture_path("twill.wif"); }

std::vector<const char*> names_of_verbs() {
  std::vector<const char*> names;
  for (const std::span<const Verb> verbs : {draft_verbs(), cloth_verbs(), shell_verbs()})
    for (const Verb& verb : verbs) names.push_back(verb.name);
  return names;
}

TEST(ParserTexts, name_the_argument_and_what_to_give) {
  const std::vector<std::pair<Args, std::string>> cases{
      {{"render"}, "weftlight render: FILE is required (Draft)\n"},
      {{"render", draft()}, "weftlight render: -o is required (Output file: .png or .exr)\n"},
      {{"render", draft(), "-o"}, "weftlight render: -o needs a value: FILE\n"},
      {{"render", draft(), "-o", "a.png", "--size"}, "weftlight render: --size needs a value: WxH\n"},
      {{"render", draft(), "-o", "a.png", "-o", "b.png"}, "weftlight render: -o may be given only once\n"},
      {{"render", draft(), "-o", "a.png", "--shiny"}, "weftlight render: there is no option '--shiny'\n"},
      {{"render", draft(), "-o", "a.png", "--sise=10x10"},
       "weftlight render: there is no option '--sise'; did you mean --size?\n"},
      {{"render", draft(), "--outptu", "a.png"},
       "weftlight render: there is no option '--outptu'; did you mean --output?\n"},
      {{"render", draft(), "-o", "a.png", "more"}, "weftlight render: unexpected argument 'more'\n"},
      {{"convert", draft(), "a.wif", "--liftplan", "--treadling"},
       "weftlight convert: --liftplan and --treadling cannot be given together; leave one out\n"},
      {{"diff", draft()}, "weftlight diff: B is required (Second draft)\n"},
      {{"--ui-mpa", "a.json"}, "weftlight: there is no option '--ui-mpa'; did you mean --ui-map?\n"},
      {{"analyse", draft(), "--shrinkage", "3"}, "weftlight analyse: --shrinkage: '3' is not a number from 0 to 0.9\n"},
      {{"analyse", draft(), "--floats", "7.5"},
       "weftlight analyse: --floats: '7.5' is not a whole number from 0 to 100000\n"},
      {{"print", draft(), "-o", "a.pdf", "--paper", "b5"},
       "weftlight print: --paper: 'b5' must be one of a4, a3, a5, letter, legal\n"},
      {{"chart", "-o", "a", "--view", "7"}, "weftlight chart: --view: '7' must be one of 0, 80\n"},
      {{"info", draft(), "--json=maybe"}, "weftlight info: --json takes no value\n"},
      {{"convert", draft(), "a.wif", "--liftplan=perhaps"}, "weftlight convert: --liftplan takes no value\n"},
      {{"info", draft(), "info", draft()}, "weftlight info: unexpected argument 'info'\n"},
      {{"weave", "twill", "-o", "a.wif", "--ends", "100000", "--picks", "100000"},
       "weftlight: --ends 100000 --picks 100000: this is more than the " + std::to_string(draft::kMaxCells) +
           " crossings that can be opened\n"},
      {{"weave", "twill", "--set"}, "weftlight weave: --set needs a value: ID=VALUE\n"},
      {{"render", draft(), "-o", "a.png", "--view", "0,500"},
       "weftlight render: --view: '500' is not a number from -90 to 90\n"},
      {{"reference", draft(), "-o", "a.png", "--light", "0,-90.5"},
       "weftlight reference: --light: '-90.5' is not a number from -90 to 90\n"},
      {{"curves", draft(), "-o", "a.usda", "--from", "1e9,-1e9", "--patch", "2x2"},
       "weftlight curves: --from: '1000000000' is not a number from -10000 to 10000\n"},
      {{"convert", "--", "--x.wif"}, "weftlight convert: OUT is required (Output file: .wif)\n"},
      {{"export", "--", "--x.wif"}, "weftlight export: -o is required (Output folder)\n"},
      {{"export", draft(), "-o", "a", "--versions=all"}, "weftlight export: --versions takes no value\n"},
      {{"convert", draft(), "c.foo"}, "weftlight convert: 'c.foo' must end in .wif or .wifw\n"},
      {{"join", draft(), draft(), "-o", "a.wif", "--picks", "0:1"},
       "weftlight: --picks 0:1: give the threads of each draft in turn as two numbers from 1 to 1000: 2:1\n"},
      {{"completion", "csh"}, "weftlight completion: 'csh' must be one of bash, zsh, fish\n"},
      {{"convert", draft(), "-"}, "weftlight convert: OUT: a - is no file; the standard output is /dev/stdout\n"},
      {{"drawdown", draft(), "-o", "-"},
       "weftlight drawdown: --output: a - is no file; the standard output is /dev/stdout\n"},
      {{"render", draft(), "-o", "-"}, "weftlight render: --output: '-' must end in .png or .exr\n"},
      {{"convert", draft(), ""}, "weftlight convert: OUT: the name is empty\n"},
      {{"info", ""}, "weftlight info: FILE: the name is empty\n"},
      {{"export", draft(), "", "-o", "a"}, "weftlight export: FILES: the name is empty\n"},
  };
  for (const auto& [args, said] : cases) {
    const Ran ran = run(args);
    EXPECT_EQ(ran.code, kUsage) << ::testing::PrintToString(args);
    EXPECT_EQ(ran.said.substr(0, ran.said.find('\n') + 1), said);
  }
}

TEST(ParserTexts, an_unknown_drape_is_answered_with_those_there_are) {
  const std::string forms = "sphere, tablecloth, curtain, skirt, tunic, shirt, scarf, cushion";
  const std::string what = "no drape is called 'tent'; give one of plane, " + forms;
  for (const char* verb : {"render", "reference", "export"}) {
    const Ran ran = run({verb, draft(), "-o", "a.png", "--mesh", "tent"});
    EXPECT_EQ(ran.code, kUsage) << verb;
    EXPECT_TRUE(ran.said.starts_with("weftlight " + std::string(verb) + ": --mesh: " + what +
                                     ", or the path of a .glb or .gltf file\n"))
        << ran.said;
  }
  const Ran drape = run({"drape", "tent", "-o", "a.glb"});
  EXPECT_EQ(drape.code, kUsage);
  EXPECT_EQ(drape.said, "weftlight: " + what + ", all, or the path of a draft\n");
  const Ran fabric = run({"drape", draft(), "-o", "a.glb", "--mesh", "plane"});
  EXPECT_EQ(fabric.code, kUsage);
  EXPECT_EQ(fabric.said, "weftlight: --mesh plane: a fabric is draped as one of " + forms + "\n");
}

TEST(ParserTexts, two_dashes_end_the_options) {
  for (const Args& args : std::vector<Args>{{"info", "--", "--none.wif"},
                                            {"drawdown", "--face", "back", "--", "--none.wif"},
                                            {"export", "-o", "a", "--", "--none.wif"}}) {
    const Ran ran = run(args);
    EXPECT_EQ(ran.code, kBadInput) << ran.said;
    EXPECT_TRUE(ran.said.starts_with("--none.wif: ")) << ran.said;
  }
}

TEST(ParserTexts, a_fraction_may_be_a_percentage) {
  const auto shrunk = [](const char* by) { return run({"analyse", draft(), "--shrinkage", by}); };
  EXPECT_EQ(shrunk("12%").out, shrunk("0.12").out);
  EXPECT_NE(shrunk("12%").out, shrunk("0.08").out);
  for (const char* wrong : {"95%", "%", "-1%", "8%%", "x%"}) EXPECT_EQ(shrunk(wrong).code, kUsage) << wrong;
  EXPECT_EQ(run({"analyse", draft(), "--ends-per-cm", "12%"}).code, kUsage);
}

TEST(ParserTexts, a_number_is_finite_and_may_have_a_sign) {
  for (const char* number : {"nan", "inf", "-inf", "", "1e999", "12 miles"})
    EXPECT_EQ(run({"analyse", draft(), "--length", number}).code, kUsage) << number;
  for (const char* number : {"+100", "1e2", "100.5", "12cm", "20in"})
    EXPECT_EQ(run({"analyse", draft(), "--length", number}).code, kDone) << number;
}

TEST(ParserTexts, help_shows_options_as_they_are_typed) {
  const std::string help = run({"print", "--help"}).out;
  for (const char* line :
       {"Usage: weftlight print [OPTIONS] FILE\n", "\n  FILE                        Draft\n",
        "\n  -o, --output FILE (required)\n                              Output file: .pdf, .svg or .png\n",
        "\n  --paper a4|a3|a5|letter|legal\n                              Paper size; default: a4\n",
        "\n  --scale 0.5..20             Side of a grid cell in mm"})
    EXPECT_NE(help.find(line), std::string::npos) << line << help;
  const std::string join = run({"join", "--help"}).out;
  EXPECT_NE(join.find("\n  --picks A:B "), std::string::npos) << join;
  for (const char* verb : names_of_verbs()) {
    const std::string all = run({verb, "--help"}).out;
    EXPECT_FALSE(all.ends_with("\n\n\n")) << verb << ": an empty line for an option that is hidden";
    std::istringstream lines(all);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), 110u) << line;
      for (const char* word : {"TEXT", "FLOAT", "INT", "not with:"})
        EXPECT_EQ(line.find(word), std::string::npos) << line;
    }
  }
}

}  // namespace
}  // namespace weftlight::commands
