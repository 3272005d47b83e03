// Lists of yarns, and tidy palettes, from the command line.

#include "design/edits.h"
#include "design/fibre.h"
#include "scratch_folder.h"
#include "wif/wif.h"

namespace weftlight::commands {

using base::read_file;
using design::Design, design::Yarn, design::with_count, design::with_new_palette_color, design::with_new_yarn;
using wif::read_wif, wif::write_new_wif;

namespace {

class YarnVerbs : public ScratchFolder {
 protected:
  static Design twill() { return read_wif(read_file(fixture_path("twill.wif")).value_or("")).file->design; }
  Design read(const std::string& name) const {
    const wif::WifRead made = read_wif(read_file(path(name)).value_or(""));
    EXPECT_TRUE(made.file.has_value()) << name;
    return made.file ? made.file->design : Design{};
  }
};

TEST_F(YarnVerbs, yarns_of_drafts_and_lists_become_one_list) {
  Design d = twill();
  d.yarns[0] = *with_count(d.yarns[0], "Ne 16/2");
  d.yarns[0].name = "Bockens";
  const std::string draft = written("d.wif", write_new_wif(d));
  const std::string list = written("more.txt", "[Yarn]\nName=Tuna\nCount=Nm 6/2\nFibre=Wool\nPrice=7\nShade=3\n");
  const Ran printed = run({"yarns", draft, list});
  EXPECT_EQ(printed.code, kDone) << printed.said;
  EXPECT_NE(printed.out.find("Ne 16/2"), std::string::npos) << printed.out;
  EXPECT_NE(printed.out.find("7.00 /kg"), std::string::npos) << printed.out;
  EXPECT_NE(printed.said.find("more.txt:6: "), std::string::npos) << printed.said;
  ASSERT_EQ(run({"yarns", draft, list, "-o", path("all.txt")}).code, kDone);
  const std::string all = read_file(path("all.txt")).value_or("");
  EXPECT_LT(all.find("Name=Bockens"), all.find("Name=Tuna"));
  EXPECT_NE(all.find("Shade=3"), std::string::npos);
  EXPECT_EQ(run({"yarns", written("no.txt", "Tuna, 6/2\n")}).code, kBadInput);
  EXPECT_EQ(run({"yarns", path("missing.txt")}).code, kBadInput);
}

TEST_F(YarnVerbs, convert_tidies_colours_and_yarns) {
  Design d = twill();
  const auto cloth = [](const Design& of, draft::System system) {
    std::vector<draft::Rgb> colors;
    for (const int i : of.draft.threads(system).color) colors.push_back(of.draft.palette[static_cast<size_t>(i)]);
    return colors;
  };
  const draft::Rgb first = d.draft.palette[0];
  d = with_new_palette_color(std::move(d), first);
  d = with_new_yarn(with_new_palette_color(std::move(d), {0.5f, 0.1f, 0.9f}), Yarn{});
  d.draft.warp.color[0] = static_cast<int>(d.draft.palette.size()) - 2;
  const std::string in = written("in.wif", write_new_wif(d));
  ASSERT_EQ(run({"convert", in, path("out.wif"), "--tidy"}).code, kDone);
  const Design out = read("out.wif"), before = read("in.wif");
  EXPECT_EQ(out.yarns.size(), 1u);
  EXPECT_LE(out.draft.palette.size(), before.draft.palette.size() - 2);
  for (const draft::System system : {draft::System::kWarp, draft::System::kWeft})
    EXPECT_EQ(cloth(out, system), cloth(before, system));
}

}  // namespace
}  // namespace weftlight::commands
