#pragma once
// Grids, tables and maps as arrays of NumPy. What is given out is a copy, or a view of a value that nobody changes and
// that cannot be written; what is taken in is copied.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <vector>

#include "cloth/maps.h"
#include "draft/bit_matrix.h"

namespace weftlight::python {

namespace py = pybind11;

/// What an argument of cells, numbers or indices is converted to: lists and arrays of other types will do.
using Cells = py::array_t<bool, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<int, py::array::c_style | py::array::forcecast>;
using Numbers = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// Shape (rows, cols).
py::array_t<bool> array_of(const draft::BitMatrix& matrix);
/// Throws ValueError unless the array has two dimensions, within the limits of a draft.
draft::BitMatrix matrix_of(const Cells& cells, const char* name);

/// Shape (n,).
template <class T>
py::array_t<T> array_of(const std::vector<T>& values) {
  return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}
/// Integers alone: an array of other numbers is a TypeError.
std::vector<int> indices_of(const py::handle& value, const char* name);

/// A read-only view of `data` with these shape and strides in elements of T, which keeps `owner` alive.
template <class T>
py::array view_of(const T* data, std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides,
                  const py::object& owner) {
  for (py::ssize_t& stride : strides) stride *= static_cast<py::ssize_t>(sizeof(T));
  py::array view(py::dtype::of<T>(), std::move(shape), std::move(strides), data, owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}
/// (height, width) of a plane of numbers, (height, width, channels) of one of structs of `Channel`s.
template <class Channel, class T>
py::array view_of(const cloth::Plane<T>& plane, const py::object& owner) {
  static_assert(sizeof(T) % sizeof(Channel) == 0);
  constexpr py::ssize_t kChannels = sizeof(T) / sizeof(Channel);
  const py::ssize_t width = plane.width, height = plane.height;
  const auto* data = reinterpret_cast<const Channel*>(plane.at_.data());
  if constexpr (kChannels == 1) return view_of(data, {height, width}, {width, 1}, owner);
  else return view_of(data, {height, width, kChannels}, {width * kChannels, kChannels, 1}, owner);
}

}  // namespace weftlight::python
