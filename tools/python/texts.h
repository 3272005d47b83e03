#pragma once
// Enumerations of core as short texts in Python ('warp', 'front', 'liftplan'), and colours as three numbers or
// '#E7B24B'.

#include <pybind11/pybind11.h>

#include <array>
#include <string>
#include <string_view>

#include "cloth/cloth.h"
#include "design/methods.h"
#include "design/thread_order.h"
#include "design/yarn_fields.h"
#include "draft/drawdown.h"

namespace weftlight::python {

namespace py = pybind11;

/// The names of an enumeration, by value.
template <class E>
struct EnumNames;
template <>
struct EnumNames<draft::System> {
  static constexpr std::array<std::string_view, 2> kNames{"warp", "weft"};
};
template <>
struct EnumNames<draft::Face> {
  static constexpr std::array<std::string_view, 2> kNames{"front", "back"};
};
template <>
struct EnumNames<draft::ShedControl> {
  static constexpr std::array<std::string_view, 2> kNames{"treadling", "liftplan"};
};
template <>
struct EnumNames<design::Leading> {
  static constexpr std::array<std::string_view, 3> kNames{"threading", "liftplan", "drawdown"};
};
template <>
struct EnumNames<design::Twist> {
  static constexpr std::array<std::string_view, 3> kNames{"none", "S", "Z"};
};
template <>
struct EnumNames<cloth::Period> {
  static constexpr std::array<std::string_view, 2> kNames{"draft", "repeat"};
};
template <>
struct EnumNames<design::Method> {
  static constexpr auto kNames = [] {
    std::array<std::string_view, design::kMethods.size()> names;
    for (size_t i = 0; i < names.size(); ++i) names[i] = design::kMethods[i].name;
    return names;
  }();
};

/// Throws ValueError for a text that is no name.
template <class E>
E enum_of(std::string_view text) {
  std::string all;
  for (size_t i = 0; i < EnumNames<E>::kNames.size(); ++i) {
    if (EnumNames<E>::kNames[i] == text) return static_cast<E>(i);
    all.append(i == 0 ? "'" : ", '").append(EnumNames<E>::kNames[i]).append("'");
  }
  throw py::value_error(std::string("'").append(text).append("' is not one of ").append(all));
}
template <class E>
std::string_view enum_name(E value) {
  return EnumNames<E>::kNames[static_cast<size_t>(value)];
}

/// (r, g, b) of 0..1 or '#RRGGBB'; throws ValueError for another text and for numbers out of range.
draft::Rgb color_of(const py::handle& value);

}  // namespace weftlight::python

namespace pybind11::detail {

template <class E>
concept NamedEnum = requires {
  weftlight::python::EnumNames<E>::kNames;
};

template <NamedEnum E>
struct type_caster<E> {
  PYBIND11_TYPE_CASTER(E, const_name("str"));
  bool load(handle source, bool) {
    if (!isinstance<str>(source)) return false;
    value = weftlight::python::enum_of<E>(source.cast<std::string>());
    return true;
  }
  static handle cast(E source, return_value_policy, handle) {
    const std::string_view name = weftlight::python::enum_name(source);
    return str(name.data(), name.size()).release();
  }
};

template <>
struct type_caster<weftlight::draft::Rgb> {
  PYBIND11_TYPE_CASTER(weftlight::draft::Rgb, const_name("Tuple[float, float, float]"));
  bool load(handle source, bool) {
    if (!isinstance<str>(source) && !isinstance<sequence>(source)) return false;
    value = weftlight::python::color_of(source);
    return true;
  }
  static handle cast(const weftlight::draft::Rgb& source, return_value_policy, handle) {
    return make_tuple(source.r, source.g, source.b).release();
  }
};

}  // namespace pybind11::detail
