#pragma once
// SHA-256 as lower-case hex. Based on: NIST, "Secure Hash Standard (FIPS 180-4)", 2015, section 6.2.

#include <string>
#include <string_view>

namespace weftlight::wif {

std::string sha256_hex(std::string_view bytes);

}  // namespace weftlight::wif
