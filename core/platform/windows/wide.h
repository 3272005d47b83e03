#pragma once
// Texts and errors of Windows. The program's texts are UTF-8, those of the system UTF-16.

#include <string>
#include <string_view>
#include <system_error>

namespace weftlight::platform {

/// What is not UTF-8 becomes U+FFFD.
std::wstring wide(std::string_view text);
/// Half of a pair of surrogates, which a name of a file may hold, becomes U+FFFD.
std::string narrow(std::wstring_view text);

/// Of the last call of this thread (GetLastError). Compares with std::errc.
std::error_code last_error();

}  // namespace weftlight::platform
