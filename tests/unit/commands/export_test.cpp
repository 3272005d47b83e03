// export of many drafts for many programs in one call: folders, sizes, resume and failures.

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>
#include <tuple>

#include "base/json.h"
#include "base/whole_files.h"
#include "scratch_folder.h"

namespace weftlight::commands {

using base::read_file, base::write_file_atomically;

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Args = std::vector<std::string>;

class Export : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    fs::create_directories(path("drafts/deep"));
    fs::copy_file(fixture_path("twill.wif"), path("drafts/a.wif"));
    fs::copy_file(fixture_path("luminescence.wif"), path("drafts/deep/b.wif"));
  }
  Ran exported(Args more) const {
    Args args{"export", path("drafts"), "-o", path("sets")};
    args.insert(args.end(), more.begin(), more.end());
    return run(args);
  }
  json list(const std::string& set) const {
    return json::parse(read_file(path("sets/" + set + "/texture_set.json")).value_or(""));
  }
  bool has(const std::string& name) const { return fs::exists(path("sets/" + name)); }
};

TEST_F(Export, a_folder_for_several_targets) {
  const Ran ran = exported({"--target", "raw,unity-urp", "--size", "16"});
  EXPECT_EQ(ran.code, kDone) << ran.said;
  for (const char* set : {"a/raw", "a/unity-urp", "b/raw", "b/unity-urp"})
    EXPECT_TRUE(has(std::string(set) + "/texture_set.json")) << set;
  EXPECT_NE(ran.said.find("4 sets written"), std::string::npos) << ran.said;
}

TEST_F(Export, levels_of_detail_share_the_tile) {
  EXPECT_EQ(exported({"--size", "256", "--lods"}).code, kDone);
  for (const auto& [set, size, lod] :
       {std::tuple("a", 256, 0), std::tuple("a-lod1", 64, 1), std::tuple("a-lod2", 16, 2)}) {
    const json of = list(set);
    EXPECT_EQ(std::max(of["size_texels"][0].get<int>(), of["size_texels"][1].get<int>()), size) << set;
    EXPECT_EQ(of["lod"], lod) << set;
    EXPECT_EQ(of["size_mm"], list("a")["size_mm"]) << set;
  }
  const Ran refused = exported({"--lods", "--target", "gltf,raw"});
  EXPECT_EQ(refused.code, kUsage);
  EXPECT_NE(refused.said.find("leave raw out, or export it by itself"), std::string::npos) << refused.said;
  EXPECT_EQ(exported({"--lods", "--px-per-mm", "6", "--name", "dense/{name}"}).code, kDone);
  EXPECT_EQ(list("dense/b-lod1")["size_mm"], list("dense/b")["size_mm"]);
  EXPECT_EQ(4 * list("dense/b-lod1")["size_texels"][0].get<int>(), list("dense/b")["size_texels"][0].get<int>());
}

TEST_F(Export, names_follow_the_template) {
  EXPECT_EQ(exported({"--target", "raw", "--size", "32", "--name", "{target}/{size}/{name}"}).code, kDone);
  EXPECT_TRUE(has("raw/32/b/texture_set.json"));
  EXPECT_EQ(exported({"--target", "raw", "--px-per-mm", "9", "--name", "dense/{name}_{size}"}).code, kDone);
  const std::string made = fs::directory_iterator(path("sets/dense"))->path().filename();
  const json texels = list("dense/" + made)["size_texels"];
  EXPECT_EQ(made.substr(made.find('_') + 1), std::to_string(std::max(texels[0].get<int>(), texels[1].get<int>())));
  EXPECT_EQ(exported({"--target", "raw,godot", "--name", "{name}"}).code, kUsage) << "two sets in one folder";
}

