// The files of an exported set: their names, the lists of them, and what happens to files that were there before.

#include "texture_set/texture_set.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <stop_token>

#include "../files/sheet.h"
#include "../scratch.h"
#include "base/json.h"
#include "sample_set.h"
#include "texture_set/material_files.h"

namespace weftlight::texture_set {

using base::problem_of;
using cloth::Cloth, cloth::Period, cloth::lay_out;
using design::Design, design::Yarn;
using draft::Face, draft::System, draft::drawdown;
using drape::Mesh, drape::sheet;
using files::Image, files::MipFormat, files::read_image;
using weaves::plain;

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class EveryTarget : public testing::TestWithParam<const ExportTarget*> {};
INSTANTIATE_TEST_SUITE_P(All, EveryTarget, testing::ValuesIn(kTargets), [](const auto& target) {
  std::string name = target.param->id;
  std::erase(name, '-');
  return name;
});

/// Root mean square of the difference of two columns (or rows) of an image.
double step_rms(const Image& image, bool columns, int a, int b) {
  const int count = columns ? image.height : image.width;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    for (int c = 0; c < image.channels; ++c) {
      auto at = [&](int k) {
        const int x = columns ? k : i, y = columns ? i : k;
        return static_cast<double>(image.texels[static_cast<size_t>((y * image.width + x) * image.channels + c)]);
      };
      sum += (at(a) - at(b)) * (at(a) - at(b));
    }
  }
  return std::sqrt(sum / (count * image.channels));
}

void expect_seamless(const Image& image, const std::string& file) {
  for (bool columns : {true, false}) {
    const int n = columns ? image.width : image.height;
    double most = 0;
    for (int k = 0; k + 1 < n; ++k) most = std::max(most, step_rms(image, columns, k, k + 1));
    EXPECT_LE(step_rms(image, columns, n - 1, 0), 1.05 * most + 1e-3)
        << file << (columns ? ": left and right" : ": top and bottom");
  }
}

TEST_P(EveryTarget, IsCompleteSeamlessAndListed) {
  const ExportTarget& target = *GetParam();
  const Scratch scratch(std::string("set-") + target.id);
  const std::string folder = scratch / "sample";
  ASSERT_EQ(problem_of(write_texture_set(folder, sample_design(), sheet(), options_for(target))), "");
  const json list = list_of(folder);
  EXPECT_EQ(list["target"], target.id);
  EXPECT_EQ(list["source"], "sample.wif");
  EXPECT_EQ(list["program"], "weftlight 1.2.3");
  EXPECT_GT(list["size_mm"][0], 0);
  EXPECT_GT(list["size_mm"][0], list["size_mm"][1]);
  EXPECT_EQ(list["size_texels"][0], 128);
  const auto mipped = static_cast<size_t>(std::ranges::count_if(
      target.images, [&](const ImageRow& row) { return has_mips(row, mips_for(target, std::nullopt)); }));
  const size_t factors = list.contains("factors") ? list["factors"].size() : 0;
  EXPECT_EQ(list["maps"].size() + factors, (target.images.size() + mipped) * 2 + (target.raw ? 6 : 0));
  std::set<std::string> expected{"texture_set.json"}, named{"README.md", "contact_sheet.png"};
  for (const json& map : list["maps"]) {
    const std::string file = map["file"];
    named.insert(file);
    const base::Result<Image> read = read_image(folder + "/" + file);
    ASSERT_TRUE(read) << problem_of(read);
    EXPECT_EQ(read->width, map["width"]);
    EXPECT_EQ(read->height, map["height"]);
    EXPECT_EQ(read->channels, static_cast<int>(map["channels"].size())) << file;
    if (file.find("_thread") == std::string::npos) expect_seamless(*read, file);
    for (float v : read->texels) ASSERT_TRUE(std::isfinite(v)) << file;
  }
  if (list.contains("material")) named.insert(list["material"]);
  for (const json& file : list["files"]) expected.insert(file);
  for (const std::string& file : named) EXPECT_TRUE(expected.contains(file)) << file;
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder)) found.insert(entry.path().filename());
  EXPECT_EQ(found, expected);
  std::ifstream readme(folder + "/README.md");
  EXPECT_EQ(std::count(std::istreambuf_iterator<char>(readme), {}, '\n'), mipped > 0 ? 5 : 4);
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.folder), {}), 1) << "a temporary file remains";
}

