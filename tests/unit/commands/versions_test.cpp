// Versions and pictures from the command line: the same choices as in the dialogs.

#include "design/versions.h"

#include "files/files.h"
#include "scratch_folder.h"
#include "wif/wif.h"

namespace weftlight::commands {

using base::read_file;
using design::with_version;
using files::Image, files::PixelType, files::write_image;
using wif::read_wif, wif::write_new_wif;

namespace {

class VersionVerbs : public ScratchFolder {
 protected:
  Design read(const std::string& name) {
    const wif::WifRead made = read_wif(read_file(path(name)).value_or(""));
    EXPECT_TRUE(made.file.has_value()) << name;
    return made.file ? made.file->design : Design{};
  }
  /// The twill, and a red colourway of it.
  std::string two_colourways() {
    Design d = read_wif(read_file(fixture_path("twill.wif")).value_or("")).file->design;
    d = with_version(std::move(d), "Navy");
    d.draft.palette[1] = {0.8f, 0, 0};
    return written("twill.wif", write_new_wif(with_version(std::move(d), "Red, bold")));
  }
};

TEST_F(VersionVerbs, convert_takes_a_version_by_its_name) {
  const std::string file = two_colourways();
  ASSERT_EQ(run({"convert", file, path("navy.wif"), "--take-version", "navy"}).code, kDone);
  EXPECT_EQ(read("navy.wif").draft, read("twill.wif").versions[0].design->draft);
  EXPECT_EQ(read("navy.wif").versions.size(), 2u);
  const Ran none = run({"convert", file, path("green.wif"), "--take-version", "Green"});
  EXPECT_EQ(none.code, kBadInput);
  EXPECT_NE(none.said.find("Navy, Red, bold"), std::string::npos) << none.said;
  EXPECT_NE(run({"info", file}).out.find("Red, bold"), std::string::npos);
}

TEST_F(VersionVerbs, export_makes_a_set_of_each) {
  const Ran made = run({"export", two_colourways(), "-o", path("sets"), "--size", "16", "--versions", "--quiet"});
  ASSERT_EQ(made.code, kDone) << made.said;
  for (const char* set : {"twill", "twill-Navy", "twill-Red_bold"})
    EXPECT_TRUE(std::filesystem::is_directory(path("sets") + "/" + set)) << set;
}

TEST_F(VersionVerbs, convert_weaves_a_picture_as_it_is_told) {
  Image picture{30, 10, 3, {}};
  for (int i = 0; i < 300; ++i)
    picture.texels.insert(picture.texels.end(), 3, i % 30 < 10 ? 0.1f : i % 30 < 20 ? 0.5f : 0.9f);
  ASSERT_TRUE(write_image(path("p.png"), picture, PixelType::kU8));
  const std::string in = path("p.png"), out = path("p.wif");
  ASSERT_EQ(run({"convert", in, out, "--crop", "0,0,20,10", "--picks", "16", "--colors", "2", "--weave", "1=plain",
                 "--weave", "2=twill 1/3", "--picture-colors"})
                .code,
            kDone);
  const Design woven = read("p.wif");
  EXPECT_EQ(woven.draft.ends(), 20);
  EXPECT_EQ(woven.draft.picks(), 16);
  EXPECT_LT(woven.draft.palette[0].r, 0.2f);
  EXPECT_NE(woven.draft.liftplan.get(7, 15), woven.draft.liftplan.get(7, 16)) << "plain weave at the left";
  for (const char* weave : {"0=plain", "plain", "1=velvet", "99=plain"})
    EXPECT_EQ(run({"convert", in, out, "--weave", weave}).code, kUsage) << weave;
  EXPECT_EQ(run({"convert", in, out, "--crop", "0,0,20"}).code, kUsage);
  EXPECT_EQ(run({"convert", in, out, "--crop", "20,0,20,10"}).code, kBadInput);
}

}  // namespace
}  // namespace weftlight::commands
