// The page's own file system: resources come with the program, the home is for the browser's storage.

#include "platform/folders.h"

namespace weftlight::platform {

std::string program_folder() { return "/weftlight"; }
std::string home_folder() { return "/home/web_user"; }
std::string settings_folder() { return "/home/web_user/settings"; }
std::string state_folder() { return "/home/web_user/state"; }
std::string cache_folder() { return "/cache"; }

}  // namespace weftlight::platform