TEST(TextureSet, NamesAreThoseOfTheEngines) {
  const Scratch scratch("names");
  ASSERT_EQ(problem_of(write_texture_set(scratch / "u", sample_design(), sheet(), options_for(targets::kUnreal, 32))),
            "");
  for (const char* file : {"T_sample_BC.png", "T_sample_N.png", "T_sample_ORM.png"})
    EXPECT_TRUE(fs::exists(scratch / ("u/" + std::string(file)))) << file;
}

TEST(TextureSet, SizesArePowersOfTwoNearTheProportions) {
  EXPECT_EQ(texture_size(10, 10, 512).height, 512);
  EXPECT_EQ(texture_size(10, 5, 512).height, 256);
  EXPECT_EQ(texture_size(3, 10, 512).width, 128);
  EXPECT_EQ(texture_size(0.001f, 10, 512).width, 16);
}

TEST(TextureSet, FileNamesAreSafe) {
  EXPECT_EQ(file_name_of("My draft (2)"), "My_draft_2");
  EXPECT_EQ(file_name_of("../../etc"), "etc");
  EXPECT_EQ(file_name_of("..."), "cloth");
  EXPECT_EQ(file_name_of("con"), "cloth_con");
  EXPECT_EQ(file_name_of("LPT1"), "cloth_LPT1");
  EXPECT_EQ(file_name_of("console"), "console");
  EXPECT_EQ(file_name_of("a\xFFz"), "a_z");
}

// A draft in another language was called "cloth", or "hm" of "\u00E4hm".
TEST(TextureSet, FileNamesKeepWhatTellsDraftsApart) {
  EXPECT_EQ(file_name_of("K\xC3\xB6per & Co."), "Koper_Co");
  EXPECT_EQ(file_name_of("Ko\xCC\x88per"), "Koper");  // the letter and its mark
  EXPECT_EQ(file_name_of("\xC3\xA5 stra\xC3\x9F"
                         "e"),
            "a_strasse");
  EXPECT_EQ(file_name_of("2 \xE2\x80\x93 3"), "2_3");
  const std::string twill = file_name_of("\xE7\xB6\xBE"), weave = file_name_of("\xE7\xB9\x94");
  EXPECT_TRUE(twill.starts_with("cloth_")) << twill;
  EXPECT_EQ(twill.size(), std::string("cloth_123456").size());
  EXPECT_NE(twill, weave);
  EXPECT_EQ(file_name_of(twill), twill);
  EXPECT_TRUE(file_name_of("denim \xE7\xB6\xBE").starts_with("denim_"));
  EXPECT_LT(file_name_of(std::string(500, 'x') + "\xE7\xB6\xBE").size(), 100u);
}

TEST(TextureSet, ForeignFilesAreNotTouched) {
  const Scratch scratch("others");
  fs::create_directories(scratch / "mine");
  std::ofstream(scratch / "mine/letter.txt") << "dear";
  EXPECT_FALSE(write_texture_set(scratch / "mine", sample_design(), sheet(), options_for(targets::kGltf, 32)));
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch / "mine"), {}), 1);
  TextureSetOptions force = options_for(targets::kGltf, 32);
  force.force = true;
  EXPECT_EQ(problem_of(write_texture_set(scratch / "mine", sample_design(), sheet(), force)), "");
  EXPECT_TRUE(fs::exists(scratch / "mine/letter.txt"));
}

TEST(TextureSet, OnlyFilesListedByTheSameSetAreReplaced) {
  const Scratch scratch("same");
  const TextureSetOptions options = options_for(targets::kGltf, 32);
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), sheet(), options)), "");
  // A foreign file is beside the set; an older version of the set had one more image.
  std::ofstream(scratch / "set/scene.blend") << "work";
  json list = list_of(scratch / "set");
  std::ofstream(scratch / "set/sample_old.png") << "old";
  list["files"].push_back("sample_old.png");
  std::ofstream(scratch / "set/texture_set.json") << list;
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), sheet(), options)), "");
  EXPECT_TRUE(fs::exists(scratch / "set/scene.blend"));
  EXPECT_FALSE(fs::exists(scratch / "set/sample_old.png"));
  // A file that is not listed is foreign, whatever its name.
  list = list_of(scratch / "set");
  list["files"].erase(std::find(list["files"].begin(), list["files"].end(), "sample_orm.png"));
  std::ofstream(scratch / "set/texture_set.json") << list;
  std::ofstream(scratch / "set/sample_orm.png") << "painted over";
  EXPECT_FALSE(write_texture_set(scratch / "set", sample_design(), sheet(), options));
  EXPECT_EQ(fs::file_size(scratch / "set/sample_orm.png"), 12u);
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.folder), {}), 1) << "a temporary file remains";
}

