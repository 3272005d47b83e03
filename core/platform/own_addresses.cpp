#include "platform/own_addresses.h"

#include <algorithm>
#include <asio/ip/address.hpp>

#include "platform/found_addresses.h"

namespace weftlight::platform {
namespace {

constexpr size_t kMaxAddresses = 32;

/// In numbers; empty if it is of no family that is known, or reaches one cable only.
std::string text_of(const std::vector<unsigned char>& bytes) {
  asio::ip::address_v4::bytes_type v4{};
  asio::ip::address_v6::bytes_type v6{};
  if (bytes.size() == v4.size()) {
    std::copy(bytes.begin(), bytes.end(), v4.begin());
    if (v4[0] == 169 && v4[1] == 254) return {};
    return asio::ip::address_v4(v4).to_string();
  }
  if (bytes.size() != v6.size()) return {};
  std::copy(bytes.begin(), bytes.end(), v6.begin());
  const asio::ip::address_v6 address(v6);
  return address.is_link_local() ? std::string() : address.to_string();
}

}  // namespace

std::vector<OwnAddress> own_addresses() {
  std::vector<OwnAddress> all{{"127.0.0.1", {}, true}};
  for (FoundAddress& found : found_addresses())
    if (std::string text = text_of(found.bytes); !text.empty() && all.size() < kMaxAddresses)
      all.push_back({std::move(text), std::move(found.network)});
  // Not of std::ranges, whose views clang 14 cannot read.
  std::stable_partition(all.begin(), all.end(),
                        [](const OwnAddress& one) { return one.address.find(':') == std::string::npos; });
  return all;
}

}  // namespace weftlight::platform
