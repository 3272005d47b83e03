#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <set>

#include "../scratch.h"
#include "base/json.h"
#include "files/files.h"
#include "sheet.h"

namespace weftlight::files {

using base::presets_dir, base::problem_of;
using drape::Mesh, drape::Vec3, drape::sheet;

namespace {

using nlohmann::json;

void expect_same(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.position_mm.size(), b.position_mm.size());
  EXPECT_EQ(a.index, b.index);
  for (size_t i = 0; i < a.position_mm.size(); ++i) {
    for (size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(a.position_mm[i][k], b.position_mm[i][k], 1e-4);
      EXPECT_NEAR(a.normal[i][k], b.normal[i][k], 1e-5);
      EXPECT_NEAR(a.tangent[i][k], b.tangent[i][k], 1e-5);
    }
    EXPECT_EQ(a.uv_mm[i], b.uv_mm[i]);
  }
}

TEST(MeshFile, RoundTripGlbAndGltf) {
  const Scratch scratch("mesh");
  const Mesh mesh = sheet();
  for (const char* name : {"sheet.glb", "sheet.gltf"}) {
    ASSERT_EQ(problem_of(write_mesh(scratch / name, mesh, nullptr)), "");
    const base::Result<Mesh> read = read_mesh(scratch / name);
    ASSERT_TRUE(read) << problem_of(read);
    EXPECT_EQ(read->name, "sheet");
    expect_same(mesh, *read);
  }
}

TEST(MeshFile, RoundTripWithMaterial) {
  const Scratch scratch("material");
  const Image white{2, 2, 4, std::vector<float>(16, 1.0f)};
  GltfMaterial material;
  material.name = "cloth";
  material.base_color.png = material.orm.png = material.normal.png = material.anisotropy.png = material.sheen.png =
      encode_png(white);
  material.anisotropy_strength = 0.5f;
  material.sheen_color = {1, 1, 1};
  for (const char* name : {"cloth.glb", "cloth.gltf"}) {
    ASSERT_EQ(problem_of(write_mesh(scratch / name, sheet(), &material)), "");
    const base::Result<Mesh> read = read_mesh(scratch / name);
    ASSERT_TRUE(read) << problem_of(read);
    expect_same(sheet(), *read);
  }
  EXPECT_TRUE(std::filesystem::exists(scratch / "cloth_basecolor.png"));
}

/// The JSON of a .glb or a .gltf.
json root_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (bytes.starts_with("glTF"))
    bytes = bytes.substr(20, static_cast<unsigned char>(bytes[12]) + 256u * static_cast<unsigned char>(bytes[13]));
  return json::parse(bytes);
}

// Programs clamp colours beyond 1: with the usual index of refraction 0.4 became 0.04.
TEST(MeshFile, ReflectancesNeedNoColourBeyondOne) {
  const Scratch scratch("reflectances");
  for (const auto& [f0, f90] : {std::pair{0.4f, 1.0f}, {0.17f, 0.17f}, {0.3f, 0.5f}, {0.01f, 1.0f}, {0.0f, 0.0f}}) {
    GltfMaterial material;
    material.f0 = {f0, 0.5f * f0, 0.25f * f0}, material.f90 = f90;
    ASSERT_EQ(problem_of(write_mesh(scratch / "cloth.glb", sheet(), &material)), "");
    const json extensions = root_of(scratch / "cloth.glb")["materials"][0]["extensions"];
    const float factor = extensions["KHR_materials_specular"]["specularFactor"],
                colour = extensions["KHR_materials_specular"]["specularColorFactor"][0],
                ior = extensions.contains("KHR_materials_ior") ? extensions["KHR_materials_ior"]["ior"].get<float>()
                                                               : 1.5f;
    EXPECT_LE(colour, 1);
    EXPECT_NEAR(factor, std::max(f90, 1e-3f), 1e-4);
    const float amplitude = (ior - 1) / (ior + 1);
    EXPECT_NEAR(amplitude * amplitude * colour * factor, f0, 0.011f * f0 + 1e-6f) << ior;
    const float blue = extensions["KHR_materials_specular"]["specularColorFactor"][2];
    EXPECT_NEAR(blue, 0.25f * colour, 0.003f) << "the hue is kept";
  }
}

