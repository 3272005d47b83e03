#pragma once
// Long work without the interpreter's lock. The work runs on a thread of its own; the caller's thread waits, calls the
// progress callback, and looks for Ctrl+C. So a callback runs where Python code called, whichever thread of core
// reports, and what it raises ends the work and is raised by the call.

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include "base/progress.h"
#include "python/errors.h"

namespace weftlight::python {

/// Calls progress(share, sentence), unless it is None, with a share of 0..1, at last 1. Where it returns False, the
/// work is asked to stop and Cancelled is thrown; where it or a signal's handler raises, that is thrown once the work
/// ended. `work` uses nothing of Python; what it throws is thrown.
void run_long(const py::object& progress, const std::function<void(const base::TaskProgress&)>& work);

/// The same for work with a result.
template <class Work>
auto long_call(const py::object& progress, const Work& work) {
  using Value = std::invoke_result_t<const Work&, const base::TaskProgress&>;
  std::optional<Value> value;
  run_long(progress, [&](const base::TaskProgress& task) { value.emplace(work(task)); });
  return std::move(*value);
}

/// Quick work without the lock and without a thread.
template <class Work>
auto unlocked(const Work& work) {
  const py::gil_scoped_release release;
  return work();
}

}  // namespace weftlight::python
