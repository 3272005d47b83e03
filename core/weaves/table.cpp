#include "weaves/table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <iterator>
#include <string_view>
#include <utility>

#include "weaves/families.h"
#include "weaves/kinds.h"

namespace weftlight::weaves {

namespace {

std::vector<WeaveKind> made_kinds() {
  std::vector<WeaveKind> all;
  for (std::vector<WeaveKind>& family :
       std::array{simple_kinds(), twill_kinds(), texture_kinds(), lace_kinds(), block_kinds(), tied_kinds(),
                  parallel_kinds(), layer_kinds(), written_kinds(), color_kinds()})
    std::ranges::move(family, std::back_inserter(all));
  return all;
}

const std::vector<WeaveKind>& all_kinds() {
  static const std::vector<WeaveKind> kKinds = made_kinds();
  return kKinds;
}

std::string completed(const WeaveParameter& parameter, const std::string* given) {
  if (!given) return parameter.default_value;
  if (parameter.kind == ParameterKind::kText) return *given;
  if (parameter.kind == ParameterKind::kChoice) {
    const bool known = std::ranges::any_of(parameter.choices, [&](const char* c) { return *given == c; });
    return known ? *given : parameter.default_value;
  }
  int n = 0;
  if (std::from_chars(given->data(), given->data() + given->size(), n).ec != std::errc{})
    return parameter.default_value;
  return std::to_string(std::clamp(n, parameter.low, parameter.high));
}

}  // namespace

std::span<const WeaveKind> weave_kinds() { return all_kinds(); }

const WeaveKind* find_weave(std::string_view id) {
  const auto found = std::ranges::find_if(all_kinds(), [id](const WeaveKind& kind) { return id == kind.id; });
  return found != all_kinds().end() ? &*found : nullptr;
}

WeaveValues complete_values(const WeaveKind& kind, const WeaveValues& given) {
  WeaveValues values;
  for (const WeaveParameter& parameter : kind.parameters) {
    const auto found = std::ranges::find_if(given, [&](const auto& v) { return v.first == parameter.id; });
    values.emplace_back(parameter.id, completed(parameter, found != given.end() ? &found->second : nullptr));
  }
  std::ranges::sort(values);
  return values;
}

WeaveValues allowed_values(const WeaveKind& kind, const WeaveValues& given) {
  WeaveValues values = complete_values(kind, given);
  for (const WeaveParameter& parameter : kind.parameters) {
    if (parameter.allowed == nullptr) continue;
    const int wanted = count(values, parameter.id);
    const auto away = [wanted](int n) { return std::abs(n - wanted); };
    const std::vector<int> all = parameter.allowed(parameter, values);
    const auto best = std::ranges::min_element(all, {}, away);
    const auto at = std::ranges::find(values, std::string(parameter.id), &WeaveValues::value_type::first);
    if (best != all.end()) at->second = std::to_string(*best);
  }
  return values;
}

base::Result<void> check_values(const WeaveKind& kind, const WeaveValues& values) {
  for (const WeaveParameter& parameter : kind.parameters) {
    const std::string_view id = parameter.id;
    if (id == "ratio") {
      Noted<OverUnder> read = ratio(complete_values(kind, values));
      if (!read.note.empty()) return base::failure(base::ErrorKind::kInput, std::move(read.note));
    }
    if (id == "code")
      if (const auto read = read_iso_code(text(complete_values(kind, values), "code")); !read) return failed(read);
  }
  return {};
}

}  // namespace weftlight::weaves
