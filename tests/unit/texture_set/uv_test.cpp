// Units of texture coordinates and the place of the cloth: the written files are read back and agree with each other.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "../files/sheet.h"
#include "../scratch.h"
#include "sample_set.h"
#include "texture_set/material_files.h"

namespace weftlight::texture_set {

using base::problem_of;
using cloth::Cloth, cloth::Period, cloth::lay_out;
using draft::Face, draft::drawdown;
using drape::Mesh, drape::sheet;
using files::read_mesh;

namespace {

using nlohmann::json;

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The numbers after the first occurrence of `mark` in a file.
std::vector<double> numbers_after(const std::string& path, const std::string& mark, size_t count) {
  const std::string text = text_of(path);
  const size_t at = text.find(mark);
  EXPECT_NE(at, std::string::npos) << path << " lacks " << mark;
  if (at == std::string::npos) return std::vector<double>(count);
  std::string rest = text.substr(at + mark.size(), 200);
  for (char& c : rest) c = std::string("+-.0123456789e").find(c) == std::string::npos ? ' ' : c;
  std::istringstream in(rest);
  std::vector<double> out;
  for (std::string word; out.size() < count && in >> word;)
    if (word.find_first_of("0123456789") != std::string::npos) out.push_back(std::stod(word));
  out.resize(count);
  return out;
}

/// Where a target's files keep scale and offset; down: -1 where its v grows downwards.
struct Place {
  const ExportTarget& target;
  const char* file;
  const char* scale;
  const char* offset;
  double down;
};
const Place kPlaces[] = {
    {targets::kGltf, "sample.gltf", "\"scale\"", "\"offset\"", -1},
    {targets::kGodot, "sample.tres", "uv_scale = Vector2", "uv_offset = Vector2", -1},
    {targets::kUnityUrp, "sample.mat", "m_Scale:", "m_Offset:", 1},
    {targets::kUnreal, "sample_import.py", "NAME = \"sample\"\nTILING = ", "OFFSET = ", -1},
    {targets::kBlender, "sample.py", "NAME = \"sample\"\nTILING = ", "OFFSET = ", 1},
    {targets::kEevee, "sample.py", "NAME = \"sample\"\nTILING = ", "OFFSET = ", 1},
    {targets::kMaterialX, "sample.mtlx", "nodename=\"uv_cm\" />\n      <input name=\"in2\" type=\"vector",
     "nodename=\"uv_scaled\" />\n      <input name=\"in2\" type=\"vector", 1},
    {targets::kMaterialX, "sample.usda", "inputs:scale = ", "inputs:translation = ", 1},
};

class Uv : public testing::Test {
 protected:
  std::string written(const ExportTarget& target, UvMapping uv) {
    TextureSetOptions options = options_for(target, 16);
    options.uv = uv;
    std::string folder = scratch_ / (std::string(target.id) + uv_unit_name(uv.unit));
    EXPECT_EQ(problem_of(write_texture_set(folder, sample_design(), sheet(), options)), "");
    return folder;
  }
  const Cloth cloth_ = lay_out(sample_design(), drawdown(sample_design().draft), Face::kFront, Period::kRepeat);

  /// The meshes of a set in centimetres have the coordinates that its material takes.
  static void expect_mesh(const ExportTarget& target, const std::string& folder) {
    if (&target == &targets::kMaterialX) {
      EXPECT_EQ(numbers_after(folder + "/sample.usda", "primvars:st = ", 1)[0], -10) << "100 mm";
    } else if (&target == &targets::kUnityUrp) {
      EXPECT_EQ(numbers_after(folder + "/sample_quad.obj", "vt ", 1)[0], -10);
    } else if (&target == &targets::kGltf) {
      // The file does not say that it is in millimetres, and is read at its true size all the same.
      EXPECT_FALSE(json::parse(text_of(folder + "/sample.gltf"))["asset"].contains("extras"));
      const base::Result<Mesh> mesh = read_mesh(folder + "/sample.gltf");
      ASSERT_TRUE(mesh) << problem_of(mesh);
      EXPECT_NEAR(mesh->uv_mm[2][0] - mesh->uv_mm[0][0], 200, 1);
    }
  }

 private:
  Scratch scratch_{"uv"};
};

TEST_F(Uv, EveryTargetRepeatsAtTrueSizeAndMovesTheClothTheSameWay) {
  const double width = static_cast<double>(cloth_.width_mm), depth = static_cast<double>(cloth_.depth_mm);
  std::string made, folder;
  for (const Place& place : kPlaces) {
    if (made != place.target.id) folder = written(place.target, {UvUnit::kCm, 3, 0.5f});
    made = place.target.id;
    // MaterialX writes the type before the values.
    const size_t skip = std::string(place.scale).ends_with("vector") ? 1 : 0;
    const std::string file = folder + "/" + place.file;
    const std::vector<double> scale = numbers_after(file, place.scale, 2 + skip),
                              offset = numbers_after(file, place.offset, 2 + skip);
    EXPECT_NEAR(scale[skip], 10 / width, 1e-4 / width) << place.file;
    EXPECT_NEAR(scale[skip + 1], 10 / depth, 1e-4 / depth) << place.file;
    EXPECT_NEAR(offset[skip], -3 / width, 1e-4) << place.file;
    EXPECT_NEAR(offset[skip + 1], -0.5 / depth * place.down, 1e-4) << place.file;
    expect_mesh(place.target, folder);
  }
}

TEST_F(Uv, ListAndReadmeNameTheUnit) {
  const std::string folder = written(targets::kUnreal, {UvUnit::kTile, 0, 0});
  const json list = list_of(folder);
  EXPECT_EQ(list["texture_coordinates"], "tiles");
  EXPECT_EQ(list["uv"]["scale"], (json{1.0, 1.0}));
  EXPECT_EQ(list["uv"]["offset"], (json{0.0, 0.0}));
  EXPECT_NE(text_of(folder + "/README.md").find("texture coordinates in tiles"), std::string::npos);
  EXPECT_EQ(key_of(options_for(targets::kUnreal)).find("uv"), std::string::npos) << "sets of before stay complete";
}

}  // namespace
}  // namespace weftlight::texture_set
