#pragma once
// The one table of the methods that shade the cloth: what files, verbs and panels call each, and which of them are
// rungs that `auto` chooses among. What a new one takes: shaders/README.md.

#include <array>
#include <optional>
#include <string_view>

#include "draft/design.h"

namespace weftlight::draft {

struct MethodFacts {
  Method method;
  std::string_view name;  // in files, verbs and tables, and of its shader: method_NAME.glsl
  const char* label;      // in the panels
  bool drawn;             // by the renderer, for the window and `render`
  bool threads;           // one by one, so that it needs them and shows what is between them
};

/// By value of the enum.
inline constexpr std::array<MethodFacts, 10> kMethods{{
    {Method::kAuto, "auto", "automatic", true, false},
    {Method::kFlat, "flat", "flat", true, false},
    {Method::kVrst03, "vrst03", "vrst03", true, false},
    {Method::kIrawan, "irawan", "irawan", true, true},
    {Method::kCloth, "cloth", "cloth", true, false},
    {Method::kRepeat, "repeat", "repeat", true, false},
    {Method::kCell, "cell", "cell", true, false},
    {Method::kYarn, "yarn", "yarn", true, true},
    {Method::kEngine, "engine", "engine", true, false},
    {Method::kReference, "reference", "reference", false, false},
}};

/// Those that `auto` chooses among, fine to coarse.
inline constexpr std::array kShadedMethods{Method::kYarn, Method::kCell, Method::kRepeat, Method::kCloth};

constexpr const MethodFacts& method_facts(Method method) { return kMethods[static_cast<size_t>(method)]; }
constexpr std::string_view method_name(Method method) { return method_facts(method).name; }
constexpr std::optional<Method> method_from_name(std::string_view name) {
  for (const MethodFacts& m : kMethods)
    if (m.name == name) return m.method;
  return std::nullopt;
}

static_assert([] {
  for (size_t i = 0; i < kMethods.size(); ++i)
    if (kMethods[i].method != static_cast<Method>(i)) return false;
  return true;
}());

}  // namespace weftlight::draft
