#pragma once
// What a system's body tells of its networks; own_addresses.h makes of it what is shown.

#include <string>
#include <vector>

namespace weftlight::platform {

struct FoundAddress {
  std::vector<unsigned char> bytes;  // 4 of IPv4, 16 of IPv6, in the order of the network
  std::string network;               // name of its interface
};
/// Those of a number of the system's own type.
template <class Number>
std::vector<unsigned char> bytes_of(const Number& number) {
  const auto* first = reinterpret_cast<const unsigned char*>(&number);
  return {first, first + sizeof number};
}
/// Of all networks that are up, but not of the machine with itself.
std::vector<FoundAddress> found_addresses();

}  // namespace weftlight::platform
