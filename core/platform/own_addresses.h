#pragma once
// The addresses under which others in the network find this machine.

#include <string>
#include <vector>

namespace weftlight::platform {

struct OwnAddress {
  std::string address;  // in numbers
  std::string network;  // name of its interface: "wlan0"
  bool this_machine_only = false;
};
/// 127.0.0.1 first, then those of networks that are up: IPv4, then IPv6. Link-local addresses are left out, since a
/// browser elsewhere cannot write them. At most 32.
std::vector<OwnAddress> own_addresses();

}  // namespace weftlight::platform
