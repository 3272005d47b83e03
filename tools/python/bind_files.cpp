// Drafts in files and in bytes. An opened draft keeps its bytes, so that it is written as it was read.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

#include "base/whole_files.h"
#include "files/picture_draft.h"
#include "python/bindings.h"
#include "python/long_call.h"
#include "wif/other_formats.h"
#include "wif/wif.h"

namespace weftlight::python {

using base::Error, base::read_file, base::write_file_atomically;
using design::Design;
using files::is_picture, files::read_picture_draft;
using wif::Diagnostic, wif::Severity, wif::WifFile, wif::WifRead, wif::kMaxDraftBytes, wif::read_draft,
    wif::write_new_wif, wif::write_plain_wif, wif::write_wif;

namespace {

namespace fs = std::filesystem;

/// A draft as it was read.
struct DraftFile {
  WifFile file;
  std::vector<Diagnostic> diagnostics;
};

/// Throws the error, about the file of that name.
DraftFile opened(WifRead read, const std::string& name) {
  if (!read.file) {
    Error error = read.file.error();
    if (error.file.empty()) error.file = name;
    throw Failed(std::move(error));
  }
  return {std::move(*read.file), std::move(read.diagnostics)};
}

DraftFile read_path(const fs::path& path) {
  return unlocked([name = path.string()] {
    if (is_picture(name)) return opened(read_picture_draft(name), name);
    return opened(read_draft(value_of(read_file(name, kMaxDraftBytes))), name);
  });
}

DraftFile read_bytes(const py::bytes& data, const std::string& name) {
  const auto bytes = static_cast<std::string_view>(data);  // they stay as they are while `data` is held
  return unlocked([&] { return opened(read_draft(bytes), name); });
}

py::bytes written(const DraftFile& opened, const Design* design) {
  return unlocked([&] { return write_wif(opened.file, design != nullptr ? *design : opened.file.design); });
}

void write_path(const DraftFile& opened, const fs::path& path, const Design* design) {
  unlocked([&] {
    value_of(
        write_file_atomically(path.string(), write_wif(opened.file, design != nullptr ? *design : opened.file.design)));
  });
}

std::string new_file(const Design& design, bool plain) {
  return plain ? write_plain_wif(design) : write_new_wif(design);
}

const char* severity_name(Severity severity) {
  constexpr const char* kNames[] = {"note", "warning", "error"};
  return kNames[static_cast<size_t>(severity)];
}

void bind_diagnostic(py::module_& module) {
  py::class_<Diagnostic>(module, "Diagnostic", "What was read with a remark.")
      .def_property_readonly("severity", [](const Diagnostic& d) { return severity_name(d.severity); })
      .def_property_readonly(
          "line",
          [](const Diagnostic& d) { return d.line > 0 ? py::object(py::int_(d.line)) : py::object(py::none()); })
      .def_readonly("text", &Diagnostic::text)
      .def_readonly("remedy", &Diagnostic::remedy)
      .def("__repr__", [](const Diagnostic& d) {
        return std::string("<weftlight.Diagnostic ")
            .append(severity_name(d.severity))
            .append(d.line > 0 ? std::string(" in line ").append(std::to_string(d.line)) : std::string())
            .append(": ")
            .append(d.text)
            .append(">");
      });
}

void bind_draft_file(py::module_& module) {
  const auto of_file = [](auto member) { return [member](const DraftFile& opened) { return opened.file.*member; }; };
  py::class_<DraftFile>(module, "DraftFile", "A draft as it was read: its design, its bytes, and what was remarkable.")
      .def_property_readonly("design", of_file(&WifFile::design))
      .def_property_readonly("diagnostics",
                             [](const DraftFile& opened) { return py::tuple(py::cast(opened.diagnostics)); })
      .def_property_readonly("format", of_file(&WifFile::format))
      .def_property_readonly("source_program", of_file(&WifFile::source_program))
      .def_property_readonly("source_version", of_file(&WifFile::source_version))
      .def_property_readonly("version", of_file(&WifFile::version))
      .def_property_readonly("date", of_file(&WifFile::date))
      .def("to_bytes", &written, py::arg("design") = py::none(), "The bytes of the file, edited or not.")
      .def("write", &write_path, py::arg("path"), py::arg("design") = py::none(), "The same into a file.")
      .def("__repr__", [](const DraftFile& opened) {
        return std::string("<weftlight.DraftFile of ")
            .append(opened.file.format)
            .append(", ")
            .append(std::to_string(opened.diagnostics.size()))
            .append(" remarks>");
      });
}

}  // namespace

void bind_files(py::module_& module, py::class_<Design>& design) {
  bind_diagnostic(module);
  bind_draft_file(module);
  module.def("read", &read_path, py::arg("path"), "Reads a draft: .wif, .dtx, .wpo, or a picture.");
  module.def("read_bytes", &read_bytes, py::arg("data"), py::arg("name") = "", "Reads the bytes of a draft.");
  design.def(
      "to_wif", [](const Design& d, bool plain) -> py::bytes { return unlocked([&] { return new_file(d, plain); }); },
      py::arg("plain") = false, "The bytes of a new WIF.");
  design.def(
      "write",
      [](const Design& d, const fs::path& path, bool plain) {
        unlocked([&] { value_of(write_file_atomically(path.string(), new_file(d, plain))); });
      },
      py::arg("path"), py::arg("plain") = false, "A new WIF.");
}

}  // namespace weftlight::python
