#include "actions/keys.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace weftlight::actions {

bool runs_while_typing(const std::string& shortcut) {
  // F1 to F12.
  if (shortcut.size() > 1 && shortcut[0] == 'F' && std::isdigit(static_cast<unsigned char>(shortcut[1]))) return true;
  if (!shortcut.starts_with("Ctrl+")) return false;
  // Used by text fields: clipboard, undo and cursor movement by words.
  constexpr std::array<std::string_view, 16> kOfText = {
      "Ctrl+A",     "Ctrl+C",  "Ctrl+V",    "Ctrl+X",      "Ctrl+Z",       "Ctrl+Shift+Z", "Ctrl+Y",   "Ctrl+Left",
      "Ctrl+Right", "Ctrl+Up", "Ctrl+Down", "Ctrl+Delete", "Ctrl+Shift+V", "Ctrl+Home",    "Ctrl+End", "Ctrl+Enter"};
  return std::find(kOfText.begin(), kOfText.end(), shortcut) == kOfText.end();
}

std::string key_at_loom(const std::string& key) {
  constexpr const char* kOn[] = {"Space", "Enter", "Right", "Down", "PageDown"};
  constexpr const char* kBack[] = {"Delete", "Left", "Up", "PageUp"};  // Backspace is called Delete
  if (std::find(std::begin(kOn), std::end(kOn), key) != std::end(kOn)) return "loom_next";
  if (std::find(std::begin(kBack), std::end(kBack), key) != std::end(kBack)) return "loom_back";
  if (key == "T") return "loom_tabby";
  if (key == "S") return "loom_say";
  return key == "Escape" ? "loom" : "";
}

}  // namespace weftlight::actions
