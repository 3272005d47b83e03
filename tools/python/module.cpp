// The module `weftlight` of Python: core, and the renderer without a window. docs/python.md is its manual,
// weftlight/__init__.pyi its reference.

#include "base/version.h"
#include "design/design.h"
#include "python/bindings.h"
#include "python/errors.h"

namespace weftlight::python {
namespace {

void bind_all(py::module_& module) {
  bind_errors(module);
  bind_values(module);
  py::class_<design::Design> design = bind_design(module);
  bind_edits(design);
  bind_analysis(module, design);
  bind_files(module, design);
  bind_weaves(module, design);
  bind_cloth(module, design);
  bind_pictures(module);
  bind_export(module);
  module.attr("__version__") = base::version();
}

}  // namespace
}  // namespace weftlight::python

PYBIND11_MODULE(_weftlight, module) {
  // Users know the package alone: its name is that of all classes.
  const pybind11::object own_name = module.attr("__name__");
  module.attr("__name__") = "weftlight";
  weftlight::python::bind_all(module);
  module.attr("__name__") = own_name;
}
