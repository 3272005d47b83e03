// Which shortcuts run while a text field has the keyboard; and that ids and shortcuts are unique.

#include "actions/keys.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "actions/actions.h"
#include "bare_editor.h"

namespace weftlight::actions {

using design::Design;
using draft::blank_draft;

namespace {

Design small() {
  Design d;
  d.draft = blank_draft(4, 4, 2, 2);
  return d;
}

TEST(Keys, SavingWorksWhileTypingAndTextFieldsKeepTheirKeys) {
  for (const char* key : {"Ctrl+S", "Ctrl+Shift+S", "Ctrl+O", "Ctrl+P", "Ctrl+Q", "F1", "F4", "F12"})
    EXPECT_TRUE(runs_while_typing(key)) << key;
  for (const char* key : {"Ctrl+C", "Ctrl+V", "Ctrl+X", "Ctrl+A", "Ctrl+Z", "Ctrl+Shift+Z", "Home", "End", "Delete",
                          "F", "S", "Shift+H", "Enter", "Left", "Ctrl+Left"})
    EXPECT_FALSE(runs_while_typing(key)) << key;
}

TEST(Keys, LargeKeysAndPedalsStepAtTheLoom) {
  for (const char* key : {"Space", "Enter", "Right", "Down", "PageDown"}) EXPECT_EQ(key_at_loom(key), "loom_next");
  for (const char* key : {"Delete", "Left", "Up", "PageUp"}) EXPECT_EQ(key_at_loom(key), "loom_back");
  EXPECT_EQ(key_at_loom("T"), "loom_tabby");
  EXPECT_EQ(key_at_loom("S"), "loom_say");
  EXPECT_EQ(key_at_loom("Escape"), "loom");
  EXPECT_EQ(key_at_loom("Ctrl+Z"), "");
}

TEST(Table, IdsAndShortcutsAreUnique) {
  BareEditor editor(small());
  std::set<std::string> ids;
  std::map<std::string, std::string> keys;
  for (const Action& a : make_actions(editor.subjects(), {})) {
    EXPECT_TRUE(ids.insert(a.item.id).second) << a.item.id;
    if (a.item.shortcut.empty()) continue;
    EXPECT_TRUE(keys.emplace(a.item.shortcut, a.item.id).second)
        << a.item.shortcut << " runs " << keys[a.item.shortcut] << " and " << a.item.id;
  }
}

TEST(Table, AnIdWithoutNamesHoldsNothingOfTheUser) {
  BareEditor editor(small());
  int with_names = 0;
  for (const Action& a : make_actions(editor.subjects(), {"/home/anna/cloth.wif"}, {}, {"anna from above"})) {
    EXPECT_EQ(nameless_id(a.item.id).find("anna"), std::string::npos) << a.item.id;
    if (a.item.id.find("anna") != std::string::npos) ++with_names;
    else EXPECT_EQ(nameless_id(a.item.id), a.item.id);
  }
  EXPECT_EQ(with_names, 2);
  EXPECT_EQ(nameless_id("recent:/home/anna/cloth.wif"), "recent");
}

TEST(Table, UserShortcutsReplaceTheDefaults) {
  BareEditor editor(small());
  const std::vector<Action> all =
      make_actions(editor.subjects(), {}, {{"save", "Ctrl+U"}, {"quit", ""}, {"no such action", "F24"}});
  for (const Action& a : all) {
    if (a.item.id == "save") {
      EXPECT_EQ(a.item.shortcut, "Ctrl+U");
      EXPECT_EQ(a.item.shipped, "Ctrl+S");
    }
    if (a.item.id == "quit") {
      EXPECT_EQ(a.item.shortcut, "");
    }
    EXPECT_NE(a.item.shortcut, "F24");
  }
}

TEST(Table, EveryWeaveIsInTheCommandPalette) {
  BareEditor editor(small());
  std::string labels;
  for (const Action& a : make_actions(editor.subjects(), {})) labels += a.item.label + "\n";
  for (const char* weave : {"Satin", "Herringbone", "Overshot", "Waffle"})
    EXPECT_NE(labels.find(weave), std::string::npos) << weave;
}

}  // namespace
}  // namespace weftlight::actions
