#pragma once
// The parts of the module, in the order in which they are bound: each uses the classes of those before it.

#include <pybind11/pybind11.h>

namespace weftlight::design {
struct Design;
}

namespace weftlight::python {

namespace py = pybind11;

/// Threads, yarns, finish, look, scene, loom.
void bind_values(py::module_& module);
/// The Design: its grids and tables as arrays, what is computed of them, replace().
py::class_<design::Design> bind_design(py::module_& module);
/// Its edits as methods.
void bind_edits(py::class_<design::Design>& design);
/// Its analysis as methods, and the comparison of two.
void bind_analysis(py::module_& module, py::class_<design::Design>& design);
/// Drafts in files and in bytes.
void bind_files(py::module_& module, py::class_<design::Design>& design);
/// Weaves by name.
void bind_weaves(py::module_& module, py::class_<design::Design>& design);
/// One period of the cloth as arrays, and what it sends back of light.
void bind_cloth(py::module_& module, py::class_<design::Design>& design);
/// Pictures: drawn by OpenGL, ray traced, and written to files.
void bind_pictures(py::module_& module);
/// Texture sets for engines.
void bind_export(py::module_& module);

}  // namespace weftlight::python