TEST(MeshFile, AGlbHasTheExtensionsOfItsGltf) {
  const Scratch scratch("extensions");
  GltfMaterial material;
  material.base_color.png = encode_png(Image{2, 2, 3, std::vector<float>(12, 0.5f)});
  material.transmission = 0.2f, material.f0 = {0.3f, 0.3f, 0.3f};
  json materials[2];
  for (const bool binary : {false, true}) {
    const std::string file = scratch / (binary ? "cloth.glb" : "cloth.gltf");
    ASSERT_EQ(problem_of(write_mesh(file, sheet(), &material)), "");
    const json root = root_of(file);
    materials[binary] = root["materials"][0]["extensions"];
    const std::set<std::string> used = root["extensionsUsed"];
    for (const auto& [name, values] : materials[binary].items()) EXPECT_TRUE(used.contains(name)) << name;
  }
  EXPECT_EQ(materials[0], materials[1]);
  EXPECT_NEAR(materials[1]["KHR_materials_diffuse_transmission"]["diffuseTransmissionFactor"].get<float>(), 0.2f,
              1e-6f);
}

TEST(MeshFile, TwoFacesHaveTheirOwnMaterials) {
  const Scratch scratch("faces");
  GltfMaterial front, back;
  front.name = "front", back.name = "back";
  front.base_color.file = "shared.png", back.base_color.png = encode_png(Image{2, 2, 3, std::vector<float>(12, 0.5f)});
  ASSERT_EQ(
      problem_of(write_image(scratch / "shared.png", Image{2, 2, 3, std::vector<float>(12, 1.0f)}, PixelType::kU8)),
      "");
  ASSERT_EQ(problem_of(write_mesh(scratch / "faces.gltf", sheet(), &front, &back)), "");
  const json root = json::parse(std::ifstream(scratch / "faces.gltf"));
  ASSERT_EQ(root["meshes"][0]["primitives"].size(), 2u);
  EXPECT_EQ(root["materials"][1]["name"], "back");
  EXPECT_EQ(root["materials"][0]["doubleSided"], false);
  EXPECT_EQ(root["images"][0]["uri"], "shared.png");
  EXPECT_EQ(root["images"][1]["uri"], "back_basecolor.png");
  front.base_color.file = "none.png";
  EXPECT_NE(problem_of(write_mesh(scratch / "faces.glb", sheet(), &front, &back)), "");
}

TEST(MeshFile, ABrokenMeshIsNotWritten) {
  const Scratch scratch("nowrite");
  Mesh mesh = sheet();
  mesh.index[0] = 99;
  EXPECT_NE(problem_of(write_mesh(scratch / "bad.glb", mesh, nullptr)), "");
  EXPECT_NE(problem_of(write_mesh(scratch / "empty.glb", Mesh{}, nullptr)), "");
  EXPECT_NE(problem_of(write_mesh(scratch / "no/such/folder.glb", sheet(), nullptr)), "");
  EXPECT_TRUE(std::filesystem::is_empty(scratch.folder));
}

// A .gltf with one triangle whose buffer is a data URI: positions (3 floats), uv, 8-bit indices.
std::string base64(const std::vector<unsigned char>& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t v = 0;
    for (size_t k = 0; k < 3; ++k) v = (v << 8) | (i + k < bytes.size() ? bytes[i + k] : 0u);
    for (size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kDigits[(v >> (18 - 6 * k)) & 63] : '=';
  }
  return out;
}

constexpr float kTriangle[] = {0, 0, 0, 2, 0, 0, 0, 2, 0,  // positions, metres
                               0, 1, 1, 1, 0, 0};          // uv: v down the image
