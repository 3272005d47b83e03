// The handbook names menus, keys and controls that are there: `**Menu > Command**`, `<kbd>Key</kbd>` and `*Control*`.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bare_editor.h"
#include "paths.h"

namespace weftlight::actions {
namespace {

namespace fs = std::filesystem;

design::Design small() {
  design::Design d;
  d.draft = draft::blank_draft(4, 4, 2, 2);
  return d;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The pages, with blanks for line ends.
std::vector<std::pair<std::string, std::string>> pages() {
  std::vector<std::pair<std::string, std::string>> out;
  for (const auto& entry : fs::directory_iterator(WEFTLIGHT_SOURCE_DIR "/docs/handbook")) {
    if (entry.path().extension() != ".md") continue;
    std::string text = std::regex_replace(text_of(entry.path()), std::regex("```[^`]*```"), "");
    out.emplace_back(entry.path().filename().string(), std::regex_replace(text, std::regex("\\s+"), " "));
  }
  return out;
}

std::vector<std::string> found(const std::string& text, const std::string& pattern) {
  const std::regex wanted(pattern);
  std::vector<std::string> out;
  for (std::sregex_iterator at(text.begin(), text.end(), wanted), end; at != end; ++at) out.push_back((*at)[1]);
  return out;
}

class Handbook : public testing::Test {
 protected:
  Handbook() {
    for (const Action& a : make_actions(editor_.subjects(), {})) {
      const std::string& menu = a.item.menu;
      paths_.insert(menu + " > " + a.item.label);
      if (!a.item.submenu.empty()) paths_.insert(menu + " > " + a.item.submenu + " > " + a.item.label);
      if (!a.item.shortcut.empty())
        keys_.insert(a.item.shortcut), key_of_[menu + " > " + a.item.label] = a.item.shortcut;
    }
  }
  BareEditor editor_{small()};
  std::set<std::string> paths_, keys_;
  std::map<std::string, std::string> key_of_;
};

TEST_F(Handbook, NamesMenusThatAreThere) {
  for (const auto& [page, text] : pages())
    for (const std::string& path : found(text, "\\*\\*([A-Z][a-z]+ > [^*]+)\\*\\*"))
      EXPECT_TRUE(paths_.contains(path)) << page << ": " << path;
}

TEST_F(Handbook, NamesKeysThatAreThere) {
  for (const auto& [page, text] : pages())
    for (const std::string& key : found(text, "<kbd>([^<]*)</kbd>"))
      EXPECT_TRUE(keys_.contains(key)) << page << ": " << key;
}

/// `**Menu > Command** (<kbd>Key</kbd>` and `<kbd>Key</kbd> (**Menu > Command**` are pairs.
TEST_F(Handbook, GivesEachCommandItsOwnKey) {
  const std::string menu = "\\*\\*([A-Z][a-z]+ > (?:[^*>]+ > )?[^*]+)\\*\\*", key = "<kbd>([^<]*)</kbd>";
  int pairs = 0;
  for (const auto& [page, text] : pages())
    for (const bool key_first : {false, true}) {
      const std::regex pair(key_first ? key + " \\(" + menu : menu + " \\(" + key);
      for (std::sregex_iterator at(text.begin(), text.end(), pair), end; at != end; ++at, ++pairs) {
        std::string path = (*at)[key_first ? 2 : 1];
        const std::string last = path.substr(path.rfind(" > "));
        path = path.substr(0, path.find(" > ")) + last;  // the submenu is no part of the table's key
        EXPECT_EQ(key_of_[path], std::string((*at)[key_first ? 1 : 2])) << page << ": " << path;
      }
    }
  EXPECT_GT(pairs, 15);
}

TEST_F(Handbook, NamesControlsThatTheWindowHas) {
  const std::string catalogue =
      std::regex_replace(text_of(WEFTLIGHT_SOURCE_DIR "/editor/languages/weftlight.pot"), std::regex("\"\\n\""), "");
  for (const auto& [page, text] : pages())
    for (const std::string& control : found(text, "(?:^|[^*])\\*([A-Za-z][^*]*)\\*(?:[^*]|$)"))
      EXPECT_NE(catalogue.find("msgid \"" + control + "\""), std::string::npos) << page << ": " << control;
}

}  // namespace
}  // namespace weftlight::actions
