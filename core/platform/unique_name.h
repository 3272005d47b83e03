#pragma once
// Names for temporary files and folders, on disks that several machines may share.

#include <string>
#include <string_view>

namespace weftlight::platform {

/// 64 random bits as 16 hexadecimal digits.
std::string unique_name();
bool is_unique_name(std::string_view name);

}  // namespace weftlight::platform