TEST(TextureSet, OtherSetsAreNotReplaced) {
  const Scratch scratch("sets");
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), sheet(), options_for(targets::kUnreal, 32))),
            "");
  EXPECT_FALSE(check_set_folder(scratch / "set", options_for(targets::kGltf, 32)));
  EXPECT_FALSE(write_texture_set(scratch / "set", sample_design(), sheet(), options_for(targets::kGltf, 32)));
  TextureSetOptions namesake = options_for(targets::kUnreal, 32);
  namesake.draft_path = "other/sample.wif";
  EXPECT_FALSE(write_texture_set(scratch / "set", sample_design(), sheet(), namesake));
  namesake.force = true;
  EXPECT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), sheet(), namesake)), "");
}

TEST(TextureSet, AStoppedExportIsCancelledAndKeepsTheOldSet) {
  const Scratch scratch("stopped");
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), sheet(), options_for(targets::kGltf, 32))),
            "");
  std::stop_source source;
  source.request_stop();
  const auto stopped = write_texture_set(scratch / "set", sample_design(), sheet(), options_for(targets::kGltf, 64),
                                         {{}, source.get_token()});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, base::ErrorKind::kCancelled) << problem_of(stopped);
  EXPECT_EQ(list_of(scratch / "set")["size_texels"][0], 32);
}

TEST(TextureSet, AFailedExportKeepsTheOldSet) {
  const Scratch scratch("failure");
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), sheet(), options_for(targets::kGltf, 32))),
            "");
  Mesh broken = sheet();
  broken.index[0] = 1000;
  TextureSetOptions larger = options_for(targets::kGltf, 64);
  EXPECT_FALSE(write_texture_set(scratch / "set", sample_design(), broken, larger));
  EXPECT_EQ(list_of(scratch / "set")["size_texels"][0], 32);
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.folder), {}), 1);
}

TEST(TextureSet, BandsHaveNoSeams) {
  // The face is larger than one piece may be.
  Design design = sample_design();
  const Cloth cloth = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
  FaceOptions options;
  options.size = {2048, 2048};
  options.footprint_mm = 0.8f;
  const FaceSource source(Tile{cloth}, options);
  ASSERT_LT(source.band(), 2048);
  const SurfaceTexels a = source.rows(0, source.band()), b = source.rows(source.band(), 2 * source.band());
  // Rows across the border of two bands differ no more than rows within a band.
  const auto apart = [](const SurfaceTexels& p, int y, const SurfaceTexels& q, int z) {
    double sum = 0;
    for (int x = 0; x < p.texels.width; ++x) {
      const SurfaceTexel &s = p.texels.at(x, y), &t = q.texels.at(x, z);
      sum += std::abs(static_cast<double>(s.base.g - t.base.g)) +
             std::abs(static_cast<double>(s.occlusion - t.occlusion)) +
             std::abs(static_cast<double>(s.slope_cov[0] - t.slope_cov[0]));
    }
    return sum;
  };
  const int last = a.texels.height - 1;
  const double within = 0.5 * (apart(a, last - 1, a, last) + apart(b, 0, b, 1));  // on both sides of the border
  EXPECT_LT(apart(a, last, b, 0), 1.5 * within + 1);
}