TEST_F(Export, sets_that_would_replace_each_other_are_refused) {
  const std::string one = path("drafts/a.wif");
  for (const Args& more : {Args{"--lods"}, Args{path("drafts/deep/b.wif")}}) {
    Args args{"export", one, "-o", path("sets"), "--size", "64", "--name", "cloth"};
    args.insert(args.end(), more.begin(), more.end());
    const Ran ran = run(args);
    EXPECT_EQ(ran.code, kUsage) << more[0];
    EXPECT_NE(ran.said.find("sets/cloth: several sets would be in this folder"), std::string::npos) << ran.said;
    EXPECT_FALSE(has("")) << more[0];
  }
  EXPECT_EQ(run({"export", one, "-o", path("sets"), "--size", "16", "--target", "raw", "--name", "cloth"}).code, kDone);
  EXPECT_EQ(run({"export", one, "-o", path("sets"), "--size", "256", "--lods", "--name", "{size}"}).code, kDone);
  EXPECT_TRUE(has("256/texture_set.json") && has("64/texture_set.json") && has("16/texture_set.json"));
}

TEST_F(Export, a_template_with_an_unknown_field_is_refused_with_the_fields) {
  for (const char* form : {"{draft}_{target}", "{name", "a}b", "{}", "{Name}"}) {
    const Ran ran = exported({"--target", "raw", "--size", "16", "--name", form});
    EXPECT_EQ(ran.code, kUsage) << form;
    EXPECT_NE(ran.said.find("{name}, {target}, {size}"), std::string::npos) << ran.said;
    EXPECT_FALSE(has("")) << form;
  }
}

TEST_F(Export, a_template_stays_in_the_output_folder) {
  for (const char* form : {"..", ".", "../{name}", "a/../{name}", "/{name}"}) {
    const Ran ran = exported({"--target", "raw", "--size", "16", "--name", form});
    EXPECT_EQ(ran.code, kUsage) << form;
    EXPECT_TRUE(ran.said.starts_with("weftlight: --name " + std::string(form) + ": give a name for a folder"))
        << ran.said;
    EXPECT_FALSE(has("")) << form;
  }
}

TEST_F(Export, texels_per_millimetre_and_tiles_of_several_repeats) {
  EXPECT_EQ(exported({"--target", "raw", "--px-per-mm", "12", "--tile-cm", "1"}).code, kDone);
  const json a = list("a");
  EXPECT_GE(a["size_mm"][0].get<float>(), 10);
  EXPECT_GE(a["size_texels"][0].get<float>(), 12 * a["size_mm"][0].get<float>());
  EXPECT_EQ(exported({"--target", "raw", "--px-per-mm", "12", "--size", "64"}).code, kUsage);
  const Ran thin = exported({"--target", "raw", "--size", "16", "--tile-cm", "5"});
  EXPECT_EQ(thin.code, kDone);
  EXPECT_NE(thin.said.find("texels; give a larger --size"), std::string::npos) << thin.said;
  const Ran one = exported({"--target", "raw", "--size", "16", "--tile-cm", "3.2"});
  EXPECT_NE(one.said.find("a.wif: a thread has only 1 texel; give"), std::string::npos) << one.said;
}

TEST_F(Export, archives_are_written_beside_their_sets) {
  EXPECT_EQ(exported({"--target", "raw", "--size", "16", "--zip"}).code, kDone);
  EXPECT_EQ(read_file(path("sets/a.zip")).value_or("").substr(0, 2), "PK");
  write_file_atomically(path("sets/b.zip"), "mine");
  EXPECT_EQ(exported({"--target", "raw", "--size", "16", "--zip"}).code, kDone) << "its own, which was listed";
  fs::remove_all(path("sets/b")), write_file_atomically(path("sets/b.zip"), "mine");
  EXPECT_EQ(exported({"--target", "raw", "--size", "16", "--zip"}).code, kNotWritten);
  EXPECT_EQ(read_file(path("sets/b.zip")).value_or(""), "mine");
}

