#include <gtest/gtest.h>

#include <cctype>

#include "../variable.h"
#include "base/json.h"
#include "scratch_folder.h"

namespace weftlight::commands {
namespace {

using Find = ScratchFolder;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

TEST_F(Find, ListsTheDraftsThatHaveWhatIsAskedFor) {
  const Variable cache("XDG_CACHE_HOME", path("cache"));
  const std::string folder = std::string(WEFTLIGHT_TESTS_DIR) + "/fixtures";
  const auto found = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"find", folder, "--json"});
    const Ran ran = run(more);
    EXPECT_EQ(ran.code, kDone) << ran.said;
    return nlohmann::json::parse(ran.out);
  };
  const nlohmann::json all = found({});
  EXPECT_EQ(all["drafts"].size(), all["of"]);
  const nlohmann::json twills = found({"twill", "--family", "twill", "--shafts", "4"});
  ASSERT_FALSE(twills["drafts"].empty());
  for (const nlohmann::json& draft : twills["drafts"]) {
    EXPECT_EQ(draft["shafts"], 4);
    EXPECT_EQ(draft["family"], "twill");
    const std::string text = draft["path"].get<std::string>() + draft["title"].get<std::string>();
    EXPECT_NE(lower(text).find("twill"), std::string::npos) << text;
  }
  EXPECT_TRUE(found({"--shafts", "900-"})["drafts"].empty());
  EXPECT_TRUE(std::filesystem::exists(path("cache") + "/weftlight/folders")) << "the index is kept";
  EXPECT_EQ(found({"--fresh"}), all);
}

TEST_F(Find, ATitleThatIsTheWeaveIsToldOnce) {
  const Variable cache("XDG_CACHE_HOME", path("cache"));
  ASSERT_EQ(run({"weave", "twill", "-o", path("a.wif")}).code, kDone);
  const Ran ran = run({"find", path("")});
  EXPECT_TRUE(ran.out.ends_with("4 treadles, Twill\n")) << ran.out;
}

TEST_F(Find, SaysThatNothingMatches) {
  const Variable cache("XDG_CACHE_HOME", path("cache"));
  EXPECT_NE(run({"find", path("")}).said.find("There are no drafts in this folder."), std::string::npos);
  ASSERT_EQ(run({"weave", "twill", "-o", path("a.wif")}).code, kDone);
  const Ran none = run({"find", path(""), "--shafts", "900-"});
  EXPECT_EQ(none.code, kDone);
  EXPECT_EQ(none.out, "");
  EXPECT_NE(none.said.find("No draft matches."), std::string::npos) << none.said;
}

TEST_F(Find, SaysWhatItCannotUse) {
  EXPECT_EQ(run({"find", path("nowhere")}).code, kBadInput);
  EXPECT_EQ(run({"find"}).code, kUsage);
  EXPECT_EQ(run({"find", ".", "--shafts", "8-4"}).code, kUsage);
  EXPECT_EQ(run({"find", ".", "--family", "brocade"}).code, kUsage);
  EXPECT_EQ(run({"find", ".", "--color", "mauve"}).code, kUsage);
}

}  // namespace
}  // namespace weftlight::commands