TEST(TextureSet, EveryTargetHasTheSameScale) {
  const Mesh quad = scale_quad();
  for (size_t i = 0; i < 4; ++i) {
    const size_t j = (i + 1) % 4;
    const double along = std::hypot(static_cast<double>(quad.position_mm[j][0] - quad.position_mm[i][0]),
                                    static_cast<double>(quad.position_mm[j][1] - quad.position_mm[i][1]));
    const double uv = std::hypot(static_cast<double>(quad.uv_mm[j][0] - quad.uv_mm[i][0]),
                                 static_cast<double>(quad.uv_mm[j][1] - quad.uv_mm[i][1]));
    EXPECT_NEAR(along, uv, 1e-3);
  }
  // The files of all engines have the same scale.
  const Scratch scratch("scale");
  const Cloth cloth = lay_out(sample_design(), drawdown(sample_design().draft), Face::kFront, Period::kRepeat);
  const std::string scale = number(1 / static_cast<double>(cloth.width_mm));
  const auto holds = [&](const ExportTarget& target, const std::string& file, const std::string& text) {
    const std::string folder = scratch / target.id;
    ASSERT_EQ(problem_of(write_texture_set(folder, sample_design(), sheet(), options_for(target, 32))), "");
    std::ifstream in(folder + "/" + file);
    const std::string all{std::istreambuf_iterator<char>(in), {}};
    EXPECT_NE(all.find(text), std::string::npos) << file << " lacks " << text;
  };
  holds(targets::kGodot, "sample.tres", "uv_scale = Vector2(" + scale);
  holds(targets::kUnityUrp, "sample.mat", "m_Scale: {x: " + scale);
  holds(targets::kUnreal, "sample_import.py", "TILING = (" + scale);
  holds(targets::kBlender, "sample.py", "TILING = (" + scale);
  holds(targets::kMaterialX, "sample.mtlx", "value=\"" + scale);
  holds(targets::kMaterialX, "sample_openpbr.usda", "sample.mtlx");
}

TEST(TextureSet, UnityImportSettingsMatchTheMaps) {
  const Scratch scratch("unity-maps");
  for (const ExportTarget* target : {&targets::kUnityUrp, &targets::kUnityHdrp}) {
    const std::string folder = scratch / target->id;
    ASSERT_EQ(problem_of(write_texture_set(folder, sample_design(), {}, options_for(*target, 32))), "");
    for (const json& map : list_of(folder)["maps"]) {
      const std::string file = map["file"], meta = text_of(folder + "/" + file + ".meta");
      EXPECT_NE(meta.find(map["color_space"] == "sRGB" ? "sRGBTexture: 1\n" : "sRGBTexture: 0\n"), std::string::npos)
          << file;
      const bool normal = file.find("_Normal") != std::string::npos;
      EXPECT_NE(meta.find(normal ? "textureType: 1\n" : "textureType: 0\n"), std::string::npos) << file;
    }
  }
}

// Godot averages encoded colours and draws its own hashed transparency opaque in its Compatibility renderer.
TEST(TextureSet, GodotGetsItsMipsAndATransparencyThatAllItsRenderersHave) {
  const Scratch scratch("godot");
  for (const Alpha alpha : {Alpha::kBlend, Alpha::kHashed}) {
    TextureSetOptions options = options_for(targets::kGodot, 32);
    options.alpha = alpha;
    ASSERT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), sheet(), options)), "");
    const std::string material = text_of(scratch / "set/sample.tres");
    const std::string shader = text_of(scratch / "set/sample.gdshader");
    const bool blended = alpha == Alpha::kBlend;
    EXPECT_EQ(shader.find("depth_prepass_alpha;") != std::string::npos, blended) << shader;
    EXPECT_EQ(shader.find("ALPHA = albedo.a;") != std::string::npos, blended) << shader;
    EXPECT_EQ(shader.find("discard;") != std::string::npos, !blended) << shader;
    EXPECT_NE(material.find("path=\"sample_albedo.dds\""), std::string::npos) << material;
    EXPECT_NE(material.find("path=\"sample_orm.png\""), std::string::npos) << material;
    EXPECT_TRUE(fs::exists(scratch / "set/sample_albedo.dds"));
  }
  TextureSetOptions all = options_for(targets::kGodot, 32);
  all.mips = MipFormat::kDds;
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), sheet(), all)), "");
  EXPECT_NE(text_of(scratch / "set/sample.tres").find("path=\"sample_back_normal.dds\""), std::string::npos);
}