TEST_F(Export, failures_are_listed_at_the_end_and_the_rest_is_done) {
  write_file_atomically(path("drafts/aa.wif"), "no draft");
  const Ran ran = exported({"--target", "raw", "--size", "16"});
  EXPECT_EQ(ran.code, kBadInput);
  EXPECT_TRUE(has("a/texture_set.json") && has("b/texture_set.json"));
  EXPECT_NE(ran.said.find("2 sets written, 0 already complete, 1 failed\n  " + path("drafts/aa.wif")),
            std::string::npos)
      << ran.said;
}

TEST_F(Export, a_broken_draft_is_reported_once_for_all_targets) {
  write_file_atomically(path("drafts/aa.wif"), "no draft");
  const Ran ran = exported({"--target", "raw,u3m,unity-urp", "--size", "16"});
  EXPECT_EQ(ran.code, kBadInput);
  size_t lines = 0;
  for (size_t at = 0; (at = ran.said.find("aa.wif", at)) != std::string::npos; ++at) ++lines;
  EXPECT_EQ(lines, 2u) << "what is wrong, and the list at the end\n" << ran.said;
  EXPECT_NE(ran.said.find("6 sets written, 0 already complete, 3 failed"), std::string::npos) << ran.said;
}

TEST_F(Export, what_is_wrong_with_one_draft_is_one_line) {
  const Ran ran = run({"export", path("none"), "-o", path("sets")});
  EXPECT_EQ(ran.code, kBadInput);
  EXPECT_EQ(ran.said, path("none") + ": there is no such file; give the path of a draft\n");
}

TEST_F(Export, a_draft_that_is_named_twice_is_exported_once) {
  const Ran ran = run({"export", path("drafts"), path("drafts/a.wif"), path("drafts/deep/../a.wif"), "-o", path("sets"),
                       "--target", "raw", "--size", "16"});
  EXPECT_EQ(ran.code, kDone) << ran.said;
  EXPECT_NE(ran.said.find("2 sets written"), std::string::npos) << ran.said;
  EXPECT_FALSE(has("a-2"));
}

TEST_F(Export, warnings_of_a_draft_are_given_once_for_all_targets) {
  const Ran ran = exported({"--target", "raw,u3m,unity-urp", "--size", "16", "--tile-cm", "5"});
  EXPECT_EQ(ran.code, kDone);
  const size_t first = ran.said.find("a.wif: a thread has only");
  ASSERT_NE(first, std::string::npos) << ran.said;
  EXPECT_EQ(ran.said.find("a.wif: a thread has only", first + 1), std::string::npos) << ran.said;
}

TEST_F(Export, resume_makes_missing_and_outdated_sets) {
  const Args again{"--target", "raw", "--size", "16", "--resume"};
  EXPECT_EQ(exported(again).code, kDone);
  EXPECT_NE(exported(again).said.find("0 sets written, 2 already complete"), std::string::npos);
  fs::remove(path("sets/a/a_front_height.exr"));
  EXPECT_NE(exported(again).said.find("1 set written, 1 already complete"), std::string::npos) << "a file is gone";
  fs::copy_file(fixture_path("twill.wif"), path("drafts/deep/b.wif"), fs::copy_options::overwrite_existing);
  EXPECT_NE(exported(again).said.find("1 set written, 1 already complete"), std::string::npos) << "another draft";
}

TEST_F(Export, resume_makes_sets_with_changed_files_again) {
  const Args again{"--target", "raw", "--size", "16", "--resume"};
  EXPECT_EQ(exported(again).code, kDone);
  const std::string file = path("sets/a/a_front_height.exr"), whole = read_file(file).value_or("");
  const json contents = list("a")["contents"];
  EXPECT_EQ(contents["a_front_height.exr"]["bytes"], whole.size());
  EXPECT_EQ(contents.size(), list("a")["files"].size());
  fs::resize_file(file, whole.size() / 2);
  EXPECT_NE(exported(again).said.find("1 set written, 1 already complete"), std::string::npos) << "a truncated file";
  EXPECT_EQ(read_file(file).value_or(""), whole);
  std::string other = whole;
  other.back() = static_cast<char>(other.back() ^ 1);
  write_file_atomically(file, other);
  EXPECT_NE(exported(again).said.find("1 set written, 1 already complete"), std::string::npos) << "a changed byte";
  EXPECT_EQ(read_file(file).value_or(""), whole);
  EXPECT_NE(exported(again).said.find("0 sets written, 2 already complete"), std::string::npos);
}

