#pragma once
// Where the system keeps what belongs to the user and to the program. Paths without a slash at their end.

#include <string>

namespace weftlight::platform {

/// The folder of the program's file, or of the module's that holds this code; empty if the system does not tell.
std::string program_folder();
/// The user's home; empty if there is none.
std::string home_folder();

/// The user's folders of all programs: for settings; for what must outlive a restart, such as unsaved work; for what
/// can be made again.
std::string settings_folder();
std::string state_folder();
std::string cache_folder();

}  // namespace weftlight::platform