TEST(TextureSet, UnityMaterialsNameTheMipsThatTheSetHas) {
  const Scratch scratch("unity-mips");
  const auto guid_in = [&](const std::string& file) {
    const std::string text = text_of(scratch / "set/" + file);
    const size_t at = text.find("guid: ");
    return at == std::string::npos ? file + " has none" : text.substr(at + 6, 32);
  };
  for (const bool mips : {true, false}) {
    TextureSetOptions options = options_for(targets::kUnityUrp, 32);
    if (mips) options.mips = MipFormat::kDds;
    ASSERT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), sheet(), options)), "");
    const std::string image = std::string("sample_BaseMap") + (mips ? ".dds.meta" : ".png.meta");
    EXPECT_NE(text_of(scratch / "set/sample.mat").find(guid_in(image)), std::string::npos) << image;
    EXPECT_EQ(fs::exists(scratch / "set/sample_BaseMap.dds.meta"), mips);
  }
}

/// Matt threads without metal, a repeat far smaller than a pixel at one metre.
Design fine_plain() {
  Design design = plain({2, 2});
  for (Yarn& yarn : design.yarns) yarn.lobes.fuzz = 0;
  return design;
}

TEST(TextureSet, ConstantMapsAreFactorsOrSmall) {
  const Scratch scratch("constant");
  ASSERT_EQ(problem_of(write_texture_set(scratch / "gltf", fine_plain(), sheet(), options_for(targets::kGltf, 64))),
            "");
  EXPECT_FALSE(fs::exists(scratch / "gltf/sample_sheen.png")) << "black, and no material names it";
  const json gltf = json::parse(text_of(scratch / "gltf/sample.gltf")), list = list_of(scratch / "gltf");
  EXPECT_EQ(list["factors"][0]["image"], "sample_sheen.png");
  for (const float value : list["factors"][0]["values"]) EXPECT_LE(value, 1);
  for (const json& image : gltf["images"]) EXPECT_TRUE(fs::exists(scratch / "gltf/" + image["uri"].get<std::string>()));

  TextureSetOptions options = options_for(targets::kBlender, 64);
  ASSERT_EQ(problem_of(write_texture_set(scratch / "blender", fine_plain(), sheet(), options)), "");
  const base::Result<Image> metal = read_image(scratch / "blender/sample_metallic.png"),
                            color = read_image(scratch / "blender/sample_basecolor.png");
  ASSERT_TRUE(metal && color);
  EXPECT_EQ(metal->width, 16);
  EXPECT_EQ(color->width, 64);
  for (const json& map : list_of(scratch / "blender")["maps"])
    EXPECT_EQ(map["width"], read_image(scratch / "blender/" + map["file"].get<std::string>())->width) << map["file"];
}

TEST(TextureSet, FarLevelsOfDetailHaveTheSameColoursAndOneMaterial) {
  const Design design = sample_design();
  const TextureSetOptions near = options_for(targets::kGltf, 1024), middle = at_lod(near, 1), far = at_lod(near, 2);
  EXPECT_EQ(far.name, "sample-lod2");
  EXPECT_EQ(far.size, 64);
  EXPECT_NE(key_of(far), key_of(near));
  const FaceSource at_hand = face_at(design, Face::kFront, near, 1024),
                   mid = face_at(design, Face::kFront, middle, 1024), afar = face_at(design, Face::kFront, far, 1024);
  const auto is_near = [](const Linear& a, const Linear& b) {
    return std::abs(a.r - b.r) < 0.04f && std::abs(a.g - b.g) < 0.04f && std::abs(a.b - b.b) < 0.04f;
  };
  EXPECT_TRUE(is_near(mid.mean_base(), at_hand.mean_base()));
  EXPECT_TRUE(is_near(afar.mean_base(), at_hand.mean_base()));
  EXPECT_NEAR(afar.coverage(), at_hand.coverage(), 0.01f);
  for (const FaceSource* face : {&mid, &afar})
    for (const EngineScore& s : face->scores())
      if (s.view_deg < 65) {
        EXPECT_NEAR(s.mean, 1, 0.15f) << s.view_deg;
      }
  const SurfaceTexels all = afar.rows(0, afar.size().height);
  const SurfaceTexel& first = all.texels.at_[0];
  bool one_colour = true;
  for (const SurfaceTexel& t : all.texels.at_) {
    ASSERT_EQ(t.normal, glm::vec3(0, 0, 1));
    ASSERT_EQ(t.slope_cov, first.slope_cov);
    ASSERT_EQ(t.metal, first.metal);
    ASSERT_EQ(t.sheen, first.sheen);
    one_colour &= t.base == first.base;
  }
  EXPECT_FALSE(one_colour) << "the pattern stays";
  EXPECT_NEAR(first.metal, at_hand.means().metal, 0.02) << "of 16 ends two are of metal, on a part of the face";
}