json triangle(int index_type = 5121) {
  std::vector<unsigned char> bytes(sizeof kTriangle);
  std::memcpy(bytes.data(), kTriangle, sizeof kTriangle);
  const size_t width = index_type == 5121 ? 1 : index_type == 5123 ? 2 : 4;
  for (unsigned char i : {0, 1, 2}) {
    bytes.push_back(i);
    bytes.insert(bytes.end(), width - 1, 0);
  }
  return {
      {"asset", {{"version", "2.0"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0}}}}},
      {"nodes", {{{"mesh", 0}}}},
      {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}, {"indices", 2}}}}}}},
      {"accessors",
       {{{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}},
        {{"bufferView", 1}, {"componentType", 5126}, {"count", 3}, {"type", "VEC2"}},
        {{"bufferView", 2}, {"componentType", index_type}, {"count", 3}, {"type", "SCALAR"}}}},
      {"bufferViews",
       {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 36}},
        {{"buffer", 0}, {"byteOffset", 36}, {"byteLength", 24}},
        {{"buffer", 0}, {"byteOffset", 60}, {"byteLength", 3 * width}}}},
      {"buffers", {{{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}}}};
}

base::Result<Mesh> read_json(const Scratch& scratch, const json& root) {
  std::ofstream(scratch / "a.gltf") << root.dump();
  return read_mesh(scratch / "a.gltf");
}

TEST(MeshFile, ReadsAllIndexTypesMetresAndScalesForeignUv) {
  const Scratch scratch("foreign");
  for (int type : {5121, 5123, 5125}) {
    const base::Result<Mesh> read = read_json(scratch, triangle(type));
    ASSERT_TRUE(read) << problem_of(read);
    const Mesh& mesh = *read;
    EXPECT_EQ(mesh.index, (std::vector<uint32_t>{0, 1, 2}));
    EXPECT_EQ(mesh.position_mm[1], (Vec3{2000, 0, 0}));
    // 2 m of surface along each unit of UV; end 1 is at the right of an image, pick 1 at its top.
    EXPECT_NEAR(mesh.uv_mm[1][0] - mesh.uv_mm[0][0], -2000, 0.1);
    EXPECT_NEAR(mesh.uv_mm[2][1] - mesh.uv_mm[0][1], -2000, 0.1);
    EXPECT_NEAR(mesh.normal[0][2], 1, 1e-5);
    EXPECT_NEAR(mesh.tangent[0][0], -1, 1e-5);
  }
}

TEST(MeshFile, AppliesNodeTransforms) {
  const Scratch scratch("nodes");
  json root = triangle();
  // A parent moved by 1 m in y holds a child turned a quarter about z and doubled.
  root["nodes"] = {{{"children", {1}}, {"translation", {0, 1, 0}}},
                   {{"mesh", 0}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}, {"scale", {2, 2, 2}}}};
  const base::Result<Mesh> read = read_json(scratch, root);
  ASSERT_TRUE(read) << problem_of(read);
  EXPECT_NEAR(read->position_mm[1][0], 0, 0.01);
  EXPECT_NEAR(read->position_mm[1][1], 5000, 0.01);
  EXPECT_NEAR(read->tangent[0][1], -1, 1e-4);
}

TEST(MeshFile, MirroredNodesKeepTheFront) {
  const Scratch scratch("mirror");
  json root = triangle();
  root["nodes"][0]["scale"] = {-1, 1, 1};
  const base::Result<Mesh> read = read_json(scratch, root);
  ASSERT_TRUE(read) << problem_of(read);
  EXPECT_NEAR(read->normal[0][2], 1, 1e-5);
}

TEST(MeshFile, ReadsStripsAndUnindexed) {
  const Scratch scratch("strip");
  json root = triangle();
  root["meshes"][0]["primitives"][0].erase("indices");
  root["meshes"][0]["primitives"][0]["mode"] = 5;
  const base::Result<Mesh> read = read_json(scratch, root);
  ASSERT_TRUE(read) << problem_of(read);
  EXPECT_EQ(read->index.size(), 3u);
}

struct Broken {
  const char* name;
  void (*damage)(json&);
  const char* expected;
};

class BrokenGltf : public testing::TestWithParam<Broken> {};

TEST_P(BrokenGltf, IsRejectedWithAReason) {
  const Scratch scratch("broken");
  json root = triangle();
  GetParam().damage(root);
  const base::Result<Mesh> read = read_json(scratch, root);
  EXPECT_FALSE(read);
  EXPECT_NE(problem_of(read).find(GetParam().expected), std::string::npos) << problem_of(read);
}

