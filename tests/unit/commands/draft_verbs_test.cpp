// info, drawdown and convert: the contract that scripts and other programs' tests rely on.

#include <gtest/gtest.h>

#include <filesystem>
#include <utility>

#include "base/json.h"
#include "commands/open_design.h"
#include "files/design_drape.h"
#include "files/files.h"
#include "scratch_folder.h"

namespace weftlight::commands {

using base::problem_of, base::read_file, base::write_file_atomically;
using design::Design;
using draft::BitMatrix, draft::Draft, draft::Face, draft::ShedControl, draft::drawdown;
using drape::Mesh;
using files::Image, files::load_design_drape, files::load_drape, files::read_image, files::read_mesh;
using wif::write_new_wif;

namespace {

using DraftVerbs = ScratchFolder;

TEST_F(DraftVerbs, drawdown_text_of_both_faces) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(drawdown_command({fixture_path("luminescence.wif"), "", Face::kFront}), kDone);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "1010\n0101\n0101\n1010\n");
  EXPECT_EQ(drawdown_command({fixture_path("luminescence.wif"), path("back.txt"), Face::kBack}), kDone);
  EXPECT_EQ(read_file(path("back.txt")).value_or(""), "0101\n1010\n1010\n0101\n");
}

TEST_F(DraftVerbs, drawdown_picture) {
  EXPECT_EQ(drawdown_command({fixture_path("twill.wif"), path("cloth.png"), Face::kFront}), kDone);
  EXPECT_EQ(read_file(path("cloth.png")).value_or("").substr(1, 3), "PNG");
}

TEST_F(DraftVerbs, drawdown_picture_is_oriented_like_the_editor) {
  Design design = open_design(fixture_path("twill.wif")).design;
  Draft& d = design.draft;
  d.palette = {{0, 0, 0}, {1, 1, 1}, {1, 0, 0}};
  d.warp.color.assign(d.warp.color.size(), 0), d.weft.color.assign(d.weft.color.size(), 0);
  d.warp.color[1] = 1, d.weft.color[2] = 2;  // end 2 white, pick 3 red
  ASSERT_EQ(problem_of(write_file_atomically(path("odd.wif"), write_new_wif(design))), "");
  ASSERT_EQ(drawdown_command({path("odd.wif"), path("odd.png"), Face::kFront}), kDone);
  const Image image = *read_image(path("odd.png"));
  const BitMatrix cells = drawdown(d);
  for (int pick = 0; pick < d.picks(); ++pick) {
    for (int end = 0; end < d.ends(); ++end) {
      const int x = (d.ends() - 1 - end) * image.width / d.ends(), y = pick * image.height / d.picks();
      const float* t = &image.texels[static_cast<size_t>((y * image.width + x) * image.channels)];
      const int shown = t[1] > 0.5f ? 1 : t[0] > 0.5f ? 2 : 0;
      const int wanted =
          cells.get(pick, end) ? d.warp.color[static_cast<size_t>(end)] : d.weft.color[static_cast<size_t>(pick)];
      EXPECT_EQ(shown, wanted) << "end " << end + 1 << " pick " << pick + 1;
    }
  }
}

TEST_F(DraftVerbs, drawdown_picture_has_the_requested_origin) {
  const auto picture = [&](const char* end1, const char* pick1) {
    EXPECT_EQ(
        run({"drawdown", fixture_path("twill.wif"), "-o", path("way.png"), "--end1", end1, "--pick1", pick1}).code,
        kDone);
    return *read_image(path("way.png"));
  };
  const Image shown = picture("right", "top"), turned = picture("left", "bottom");
  ASSERT_EQ(shown.texels.size(), turned.texels.size());
  const auto texel = [](const Image& i, int x, int y) {
    return i.texels[(static_cast<size_t>(y) * static_cast<size_t>(i.width) + static_cast<size_t>(x)) *
                    static_cast<size_t>(i.channels)];
  };
  for (int y = 0; y < shown.height; ++y)
    for (int x = 0; x < shown.width; ++x)
      ASSERT_EQ(texel(shown, x, y), texel(turned, shown.width - 1 - x, shown.height - 1 - y)) << x << " " << y;
  EXPECT_EQ(run({"drawdown", fixture_path("twill.wif"), "--pick1", "left"}).code, kUsage);
}