// HDRP maps smoothness and normal from 0..1 to -1..1 and adds them to those of the base material.
TEST(TextureSet, HdrpThreadMapIsNeutralOnAverage) {
  const Scratch scratch("thread-map");
  ASSERT_EQ(problem_of(write_texture_set(scratch / "h", sample_design(), {}, options_for(targets::kUnityHdrp, 128))),
            "");
  const Image map = *read_image(scratch / "h/sample_ThreadMap.png");
  ASSERT_EQ(map.channels, 4);
  std::array<double, 4> mean{};
  for (size_t i = 0; i < map.texels.size(); ++i)
    mean[i % 4] += static_cast<double>(map.texels[i]) / (map.width * map.height);
  EXPECT_GT(mean[0], 0.9) << "occlusion multiplies";
  EXPECT_NEAR(mean[1], 0.5, 0.02) << "normal, y";
  EXPECT_NEAR(mean[2], 0.5, 0.01) << "smoothness";
  EXPECT_NEAR(mean[3], 0.5, 0.02) << "normal, x";
  EXPECT_NE(text_of(scratch / "h/README.md").find("ThreadMap is for the thread slot of HDRP/Fabric"),
            std::string::npos);
}

/// Unity's inspector sets these, but an import does not: without them a blended material is drawn opaque.
TEST(TextureSet, UnityMaterialsSetBlending) {
  const Scratch scratch("unity");
  TextureSetOptions options = options_for(targets::kUnityUrp, 32);
  const auto material = [&](const ExportTarget* target, Alpha alpha) {
    options.target = target, options.alpha = alpha;
    const std::string folder = scratch / (std::string(target->id) + alpha_name(alpha));
    EXPECT_EQ(problem_of(write_texture_set(folder, sample_design(), {}, options)), "");
    return text_of(folder + "/sample.mat");
  };
  for (const ExportTarget* target : {&targets::kUnityUrp, &targets::kUnityHdrp}) {
    const std::string blended = material(target, Alpha::kBlend), opaque = material(target, Alpha::kOpaque),
                      cut = material(target, Alpha::kMask);
    for (const char* line : {"RenderType: Transparent\n", "_DstBlend: 10\n", "_ZWrite: 0\n"})
      EXPECT_NE(blended.find(line), std::string::npos) << line;
    for (const char* line : {"RenderType: Opaque\n", "_DstBlend: 0\n", "_ZWrite: 1\n"})
      EXPECT_NE(opaque.find(line), std::string::npos) << line;
    EXPECT_NE(cut.find("RenderType: TransparentCutout\n"), std::string::npos);
  }
}

TEST(TextureSet, WarnsIfTheGapsOfAMaskWouldClose) {
  Design design = plain({2, 2});
  TextureSetOptions options = options_for(targets::kGltf, 128);
  options.alpha = Alpha::kMask;
  EXPECT_TRUE(warnings_of(design, options).empty()) << "a dense cloth";
  for (System s : {System::kWarp, System::kWeft}) design.draft.threads(s).spacing_mm.assign(2, 1.2f);
  EXPECT_EQ(warnings_of(design, options).size(), 1u);
  options.target = &targets::kUnreal;
  EXPECT_TRUE(warnings_of(design, options).empty()) << "its importer keeps the coverage";
}

