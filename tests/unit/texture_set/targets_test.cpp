// The table of export targets: that it is all a new target needs, and that the docs agree with it.

#include "texture_set/targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "../files/sheet.h"
#include "../scratch.h"
#include "base/whole_files.h"
#include "paths.h"
#include "sample_set.h"
#include "texture_set/material_files.h"

namespace weftlight::texture_set {

using draft::Face;
using drape::sheet;
using files::PixelType;

namespace {

using enum Channel;
using nlohmann::json;
namespace fs = std::filesystem;

// A target as a file in targets/ has it: maps of its own, y down, a material of one line.
constexpr ImageRow kImages[] = {
    {"mu-", "_color", ".png", PixelType::kU8, true, kBaseCoverage},
    {"mu-", "_bump", ".png", PixelType::kU16, false, {kNormalX, kNormalYDown, kNormalZ, kNone}},
};

base::Result<void> write_material(const SetFacts& set) {
  return base::write_file_atomically(set.folder + "/" + set.name + ".mu",
                                     "use " + image_named(set, "_color", Face::kBack) + "\n");
}

const ExportTarget kMadeUp{
    .id = "made-up",
    .title = "Made Up Engine",
    .images = kImages,
    .normal = "-Y",
    .front = "_face",
    .model = {.sheen = 0, .most_f0 = 1, .grazing = false, .anisotropic = false},
    .open = Alpha::kHashed,
    .material = ".mu",
    .write_material = write_material,
    .note = "Made up for a test: open {name}.mu.",
};

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ExportTargets, ANewOneIsAFileAndARow) {
  std::vector<const ExportTarget*> table(kTargets.begin(), kTargets.end());
  table.push_back(&kMadeUp);
  const ExportTarget* target = target_named("made-up", table);
  ASSERT_EQ(target, &kMadeUp);
  EXPECT_EQ(target_named("made-up"), nullptr) << "the program's own table has no such target";

  const Scratch scratch("made-up");
  const std::string folder = scratch / "set";
  ASSERT_EQ(problem_of(write_texture_set(folder, sample_design(), sheet(), options_for(*target, 32))), "");
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder)) found.insert(entry.path().filename());
  EXPECT_EQ(found, (std::set<std::string>{"README.md", "contact_sheet.png", "mu-sample_back_bump.png",
                                          "mu-sample_back_color.png", "mu-sample_face_bump.png",
                                          "mu-sample_face_color.png", "sample.mu", "texture_set.json"}));
  const json list = list_of(folder);
  EXPECT_EQ(list["target"], "made-up");
  EXPECT_EQ(list["normal"], "-Y");
  EXPECT_EQ(list["material"], "sample.mu");
  EXPECT_EQ(list["maps"].size(), 4u);
  EXPECT_EQ(list["maps"][1]["type"], "16-bit");
  EXPECT_EQ(list["maps"][1]["channels"]["G"], "normal y, down");
  EXPECT_EQ(text_of(folder + "/sample.mu"), "use mu-sample_back_color.png\n");
  EXPECT_NE(text_of(folder + "/README.md").find("Made up for a test: open sample.mu."), std::string::npos);
  EXPECT_EQ(alpha_for(*target, Alpha::kAuto, 0.5f), Alpha::kHashed);
}

TEST(ExportTargets, AreWholeAndDifferent) {
  std::set<std::string> ids, titles;
  for (const ExportTarget* target : kTargets) {
    EXPECT_TRUE(ids.insert(target->id).second) << target->id;
    EXPECT_TRUE(titles.insert(target->title).second) << target->id;
    EXPECT_EQ(target_named(target->id), target);
    EXPECT_EQ(target->write_material != nullptr, *target->material != 0) << target->id;
    std::set<std::string> files;
    for (const ImageRow& row : target->images)
      EXPECT_TRUE(files.insert(image_file(*target, row, "a", Face::kFront)).second) << target->id << row.suffix;
    EXPECT_FALSE(files.empty()) << target->id;
  }
}

/// The words of the text that are file names of the set.
std::vector<std::string> files_named(const std::string& text, const std::string& set) {
  std::vector<std::string> out;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    while (!word.empty() && std::string_view(".,;:)").find(word.back()) != std::string_view::npos) word.pop_back();
    if (word.starts_with(set) && word.find('.') != std::string::npos) out.push_back(word);
  }
  return out;
}

