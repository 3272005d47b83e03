#include "python/arrays.h"

#include <fmt/format.h>

#include "draft/draft.h"
#include "python/errors.h"

namespace weftlight::python {

using draft::BitMatrix, draft::for_each_bit, draft::kMaxCells, draft::kMaxThreads;

py::array_t<bool> array_of(const BitMatrix& matrix) {
  py::array_t<bool> cells({matrix.rows(), matrix.cols()});
  bool* const data = cells.mutable_data();
  std::fill(data, data + cells.size(), false);
  for (int row = 0; row < matrix.rows(); ++row) {
    bool* const line = data + static_cast<py::ssize_t>(row) * matrix.cols();
    for_each_bit(matrix.row(row), [line](int col) { line[col] = true; });
  }
  return cells;
}

BitMatrix matrix_of(const Cells& cells, const char* name) {
  if (cells.ndim() != 2)
    bad_value(fmt::format("{} has two dimensions, rows and columns; this has {}", name, cells.ndim()));
  const py::ssize_t rows = cells.shape(0), cols = cells.shape(1);
  if (rows < 1 || cols < 1 || rows > kMaxThreads || cols > kMaxThreads || rows * cols > kMaxCells)
    bad_value(fmt::format("{} of {} x {}: each side is 1 to {}, and there are at most {} cells", name, rows, cols,
                          kMaxThreads, kMaxCells));
  BitMatrix matrix(static_cast<int>(rows), static_cast<int>(cols));
  const bool* at = cells.data();
  for (int row = 0; row < matrix.rows(); ++row)
    for (int col = 0; col < matrix.cols(); ++col)
      if (*at++) matrix.set(row, col, true);
  return matrix;
}

std::vector<int> indices_of(const py::handle& value, const char* name) {
  const auto array = py::array::ensure(value);
  if (!array) throw py::error_already_set();
  const char kind = array.dtype().kind();
  if (array.size() > 0 && kind != 'i' && kind != 'u') throw py::type_error(fmt::format("{} are whole numbers", name));
  if (array.ndim() != 1) bad_value(fmt::format("{} have one dimension; this has {}", name, array.ndim()));
  const auto wide = py::array_t<int64_t, py::array::c_style | py::array::forcecast>::ensure(array);
  std::vector<int> indices;
  indices.reserve(static_cast<size_t>(wide.size()));
  for (py::ssize_t i = 0; i < wide.size(); ++i) {
    const int64_t index = wide.data()[i];
    if (index < 0 || index > INT32_MAX) throw py::index_error(fmt::format("{} is out of range", index));
    indices.push_back(static_cast<int>(index));
  }
  return indices;
}

}  // namespace weftlight::python
