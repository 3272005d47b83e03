#include "platform/own_addresses.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>
#include <memory>

namespace weftlight::platform {
namespace {

constexpr size_t kMaxAddresses = 32;

/// In numbers; empty if it is of no family that is known, or reaches one cable only.
std::string text_of(const sockaddr& address) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  if (address.sa_family == AF_INET) {
    const in_addr& number = reinterpret_cast<const sockaddr_in&>(address).sin_addr;
    if ((ntohl(number.s_addr) >> 16) == 0xa9fe) return {};  // 169.254
    ::inet_ntop(AF_INET, &number, text.data(), text.size());
  } else if (address.sa_family == AF_INET6) {
    const in6_addr& number = reinterpret_cast<const sockaddr_in6&>(address).sin6_addr;
    if (IN6_IS_ADDR_LINKLOCAL(&number)) return {};
    ::inet_ntop(AF_INET6, &number, text.data(), text.size());
  }
  return text.data();
}

}  // namespace

std::vector<OwnAddress> own_addresses() {
  std::vector<OwnAddress> all{{"127.0.0.1", {}, true}};
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0) return all;
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> list(first, ::freeifaddrs);
  for (const ifaddrs* each = first; each != nullptr && all.size() < kMaxAddresses; each = each->ifa_next) {
    const bool up = (each->ifa_flags & IFF_UP) != 0, loopback = (each->ifa_flags & IFF_LOOPBACK) != 0;
    if (!up || loopback || each->ifa_addr == nullptr) continue;
    if (std::string text = text_of(*each->ifa_addr); !text.empty()) all.push_back({std::move(text), each->ifa_name});
  }
  // Not of std::ranges, whose views clang 14 cannot read.
  std::stable_partition(all.begin(), all.end(),
                        [](const OwnAddress& one) { return one.address.find(':') == std::string::npos; });
  return all;
}

}  // namespace weftlight::platform
