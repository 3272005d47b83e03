#pragma once
// The one hash of bytes.

#include <cstdint>
#include <string_view>

namespace weftlight::base {

/// FNV-1a, 64 bits (Fowler, Noll, Vo 1991): the same on every machine and in every version, as files hold it; not
/// cryptographic. To hash several pieces, pass the hash of the earlier ones as `from`.
constexpr uint64_t content_hash(std::string_view bytes, uint64_t from = 0xcbf29ce484222325u) {
  for (const char c : bytes) from = (from ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return from;
}

}  // namespace weftlight::base