INSTANTIATE_TEST_SUITE_P(
    All, BrokenGltf,
    testing::Values(
        Broken{"no_uv", [](json& r) { r["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_0"); },
               "texture coordinates"},
        Broken{"no_position", [](json& r) { r["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); },
               "accessor"},
        Broken{"huge_count", [](json& r) { r["accessors"][0]["count"] = 4000000000u; }, "4000000000 elements"},
        Broken{"count_past_end", [](json& r) { r["accessors"][0]["count"] = 4; }, "past the end"},
        Broken{"negative_count", [](json& r) { r["accessors"][0]["count"] = -3; }, ""},
        Broken{"offset_past_end", [](json& r) { r["accessors"][0]["byteOffset"] = 1000000; }, "past the end"},
        Broken{"view_past_end", [](json& r) { r["bufferViews"][0]["byteLength"] = 1u << 30; }, "past the end"},
        Broken{"view_offset_overflow", [](json& r) { r["bufferViews"][0]["byteOffset"] = 18446744073709551600ull; },
               "past the end"},
        Broken{"accessor_out_of_range", [](json& r) { r["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 77; },
               "accessor"},
        Broken{"view_out_of_range", [](json& r) { r["accessors"][0]["bufferView"] = 77; }, "buffer view"},
        Broken{"buffer_out_of_range", [](json& r) { r["bufferViews"][0]["buffer"] = 77; }, "buffer"},
        Broken{"mesh_out_of_range", [](json& r) { r["nodes"][0]["mesh"] = 77; }, "mesh"},
        Broken{"wrong_type", [](json& r) { r["accessors"][0]["type"] = "VEC4"; }, "components"},
        Broken{"no_such_component", [](json& r) { r["accessors"][0]["componentType"] = 9; }, ""},
        Broken{"float_indices", [](json& r) { r["meshes"][0]["primitives"][0]["indices"] = 1; }, ""},
        Broken{"ring_of_nodes", [](json& r) { r["nodes"][0]["children"] = {0}; }, "cycle"},
        Broken{"ring_of_two",
               [](json& r) {
                 r["nodes"] = {{{"children", {1}}}, {{"children", {0}}, {"mesh", 0}}};
               },
               "cycle"},
        Broken{"child_out_of_range", [](json& r) { r["nodes"][0]["children"] = {5}; }, "node"},
        Broken{"scene_out_of_range", [](json& r) { r["scene"] = 5; }, "scene"},
        Broken{"buffer_longer_than_data", [](json& r) { r["buffers"][0]["byteLength"] = 1u << 30; }, ""},
        Broken{"buffer_device", [](json& r) { r["buffers"][0]["uri"] = "../../../../../../dev/zero"; }, ""},
        Broken{"buffer_leaves_the_folder", [](json& r) { r["buffers"][0]["uri"] = "../sheet.bin"; }, "folder"},
        Broken{"buffer_leaves_the_folder_coded", [](json& r) { r["buffers"][0]["uri"] = "%2e%2E%2fsheet.bin"; },
               "folder"},
        Broken{"buffer_of_the_root", [](json& r) { r["buffers"][0]["uri"] = "/dev/zero"; }, "folder"},
        Broken{"buffer_of_a_scheme", [](json& r) { r["buffers"][0]["uri"] = "file:///dev/zero"; }, "folder"},
        Broken{"buffer_is_a_command", [](json& r) { r["buffers"][0]["uri"] = "$(touch ran).bin"; }, ""},
        Broken{"buffer_missing", [](json& r) { r["buffers"][0]["uri"] = "none.bin"; }, ""},
        Broken{"flat_uv",
               [](json& r) {
                 r["accessors"][1]["byteOffset"] = 0;
                 r["accessors"][1]["bufferView"] = 0;
                 r["bufferViews"][0]["byteStride"] = 12;
                 r["accessors"][1]["count"] = 1;
               },
               "length"},
        Broken{"sparse",
               [](json& r) {
                 r["accessors"][0]["sparse"] = {{"count", 1},
                                                {"indices", {{"bufferView", 2}, {"componentType", 5121}}},
                                                {"values", {{"bufferView", 0}}}};
               },
               "sparse"},
        Broken{"draco", [](json& r) { r["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }, "compression"},
        Broken{"version_1", [](json& r) { r["asset"]["version"] = "1.0"; }, "2.0"},
        Broken{"asset_is_a_list", [](json& r) { r["asset"] = json::array(); }, "2.0"},
        Broken{"meshes_is_a_number", [](json& r) { r["meshes"] = 3; }, "meshes"},
        Broken{"node_is_a_string", [](json& r) { r["nodes"][0] = "mesh"; }, "nodes"},
        Broken{"no_meshes", [](json& r) { r.erase("meshes"); }, ""},
        Broken{"infinite_matrix",
               [](json& r) {
                 r["nodes"][0]["scale"] = {1e300, 1e300, 1};
               },
               "position"}),
    [](const auto& broken) { return std::string(broken.param.name); });

TEST(MeshFile, GlbTruncatedAtAnyLengthIsRejected) {
  const Scratch scratch("truncated");
  ASSERT_EQ(problem_of(write_mesh(scratch / "whole.glb", sheet(), nullptr)), "");
  const auto size = std::filesystem::file_size(scratch / "whole.glb");
  for (uintmax_t keep = 0; keep < size; keep += keep < 40 ? 1 : 13) {
    std::filesystem::copy_file(scratch / "whole.glb", scratch / "cut.glb",
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(scratch / "cut.glb", keep);
    EXPECT_FALSE(read_mesh(scratch / "cut.glb")) << keep << " bytes of " << size;
  }
}

TEST(MeshFile, ABufferMustBeARegularFileInTheFolder) {
  const Scratch scratch("buffers");
  std::filesystem::create_directories(scratch / "in/deeper");
  ASSERT_EQ(problem_of(write_mesh(scratch / "in/sheet.gltf", sheet(), nullptr)), "");
  ASSERT_TRUE(read_mesh(scratch / "in/sheet.gltf"));
  const std::string bin = scratch / "in/sheet.bin";
  std::filesystem::rename(bin, scratch / "outside.bin");
  std::filesystem::create_symlink("../outside.bin", bin);
  EXPECT_FALSE(read_mesh(scratch / "in/sheet.gltf")) << "a link that leaves the folder";
  std::filesystem::remove(bin);
  ASSERT_EQ(::mkfifo(bin.c_str(), 0600), 0);
  EXPECT_FALSE(read_mesh(scratch / "in/sheet.gltf")) << "a pipe";
}

TEST(MeshFile, DeeplyNestedJsonIsRejected) {
  const Scratch scratch("deep");
  std::ofstream(scratch / "deep.gltf") << R"({"asset":{"version":"2.0"},"extras":)" << std::string(200000, '[');
  EXPECT_NE(problem_of(read_mesh(scratch / "deep.gltf")).find("nested"), std::string::npos);
}

TEST(Drape, UnknownNameListsTheNames) {
  const base::Result<Mesh> read = load_drape("tabelcloth");
  EXPECT_FALSE(read);
  EXPECT_NE(problem_of(read).find("tablecloth"), std::string::npos) << problem_of(read);
  EXPECT_NE(problem_of(load_drape("no/such/file.glb")), "");
}

TEST(Drape, PresetsFolderOfTheEnvironmentWins) {
  const Scratch scratch("presets");
  std::filesystem::create_directories(scratch / "meshes");
  Mesh mesh = sheet();
  mesh.position_mm[2][2] = 7;
  ASSERT_EQ(problem_of(write_mesh(scratch / "meshes/plane.glb", mesh, nullptr)), "");
  ASSERT_EQ(::setenv("WEFTLIGHT_PRESETS", scratch.folder.c_str(), 1), 0);
  EXPECT_EQ(presets_dir(), scratch.folder.string());
  const base::Result<Mesh> read = load_drape("plane");
  ::unsetenv("WEFTLIGHT_PRESETS");
  ASSERT_TRUE(read) << problem_of(read);
  EXPECT_NEAR(read->position_mm[2][2], 7, 1e-4);
}

}  // namespace
}  // namespace weftlight::files
