#pragma once
// Small structs of core as values of Python: made by keywords, read by attributes, changed by replace() into new ones,
// compared, shown and pickled by the same table of fields.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "python/errors.h"
#include "python/texts.h"

namespace weftlight::python {

/// As repr() shows it.
inline std::string shown(const py::handle& value) { return py::cast<std::string>(py::repr(value)); }

/// The class for T. `check` throws where the fields of a value do not fit.
template <class T>
class ValueClass {
 public:
  using Check = void (*)(const T&);
  ValueClass(py::module_& module, const char* name, const char* doc, Check check = nullptr)
      : class_(module, name, doc), fields_(std::make_shared<Fields>(Fields{name, check, {}})) {}

  template <class Member>
  ValueClass& field(const char* name, Member T::*member) {
    class_.def_property_readonly(name, [member](const T& value) { return value.*member; });
    fields_->list.push_back({name, [member](T& value, const py::handle& to) { value.*member = py::cast<Member>(to); }});
    return *this;
  }

  /// After all fields.
  void finish() {
    const std::shared_ptr<const Fields> fields = fields_;
    class_.def(py::init([fields](const py::kwargs& given) { return changed(*fields, T{}, given); }));
    class_.def("replace", [fields](const T& value, const py::kwargs& given) { return changed(*fields, value, given); });
    class_.def("__eq__", [](const T& value, const py::object& other) -> py::object {
      if (!py::isinstance<T>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
      return py::bool_(value == py::cast<const T&>(other));
    });
    class_.def("__repr__", [fields](const py::object& self) {
      std::string text = fields->name;
      for (size_t i = 0; i < fields->list.size(); ++i)
        text.append(i == 0 ? "(" : ", ")
            .append(fields->list[i].name)
            .append("=")
            .append(shown(self.attr(fields->list[i].name)));
      return text.append(")");
    });
    class_.def(py::pickle(
        [fields](const T& value) {
          const py::object self = py::cast(value);
          py::dict state;
          for (const Field& field : fields->list) state[field.name] = self.attr(field.name);
          return state;
        },
        [fields](const py::dict& state) { return changed(*fields, T{}, py::reinterpret_borrow<py::kwargs>(state)); }));
  }

 private:
  struct Field {
    const char* name;
    std::function<void(T&, const py::handle&)> set;
  };
  struct Fields {
    const char* name;
    Check check;
    std::vector<Field> list;
  };

  static T changed(const Fields& fields, T value, const py::kwargs& given) {
    for (const auto& [key, to] : given) {
      const auto name = py::cast<std::string>(key);
      const auto same = [&name](const Field& field) { return name == field.name; };
      const auto field = std::find_if(fields.list.begin(), fields.list.end(), same);
      if (field == fields.list.end())
        throw py::type_error(std::string(fields.name).append(" has no field '").append(name).append("'"));
      try {
        field->set(value, to);
      } catch (const py::cast_error&) {
        throw py::type_error(std::string(fields.name).append(".").append(name).append(" cannot be ").append(shown(to)));
      }
    }
    if (fields.check != nullptr) fields.check(value);
    return value;
  }

  py::class_<T> class_;
  std::shared_ptr<Fields> fields_;
};

}  // namespace weftlight::python