TEST_F(Export, resume_makes_sets_again_whose_mesh_has_changed) {
  const std::string presets = std::string(WEFTLIGHT_SOURCE_DIR) + "/presets/meshes/", mesh = path("worn.glb");
  const Args again{"--target", "gltf,raw", "--size", "16", "--mesh", mesh, "--resume"};
  fs::copy_file(presets + "plane.glb", mesh);
  EXPECT_EQ(exported(again).code, kDone);
  EXPECT_NE(exported(again).said.find("0 sets written, 4 already complete"), std::string::npos);
  fs::copy_file(presets + "sphere.glb", mesh, fs::copy_options::overwrite_existing);
  EXPECT_NE(exported(again).said.find("2 sets written, 2 already complete"), std::string::npos) << "raw ones show none";
}

TEST_F(Export, resume_makes_missing_and_truncated_archives) {
  EXPECT_EQ(exported({"--target", "raw", "--size", "16"}).code, kDone);
  const Args again{"--target", "raw", "--size", "16", "--resume", "--zip"};
  EXPECT_EQ(exported(again).code, kDone);
  ASSERT_TRUE(has("a.zip") && has("b.zip"));
  EXPECT_NE(exported(again).said.find("0 sets written, 2 already complete"), std::string::npos);
  const uintmax_t size = fs::file_size(path("sets/a.zip"));
  fs::resize_file(path("sets/a.zip"), size - 30);
  EXPECT_EQ(exported(again).code, kDone);
  EXPECT_EQ(fs::file_size(path("sets/a.zip")), size);
}

/// Four ends of plain weave, in Fiberworks' format; `treadling` may make it another.
std::string dtx(const std::string& treadling = "1 2") {
  return "@@StartDTX\n@@Info\n%%shafts 2\n@@Threading\n1 2 1 2\n@@Tieup\n01\n10\n@@Treadling\n" + treadling +
         "\n@@EndDTX\n";
}

/// Two ends and three picks, in WeavePoint's.
std::string wpo() {
  std::string bytes{123, 7, 100, 10, 2, 2, 0, 0, 1, 10, 5, 0, 0, 0, 2, 0, 3};
  bytes.append(7, '\0');
  bytes += std::string{0, 2, 1, 2, 0, 3, 0, 1, 1, 0, 3, 1, 1, 0, 0, 3, 1, 2, 3};
  bytes.append(66, '\0');
  return bytes + std::string{2, static_cast<char>(255), 0, 0, 0, 0, static_cast<char>(255)};
}

TEST_F(Export, a_folder_gives_every_draft_that_opens) {
  write_file_atomically(path("drafts/c.dtx"), dtx());
  write_file_atomically(path("drafts/deep/D.WPO"), wpo());
  write_file_atomically(path("drafts/notes.txt"), "no draft");
  const Ran ran = exported({"--target", "raw", "--size", "16", "--jobs", "2"});
  EXPECT_EQ(ran.code, kDone) << ran.said;
  for (const char* set : {"a", "b", "c", "D"}) EXPECT_TRUE(has(std::string(set) + "/texture_set.json")) << set;
  EXPECT_NE(ran.said.find("4 sets written"), std::string::npos) << ran.said;
  EXPECT_NE(exported({"--target", "raw", "--size", "16", "--resume"}).said.find("0 sets written, 4 already complete"),
            std::string::npos);
  write_file_atomically(path("drafts/c.dtx"), dtx("1 1 2"));
  EXPECT_NE(exported({"--target", "raw", "--size", "16", "--resume"}).said.find("1 set written, 3 already complete"),
            std::string::npos);
}

