#pragma once
// When a key runs an action: always, or only while nothing is being typed.

#include <string>

#include "actions/names.h"

namespace weftlight::actions {

/// Whether a shortcut as menus write it ("Ctrl+S") is one that a text field has no use for.
bool runs_while_typing(const std::string& shortcut);
/// The action that a key means at the loom, where hands are busy and pedals send what they send; else empty.
std::string key_at_loom(const std::string& key);

}  // namespace weftlight::actions
