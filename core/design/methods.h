#pragma once
// The table of shading methods: their names in files, commands and panels, and which of them are levels of detail that
// `auto` chooses among. How to add one: shaders/README.md.

#include <array>
#include <optional>
#include <string_view>

#include "base/mark.h"
#include "design/design.h"

namespace weftlight::design {

struct MethodFacts {
  Method method;
  std::string_view name;  // in files, commands and tables; its shader is method_NAME.glsl
  const char* label;      // in panels; show tr(label)
  bool drawn;             // by the OpenGL renderer, for the window and `render`
  bool threads;           // draws single threads, with the gaps between them
};

/// By value of the enum.
inline constexpr std::array<MethodFacts, 10> kMethods{{
    {Method::kAuto, "auto", base::mark("automatic"), true, false},
    {Method::kFlat, "flat", base::mark("flat"), true, false},
    {Method::kVrst03, "vrst03", base::mark("vrst03"), true, false},
    {Method::kIrawan, "irawan", base::mark("irawan"), true, true},
    {Method::kCloth, "cloth", base::mark("cloth"), true, false},
    {Method::kRepeat, "repeat", base::mark("repeat"), true, false},
    {Method::kCell, "cell", base::mark("cell"), true, false},
    {Method::kYarn, "yarn", base::mark("yarn"), true, true},
    {Method::kEngine, "engine", base::mark("engine"), true, false},
    {Method::kReference, "reference", base::mark("reference"), false, false},
}};

/// The levels of detail of `auto`, fine to coarse.
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

}  // namespace weftlight::design
