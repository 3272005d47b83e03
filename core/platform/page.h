#pragma once
// Whether the program is a page in a browser. Then nothing of it quits, and it has an address that can carry a draft.

#include <string>

namespace weftlight::platform {

bool is_page();
/// Whether fingers press what it shows: a pointer that is coarse, or a finger that was seen.
bool is_touched();
/// Puts the address of the page with this text of a draft in it on the clipboard, and says so, or why it could not.
/// Only where is_page().
void copy_link(const std::string& draft);

}  // namespace weftlight::platform
