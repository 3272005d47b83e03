#pragma once
// Which keys run actions while text is typed, and which at the loom.

#include <string>

namespace weftlight::actions {

/// True if a text field has no use for the shortcut, written as in menus ("Ctrl+S").
bool runs_while_typing(const std::string& shortcut);
/// The action of a key at the loom, where large keys and foot pedals step the picks; else empty.
std::string key_at_loom(const std::string& key);

}  // namespace weftlight::actions
