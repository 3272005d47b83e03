#pragma once
// A catalogue as msgfmt compiles it, and the rule by which a language chooses the form of a plural. For systems without
// gettext.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace weftlight::platform {

/// What a plural rule of C's operators gives for `count`, as "n != 1" or "n%10==1 ? 0 : 1"; nothing if it is none.
std::optional<uint64_t> plural_form(std::string_view rule, uint64_t count);

class CompiledCatalogue {
 public:
  /// Texts that lie outside `bytes` are left out, and bytes that are no catalogue make an empty one.
  explicit CompiledCatalogue(std::string bytes);
  CompiledCatalogue(const CompiledCatalogue&) = delete;  // the texts point into the bytes
  CompiledCatalogue& operator=(const CompiledCatalogue&) = delete;

  /// As it is found in the catalogue, which ends it with a zero; null if it is not there.
  const char* text(std::string_view key) const;
  const char* text(std::string_view one, uint64_t count) const;
  /// A field of the header, as "Language"; empty if there is none.
  std::string field(std::string_view name) const;

 private:
  std::string bytes_;
  std::unordered_map<std::string_view, std::string_view>
      texts_;  // all forms of a plural, a zero after each but the last
  std::string plural_rule_;
};

}  // namespace weftlight::platform
