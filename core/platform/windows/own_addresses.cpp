#include "platform/own_addresses.h"

#include <winsock2.h>
#include <ws2tcpip.h>
// After them, whose words it needs.
#include <iphlpapi.h>

#include <algorithm>
#include <array>

#include "platform/windows/wide.h"

namespace weftlight::platform {
namespace {

constexpr size_t kMaxAddresses = 32;

/// In numbers; empty if it is of no family that is known, or reaches one cable only.
std::string text_of(const sockaddr& address) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  if (address.sa_family == AF_INET) {
    const in_addr& number = reinterpret_cast<const sockaddr_in&>(address).sin_addr;
    if ((::ntohl(number.s_addr) >> 16) == 0xa9fe) return {};  // 169.254
    ::inet_ntop(AF_INET, &number, text.data(), text.size());
  } else if (address.sa_family == AF_INET6) {
    const in6_addr& number = reinterpret_cast<const sockaddr_in6&>(address).sin6_addr;
    if (IN6_IS_ADDR_LINKLOCAL(&number)) return {};
    ::inet_ntop(AF_INET6, &number, text.data(), text.size());
  }
  return text.data();
}

/// The list of adapters in a buffer that is large enough; empty without a network.
std::vector<IP_ADAPTER_ADDRESSES> adapters() {
  constexpr ULONG kFlags = GAA_FLAG_SKIP_ANYCAST | GAA_FLAG_SKIP_MULTICAST | GAA_FLAG_SKIP_DNS_SERVER;
  std::vector<IP_ADAPTER_ADDRESSES> buffer(64);
  for (int i = 0; i < 3; ++i) {
    auto bytes = static_cast<ULONG>(buffer.size() * sizeof buffer[0]);
    const ULONG result = ::GetAdaptersAddresses(AF_UNSPEC, kFlags, nullptr, buffer.data(), &bytes);
    if (result == ERROR_SUCCESS) return buffer;
    if (result != ERROR_BUFFER_OVERFLOW) break;
    buffer.resize(bytes / sizeof buffer[0] + 1);
  }
  return {};
}

}  // namespace

std::vector<OwnAddress> own_addresses() {
  std::vector<OwnAddress> all{{"127.0.0.1", {}, true}};
  const std::vector<IP_ADAPTER_ADDRESSES> list = adapters();
  for (const IP_ADAPTER_ADDRESSES* each = list.empty() ? nullptr : list.data(); each != nullptr; each = each->Next) {
    if (each->OperStatus != IfOperStatusUp || each->IfType == IF_TYPE_SOFTWARE_LOOPBACK) continue;
    for (const auto* at = each->FirstUnicastAddress; at != nullptr && all.size() < kMaxAddresses; at = at->Next)
      if (std::string text = text_of(*at->Address.lpSockaddr); !text.empty())
        all.push_back({std::move(text), each->FriendlyName != nullptr ? narrow(each->FriendlyName) : ""});
  }
  std::stable_partition(all.begin(), all.end(),
                        [](const OwnAddress& one) { return one.address.find(':') == std::string::npos; });
  return all;
}

}  // namespace weftlight::platform