TEST_F(Export, drafts_of_one_name_and_several_formats_have_a_set_each) {
  write_file_atomically(path("drafts/a.dtx"), dtx());
  EXPECT_EQ(exported({"--target", "raw", "--size", "16"}).code, kDone);
  EXPECT_EQ(list("a")["source"], "a.wif") << "as before there was the other";
  EXPECT_EQ(list("a-dtx")["source"], "a.dtx");
}

TEST_F(Export, a_wif_that_comes_beside_a_draft_of_its_name_takes_no_set) {
  fs::remove(path("drafts/a.wif"));
  write_file_atomically(path("drafts/a.dtx"), dtx());
  EXPECT_EQ(exported({"--target", "raw", "--size", "16"}).code, kDone);
  fs::copy_file(fixture_path("twill.wif"), path("drafts/a.wif"));
  const Ran ran = exported({"--target", "raw", "--size", "16"});
  EXPECT_EQ(ran.code, kNotWritten);
  EXPECT_NE(ran.said.find("choose another folder"), std::string::npos) << ran.said;
  EXPECT_EQ(list("a")["source"], "a.dtx");
}

TEST_F(Export, a_file_in_the_place_of_the_output_folder_is_named_once) {
  write_file_atomically(path("sets"), "a file");
  const Ran ran = exported({"--target", "raw", "--size", "16"});
  EXPECT_EQ(ran.code, kNotWritten);
  EXPECT_NE(ran.said.find("sets: is a file; choose another"), std::string::npos) << ran.said;
  EXPECT_EQ(std::ranges::count(ran.said, '\n'), 1) << ran.said;
  EXPECT_EQ(read_file(path("sets")).value_or(""), "a file");
}

TEST_F(Export, a_folder_without_drafts_says_what_would_be_one) {
  fs::remove_all(path("drafts"));
  fs::create_directories(path("drafts"));
  write_file_atomically(path("drafts/notes.txt"), "no draft");
  const Ran ran = exported({"--target", "raw"});
  EXPECT_EQ(ran.code, kBadInput);
  EXPECT_NE(ran.said.find("no draft in it (.wif, .dtx, .wpo)"), std::string::npos) << ran.said;
}