TEST(TextureSet, MipmapsThatTheMaterialDoesNotNameKeepNoMask) {
  Design design = plain({2, 2});
  for (System s : {System::kWarp, System::kWeft}) design.draft.threads(s).spacing_mm.assign(2, 1.2f);
  TextureSetOptions options = options_for(targets::kGltf, 128);
  options.alpha = Alpha::kMask;
  const auto warning = [&](const ExportTarget& target, std::optional<MipFormat> mips) {
    options.target = &target, options.mips = mips;
    const std::vector<std::string> all = warnings_of(design, options);
    return all.empty() ? std::string() : all.at(0);
  };
  for (const ExportTarget* target : {&targets::kGltf, &targets::kMaterialX, &targets::kU3m})
    for (const auto mips : {std::optional<MipFormat>(), {MipFormat::kDds}, {MipFormat::kKtx2Blocks}}) {
      const std::string said = warning(*target, mips);
      EXPECT_NE(said.find("--alpha auto"), std::string::npos) << target->id;
      EXPECT_EQ(said.find("--mips"), std::string::npos) << target->id << said;
    }
  EXPECT_EQ(warning(targets::kGodot, {}), "") << "its material names the .dds of the colours";
  EXPECT_EQ(warning(targets::kGodot, MipFormat::kDds), "");
  EXPECT_NE(warning(targets::kGodot, MipFormat::kKtx2).find("--mips dds"), std::string::npos);
}

TEST(TextureSet, TilesOfSeveralRepeats) {
  const Design design = sample_design();
  const Cloth one = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
  const Cloth many = tiled(one, 3, 2);
  EXPECT_FLOAT_EQ(many.width_mm, 3 * one.width_mm);
  EXPECT_EQ(many.picks.size(), 2 * one.picks.size());
  EXPECT_EQ(many.up.get(5, 20), one.up.get(5 % one.up.rows(), 20 % one.up.cols()));
  TextureSetOptions options = options_for(targets::kGltf, 16);
  EXPECT_EQ(warnings_of(design, options).size(), 1u) << "16 ends in 16 texels";
  options.size = 128;
  EXPECT_TRUE(warnings_of(design, options).empty());
  options.tile_mm = 50;
  set_density(options, design, 20);
  EXPECT_GE(static_cast<float>(options.size), 20 * 50.0f);
}

// The shorter side had as little as 0.7 of it, and 8192 texels were too few without a word.
TEST(TextureSet, DensityIsTheLeastOfBothSides) {
  const Design design = sample_design();
  for (const float texels_per_mm : {3.0f, 5.0f, 7.0f, 11.0f, 16.0f, 23.0f}) {
    TextureSetOptions options = options_for(targets::kGltf, 16);
    for (const float tile_mm : {0.0f, 7.0f, 13.0f}) {
      options.tile_mm = tile_mm;
      set_density(options, design, texels_per_mm);
      const SetFigures made = figures_of(design, options);
      EXPECT_GE(static_cast<float>(made.size.width), texels_per_mm * made.width_mm);
      EXPECT_GE(static_cast<float>(made.size.height), texels_per_mm * made.depth_mm);
      EXPECT_TRUE(warnings_of(design, options).empty() || texels_per_mm < 7);
    }
  }
  TextureSetOptions options = options_for(targets::kGltf, 16);
  options.tile_mm = 50;
  set_density(options, design, 1000);
  EXPECT_EQ(options.size, 8192);
  ASSERT_EQ(warnings_of(design, options).size(), 1u);
  EXPECT_NE(warnings_of(design, options)[0].find("and 1000 were asked for"), std::string::npos);
}

TEST(TextureSet, TheSameBytesEveryTime) {
  const Scratch scratch("again");
  for (const ExportTarget* target : {&targets::kU3m, &targets::kMaterialX, &targets::kGltf}) {
    const std::string a = scratch / (std::string("a/") + target->id), b = scratch / (std::string("b/") + target->id);
    ASSERT_EQ(problem_of(write_texture_set(a, sample_design(), sheet(), options_for(*target, 32))), "");
    ASSERT_EQ(problem_of(write_texture_set(b, sample_design(), sheet(), options_for(*target, 32))), "");
    for (const auto& entry : fs::directory_iterator(a)) {
      std::ifstream one(entry.path(), std::ios::binary), two(b / entry.path().filename(), std::ios::binary);
      EXPECT_EQ(std::string(std::istreambuf_iterator<char>(one), {}),
                std::string(std::istreambuf_iterator<char>(two), {}))
          << entry.path();
    }
  }
}

TEST(TextureSet, EmptyDraftIsAnError) {
  const Scratch scratch("empty");
  EXPECT_FALSE(write_texture_set(scratch / "set", Design{}, sheet(), options_for(targets::kGltf, 32)));
  EXPECT_TRUE(fs::is_empty(scratch.folder));
}

}  // namespace
}  // namespace weftlight::texture_set
