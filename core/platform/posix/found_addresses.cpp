#include "platform/found_addresses.h"

#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <memory>

namespace weftlight::platform {
namespace {

/// Empty if it is of no family that is known.
std::vector<unsigned char> number_of(const sockaddr& address) {
  if (address.sa_family == AF_INET) return bytes_of(reinterpret_cast<const sockaddr_in&>(address).sin_addr);
  if (address.sa_family == AF_INET6) return bytes_of(reinterpret_cast<const sockaddr_in6&>(address).sin6_addr);
  return {};
}

}  // namespace

std::vector<FoundAddress> found_addresses() {
  std::vector<FoundAddress> all;
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0) return all;
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> list(first, ::freeifaddrs);
  for (const ifaddrs* each = first; each != nullptr; each = each->ifa_next) {
    const bool up = (each->ifa_flags & IFF_UP) != 0, loopback = (each->ifa_flags & IFF_LOOPBACK) != 0;
    if (up && !loopback && each->ifa_addr != nullptr) all.push_back({number_of(*each->ifa_addr), each->ifa_name});
  }
  return all;
}

}  // namespace weftlight::platform