TEST_F(DraftVerbs, info_as_json) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(info_command({fixture_path("gaps.wif"), true}), kDone);
  const auto json = nlohmann::json::parse(::testing::internal::GetCapturedStdout());
  EXPECT_EQ(json["ends"], 8);
  EXPECT_EQ(json["picks"], 8);
  EXPECT_EQ(json["shafts"], 4);
  EXPECT_EQ(json["treadles"], 6);
  EXPECT_EQ(json["rising"], true);
  EXPECT_EQ(json["source_program"], "Weftlight");
  EXPECT_EQ(json["title"], "Two and two twill");
  EXPECT_EQ(json["has_liftplan"], false);
  EXPECT_EQ(json["longest_float"]["warp_front"], 2);
  EXPECT_EQ(json["longest_float"]["weft_back"], 2);
  ASSERT_FALSE(json["warnings"].empty());
  for (const auto& warning : json["warnings"]) {
    EXPECT_TRUE(warning.contains("line") && warning.contains("text") && warning.contains("remedy"));
  }
}

TEST_F(DraftVerbs, info_as_json_of_any_text) {
  for (const char* name : {"latin1.wif", "utf8.wif", "utf8_bom.wif"}) {
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(info_command({fixture_path(name), true}), kDone);
    EXPECT_EQ(nlohmann::json::parse(::testing::internal::GetCapturedStdout())["title"], "Körper für Ärmel");
  }
}

TEST_F(DraftVerbs, convert_keeps_the_bytes_also_onto_itself) {
  for (const char* name : {"mixed_ends.wif", "latin1.wif", "untidy.wif", "no_last_end.wif"}) {
    const std::string bytes = read_file(fixture_path(name)).value_or("");
    EXPECT_EQ(convert_command({fixture_path(name), path("copy.wif"), false, ConvertShedControl::kAsIs}), kDone);
    EXPECT_EQ(convert_command({path("copy.wif"), path("copy.wif"), false, ConvertShedControl::kAsIs}), kDone);
    EXPECT_EQ(read_file(path("copy.wif")).value_or(""), bytes) << name;
  }
}

TEST_F(DraftVerbs, convert_changes_the_shed_control_and_keeps_the_drawdown) {
  const BitMatrix cells = drawdown(open_design(fixture_path("heddles.wif")).design.draft);
  for (const bool plain : {false, true}) {
    EXPECT_EQ(convert_command({fixture_path("heddles.wif"), path("lifts.wif"), plain, ConvertShedControl::kLiftplan}),
              kDone);
    EXPECT_EQ(convert_command({path("lifts.wif"), path("treadles.wif"), plain, ConvertShedControl::kTreadling}), kDone);
    const Draft lifts = open_design(path("lifts.wif")).design.draft,
                treadles = open_design(path("treadles.wif")).design.draft;
    EXPECT_EQ(lifts.shed_control, ShedControl::kLiftplan);
    EXPECT_EQ(treadles.shed_control, ShedControl::kTreadling);
    EXPECT_TRUE(drawdown(lifts) == cells && drawdown(treadles) == cells);
  }
}

TEST_F(DraftVerbs, convert_turns_the_cloth_by_a_quarter) {
  ASSERT_EQ(run({"convert", fixture_path("twill.wif"), path("turned.wif"), "--turned"}).code, kDone);
  const BitMatrix before = drawdown(open_design(fixture_path("twill.wif")).design.draft),
                  after = drawdown(open_design(path("turned.wif")).design.draft);
  ASSERT_EQ(after.rows(), before.cols());
  ASSERT_EQ(after.cols(), before.rows());
  for (int p = 0; p < after.rows(); ++p)
    for (int e = 0; e < after.cols(); ++e)
      EXPECT_NE(after.get(p, e), before.get(e, before.cols() - 1 - p)) << "end " << e + 1 << " pick " << p + 1;
}

TEST_F(DraftVerbs, exit_codes_tell_the_kind_of_error) {
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(info_command({path("none.wif"), false}), kBadInput);
  const std::string bad = written("bad.wif", "[WARP]\nThreads=4\n[WEFT]\nThreads=200000\n");
  EXPECT_EQ(drawdown_command({bad, "", Face::kFront}), kBadInput);
  EXPECT_EQ(convert_command({bad, path("out.wif"), false, ConvertShedControl::kAsIs}), kBadInput);
  EXPECT_FALSE(std::filesystem::exists(path("out.wif")));
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find(bad + ":4: "), std::string::npos) << said;
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(convert_command({fixture_path("twill.wif"), path("no/out.wif"), false, ConvertShedControl::kAsIs}),
            kNotWritten);
  EXPECT_EQ(drawdown_command({fixture_path("twill.wif"), path("no/out.png"), Face::kFront}), kNotWritten);
  ::testing::internal::GetCapturedStderr();
}

