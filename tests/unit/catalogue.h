#pragma once
// A compiled catalogue of gettext, for tests.

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace weftlight {

/// The bytes of a .mo with the texts. The first key is empty, for the header.
inline std::string catalogue_of(std::vector<std::pair<std::string, std::string>> texts) {
  std::sort(texts.begin(), texts.end());  // gettext looks keys up by halves
  const auto word = [](uint32_t value) { return std::string(reinterpret_cast<const char*>(&value), sizeof value); };
  const auto count = static_cast<uint32_t>(texts.size());
  constexpr uint32_t kHeader = 28;
  std::string keys, values, strings;
  const uint32_t first = kHeader + count * 16;
  const auto add = [&](std::string& table, const std::string& text) {
    table += word(static_cast<uint32_t>(text.size())) + word(first + static_cast<uint32_t>(strings.size()));
    strings += text + '\0';
  };
  for (const auto& [key, value] : texts) add(keys, key), add(values, value);
  return word(0x950412de) + word(0) + word(count) + word(kHeader) + word(kHeader + count * 8) + word(0) +
         word(kHeader + count * 16) + keys + values + strings;
}

}  // namespace weftlight