class CutShort : public Export {
 protected:
  /// Ends an export of several large sets by a signal once files of one are there; its status as of waitpid().
  int cut_short(int signal) {
    const pid_t child = fork();
    if (child == 0) {
      execl(WEFTLIGHT_BINARY, WEFTLIGHT_BINARY, "export", path("drafts/a.wif").c_str(), "-o", path("sets").c_str(),
            "--target", "gltf,u3m", "--size", "2048", "--quiet", nullptr);
      _exit(127);
    }
    const auto begun = [&] { return fs::exists(path("sets/a")) && !fs::is_empty(path("sets/a")); };
    for (int i = 0; i < 6000 && !begun(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_TRUE(begun());
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_FALSE(has("a/gltf/texture_set.json")) << "it was cut short";
    return status;
  }
};

TEST_F(CutShort, one_that_is_interrupted_leaves_nothing_and_ends_as_programs_do_then) {
  const int status = cut_short(SIGINT);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
  for (const auto& entry : fs::recursive_directory_iterator(path("sets"))) EXPECT_EQ(entry.path(), path("sets/a"));
}

TEST_F(CutShort, what_one_that_was_killed_left_is_not_in_the_way_of_another) {
  cut_short(SIGKILL);
  const Ran ran = run({"export", path("drafts/a.wif"), "-o", path("sets"), "--target", "gltf", "--size", "16"});
  EXPECT_EQ(ran.code, kDone) << ran.said;
  EXPECT_TRUE(has("a/texture_set.json"));
  EXPECT_FALSE(has("a/gltf"));
  for (const auto& entry : fs::directory_iterator(path("sets/a"))) EXPECT_FALSE(entry.is_directory()) << entry.path();
}

/// An export that watches its drafts.
class WatchedExport : public Export {
 protected:
  void watch(const std::string& target) {
    child_ = fork();
    if (child_ != 0) return;
    execl(WEFTLIGHT_BINARY, WEFTLIGHT_BINARY, "export", path("drafts").c_str(), "-o", path("sets").c_str(), "--target",
          target.c_str(), "--size", "16", "--watch", nullptr);
    _exit(127);
  }
  void TearDown() override {
    if (child_ > 0) kill(child_, SIGTERM), waitpid(child_, nullptr, 0);
    Export::TearDown();
  }
  template <class What>
  static bool comes(const What& what) {
    for (int i = 0; i < 600 && !what(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return what();
  }

 private:
  pid_t child_ = 0;
};

TEST_F(WatchedExport, changed_drafts_are_exported_again) {
  write_file_atomically(path("drafts/c.dtx"), dtx());
  watch("raw");
  EXPECT_TRUE(comes([&] { return has("a/texture_set.json"); }));
  // The first sets may still be in progress: a change during that time must not be missed.
  fs::copy_file(fixture_path("luminescence.wif"), path("drafts/a.wif"), fs::copy_options::overwrite_existing);
  const auto ends = [&] { return list("a")["repeat"]["ends"].get<int>(); };
  const int before = ends();
  EXPECT_TRUE(comes([&] { return ends() != before; })) << before;
  ASSERT_TRUE(comes([&] { return has("c/texture_set.json"); }));
  const auto picks = [&] { return list("c")["repeat"]["picks"].get<int>(); };
  const int picks_before = picks();
  write_file_atomically(path("drafts/c.dtx"), dtx("1 1 2"));
  EXPECT_TRUE(comes([&] { return picks() != picks_before; })) << picks_before;
}

TEST_F(WatchedExport, a_material_has_the_date_of_the_draft_that_it_shows) {
  const auto dated = [&](int hours) {
    fs::last_write_time(path("drafts/a.wif"), fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  const auto date = [&] {
    const std::string material = read_file(path("sets/a/a.u3m")).value_or("");
    const size_t at = material.find(R"("modified": )");
    return at == std::string::npos ? std::string() : material.substr(at, 32);
  };
  dated(48);
  watch("u3m");
  ASSERT_TRUE(comes([&] { return has("a/texture_set.json"); }));
  const std::string before = date();
  dated(24);
  EXPECT_TRUE(comes([&] { return !date().empty() && date() != before; })) << before;
}

TEST_F(Export, masks_and_units_of_texture_coordinates_are_options_of_every_target) {
  EXPECT_EQ(exported({"--target", "raw,unity-urp", "--size", "16", "--masks", "--uv", "cm", "--uv-offset", "5,0"}).code,
            kDone);
  EXPECT_TRUE(has("a/raw/a_front_white.png") && has("a/unity-urp/a_back_index.png"));
  const json a = list("a/unity-urp");
  EXPECT_EQ(a["texture_coordinates"], "centimetres");
  EXPECT_NEAR(a["uv"]["offset"][0].get<double>(), -5 / a["size_mm"][0].get<double>(), 1e-4);
  EXPECT_FALSE(a["recolour"]["colors"].empty());
  const Ran inch = exported({"--uv", "inch"});
  EXPECT_EQ(inch.code, kUsage);
  EXPECT_TRUE(inch.said.find("--uv") != std::string::npos && inch.said.find("tile") != std::string::npos) << inch.said;
  EXPECT_EQ(exported({"--uv-offset", "5"}).code, kUsage);
}

}  // namespace
}  // namespace weftlight::commands