TEST_F(DraftVerbs, convert_to_a_smaller_loom_fails_or_takes_the_closest_weave) {
  ASSERT_EQ(weave_command({"satin", path("satin.wif"), {"shafts=8"}, 16, 16, false}), kDone);
  EXPECT_EQ(run({"convert", path("satin.wif"), path("eight.wif"), "--shafts", "8", "--treadles", "8"}).code, kDone);
  EXPECT_EQ(open_design(path("eight.wif")).design.draft, open_design(path("satin.wif")).design.draft);
  const Ran refused = run({"convert", path("satin.wif"), path("four.wif"), "--shafts", "4"});
  EXPECT_EQ(refused.code, kBadInput);
  EXPECT_NE(refused.said.find("this needs 8 shafts, but the loom has 4; --closest"), std::string::npos) << refused.said;
  EXPECT_FALSE(std::filesystem::exists(path("four.wif")));
  EXPECT_EQ(run({"convert", path("satin.wif"), path("four.wif"), "--shafts", "4", "--closest"}).code, kDone);
  EXPECT_EQ(run({"convert", path("satin.wif"), path("same.wif"), "--shafts", "4", "--nearest"}).code, kDone)
      << "its earlier name";
  EXPECT_EQ(open_design(path("same.wif")).design.draft, open_design(path("four.wif")).design.draft);
  const Draft four = open_design(path("four.wif")).design.draft;
  EXPECT_LE(four.shafts, 4);
  EXPECT_EQ(four.ends(), 16);
  EXPECT_EQ(run({"convert", path("satin.wif"), path("x.wif"), "--closest"}).code, kUsage);
  EXPECT_EQ(run({"convert", path("satin.wif"), path("x.wif"), "--shafts", "0"}).code, kUsage);
}

/// The lowest y of a mesh, mm.
float lowest(const Mesh& mesh) {
  float y = 1e9f;
  for (const glm::vec3& p : mesh.position_mm) y = std::min(y, p.y);
  return y;
}

TEST_F(DraftVerbs, an_exported_drape_has_the_stiffness_of_its_fabric) {
  const std::string denim = std::string(WEFTLIGHT_SOURCE_DIR) + "/presets/cloths/denim.wif";
  ASSERT_EQ(run({"export", denim, "-o", path("sets"), "--target", "gltf", "--size", "16", "--mesh", "tablecloth"}).code,
            kDone);
  const base::Result<Mesh> exported = read_mesh(path("sets/denim/denim.glb"));
  ASSERT_TRUE(exported) << problem_of(exported);
  Design design = open_design(denim).design;
  design.scene.mesh = "tablecloth";
  EXPECT_NEAR(lowest(*exported), lowest(*load_design_drape(design)), 0.01f);
  EXPECT_GT(std::abs(lowest(*exported) - lowest(*load_drape("tablecloth"))), 1.0f);
}

TEST_F(DraftVerbs, diagonals_of_an_exported_drape_run_along_its_folds_and_a_mesh_file_keeps_its_own) {
  const std::string presets = std::string(WEFTLIGHT_SOURCE_DIR) + "/presets", file = presets + "/meshes/tablecloth.glb";
  for (const auto& [draft, name] : {std::pair{presets + "/cloths/denim.wif", std::string("tablecloth")},
                                    {fixture_path("twill.wif"), "tablecloth"},
                                    {fixture_path("twill.wif"), file}}) {
    const std::string out = path("sets"), set = std::filesystem::path(draft).stem().string();
    // The front of a blended cloth comes last.
    ASSERT_EQ(run({"export", draft, "-o", out, "--alpha", "opaque", "--size", "16", "--mesh", name}).code, kDone);
    const base::Result<Mesh> exported = read_mesh(out + "/" + set + "/" + set + ".glb");
    ASSERT_TRUE(exported) << problem_of(exported);
    Design design = open_design(draft).design;
    design.scene.mesh = name, design.scene.simulated_drape = false;
    Mesh worn = *load_design_drape(design);
    const std::vector<uint32_t> own = worn.index;
    drape::turn_diagonals(worn);
    ASSERT_NE(own, worn.index);
    ASSERT_EQ(exported->index.size(), 2 * own.size()) << "a front and a back";
    const std::vector<uint32_t> front(exported->index.begin(),
                                      exported->index.begin() + static_cast<std::ptrdiff_t>(own.size()));
    EXPECT_TRUE(front == (name == file ? own : worn.index)) << draft << " " << name;
  }
}

}  // namespace
}  // namespace weftlight::commands
