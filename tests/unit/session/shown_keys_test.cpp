// Shortcuts as the user's keyboard is labelled.

#include "session/shown_keys.h"

#include <gtest/gtest.h>

namespace weftlight::session {
namespace {

TEST(ShownKeys, AreThoseOfTheTableInEnglish) {
  for (const char* keys : {"", "O", "F10", "Ctrl+S", "Ctrl+Shift+PageDown", "Ctrl++", "Ctrl+-", "+", "Shift+End"})
    EXPECT_EQ(shown_keys(keys), keys);
}

}  // namespace
}  // namespace weftlight::session