TEST(ExportTargets, ReadmesNameAFileToBeginWith) {
  const Scratch scratch("readmes");
  for (const ExportTarget* target : kTargets) {
    const std::string folder = scratch / target->id;
    TextureSetOptions options = options_for(*target, 32);
    options.source = "a draft";
    ASSERT_EQ(problem_of(write_texture_set(folder, sample_design(), sheet(), options)), "") << target->id;
    const std::string readme = text_of(folder + "/README.md");
    const std::vector<std::string> named = files_named(readme, "sample");
    EXPECT_FALSE(named.empty()) << readme;
    for (const std::string& file : named) EXPECT_TRUE(fs::exists(folder + "/" + file)) << target->id << ": " << file;
    const bool opens = std::ranges::find(named, std::string("sample") + target->material) != named.end();
    EXPECT_TRUE(opens || !*target->material) << readme;
    EXPECT_EQ(readme.find("texture coordinates in") == std::string::npos,
              target == &targets::kRaw || target == &targets::kU3m)
        << readme;
    EXPECT_EQ(readme.find('{'), std::string::npos) << readme;
    EXPECT_NE(readme.find(target->title), std::string::npos) << readme;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string file = entry.path().filename(), kind = entry.path().extension();
      if (kind != ".glb" && kind != ".gltf" && kind != ".bin" && kind != ".obj") continue;
      EXPECT_NE(std::ranges::find(named, file), named.end()) << target->id << " says nothing of " << file;
    }
  }
}

TEST(ExportTargets, TheDocsNameEveryFieldOfTheList) {
  const Scratch scratch("fields");
  TextureSetOptions options = options_for(targets::kGltf, 32);
  options.masks = options.archived = true, options.key = "0";
  ASSERT_EQ(problem_of(write_texture_set(scratch / "set", sample_design(), sheet(), options)), "");
  const json list = list_of(scratch / "set");
  const std::string docs = text_of(WEFTLIGHT_SOURCE_DIR "/docs/engines.md");
  for (const auto& [field, value] : list.items()) EXPECT_NE(docs.find("`" + field), std::string::npos) << field;
  for (const auto& [field, value] : list["fit"]["front"].items())
    EXPECT_NE(docs.find("`." + field), std::string::npos) << field;
}

TEST(ExportTargets, ReadmesNameMipsAndLevelsOnlyWhereTheyAre) {
  const Scratch scratch("readme-extras");
  TextureSetOptions options = options_for(targets::kGltf, 64);
  const auto readme_with = [&](const TextureSetOptions& of) {
    const std::string folder = scratch / of.name;
    EXPECT_EQ(problem_of(write_texture_set(folder, sample_design(), sheet(), of)), "");
    return text_of(folder + "/README.md");
  };
  const std::string plain = readme_with(options);
  EXPECT_EQ(plain.find("mipmaps"), std::string::npos) << plain;
  EXPECT_EQ(plain.find("level of detail"), std::string::npos) << plain;
  options.mips = MipFormat::kKtx2;
  const std::string further = readme_with(at_lod(options, 1));
  EXPECT_NE(further.find("The .ktx2 files"), std::string::npos) << further;
  EXPECT_NE(further.find("level of detail 1"), std::string::npos) << further;
}

TEST(ExportTargets, DocsNameThem) {
  std::string ids, rows = "| target | model of the highlight | sheen that is fitted |\n|---|---|---|\n";
  for (const ExportTarget* target : kTargets) {
    if (!ids.empty()) ids += '|';
    ids += target->id;
    if (target->raw) continue;
    for (const char* cell : {target->id, target->highlight, target->sheen}) rows.append("| ").append(cell).append(" ");
    rows += "|\n";
  }
  const std::string usage = "--target " + ids + "[,...]";
  EXPECT_NE(text_of(WEFTLIGHT_SOURCE_DIR "/docs/commands.md").find(usage), std::string::npos)
      << "docs/commands.md shall hold\n"
      << usage;
  EXPECT_NE(text_of(WEFTLIGHT_SOURCE_DIR "/docs/engines.md").find(rows), std::string::npos)
      << "docs/engines.md shall hold\n"
      << rows;
}

}  // namespace
}  // namespace weftlight::texture_set
