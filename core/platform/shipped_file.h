#pragma once
// Files that belong to the program but need not come with it: a page fetches them when they are needed.

#include <string>

namespace weftlight::platform {

/// Whether the file of the program's folders is there. In a page it is fetched first, on any thread but the page's own,
/// which must not wait.
bool is_shipped(const std::string& path);

}  // namespace weftlight::platform
