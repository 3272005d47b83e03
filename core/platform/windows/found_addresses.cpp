#include "platform/found_addresses.h"

#include <winsock2.h>
#include <ws2tcpip.h>
// After them, whose words it needs.
#include <iphlpapi.h>

#include "platform/windows/wide.h"

namespace weftlight::platform {
namespace {

/// Empty if it is of no family that is known.
std::vector<unsigned char> number_of(const sockaddr& address) {
  if (address.sa_family == AF_INET) return bytes_of(reinterpret_cast<const sockaddr_in&>(address).sin_addr);
  if (address.sa_family == AF_INET6) return bytes_of(reinterpret_cast<const sockaddr_in6&>(address).sin6_addr);
  return {};
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

std::vector<FoundAddress> found_addresses() {
  std::vector<FoundAddress> all;
  const std::vector<IP_ADAPTER_ADDRESSES> list = adapters();
  for (const IP_ADAPTER_ADDRESSES* each = list.empty() ? nullptr : list.data(); each != nullptr; each = each->Next) {
    if (each->OperStatus != IfOperStatusUp || each->IfType == IF_TYPE_SOFTWARE_LOOPBACK) continue;
    for (const auto* at = each->FirstUnicastAddress; at != nullptr; at = at->Next)
      all.push_back(
          {number_of(*at->Address.lpSockaddr), each->FriendlyName != nullptr ? narrow(each->FriendlyName) : ""});
  }
  return all;
}

}  // namespace weftlight::platform
