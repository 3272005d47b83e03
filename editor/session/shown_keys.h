#pragma once
// Shortcuts as the user's keyboard is labelled.

#include <string>

namespace weftlight::session {

/// "Strg+Umschalt+K" for "Ctrl+Shift+K", which is how actions and the settings name it.
std::string shown_keys(const std::string& shortcut);

}  // namespace weftlight::session
