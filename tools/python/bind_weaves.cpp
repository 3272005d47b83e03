// Weaves by name, from the table of core/weaves.

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <charconv>

#include "python/bindings.h"
#include "python/long_call.h"
#include "weaves/table.h"

namespace weftlight::python {

using design::Design, design::WeaveUse;
using draft::kMaxCells, draft::kMaxThreads;
using weaves::GeneratedWeave, weaves::ParameterKind, weaves::WeaveKind, weaves::WeaveParameter, weaves::WeaveValues,
    weaves::check_values, weaves::find_weave, weaves::new_draft, weaves::weave_kinds;

namespace {

const WeaveKind& kind_named(const std::string& name) {
  if (const WeaveKind* kind = find_weave(name)) return *kind;
  std::string names;
  for (const WeaveKind& kind : weave_kinds()) names.append(names.empty() ? "" : ", ").append(kind.id);
  bad_value(fmt::format("no weave is called '{}'; the weaves are {}", name, names));
}

const WeaveParameter& parameter_named(const WeaveKind& kind, const std::string& name) {
  std::string names;
  for (const WeaveParameter& parameter : kind.parameters) {
    if (name == parameter.id) return parameter;
    names.append(names.empty() ? "" : ", ").append(parameter.id);
  }
  throw py::type_error(fmt::format("the weave {} has no parameter '{}'; its parameters are {}", kind.id, name,
                                   names.empty() ? "none" : names));
}

/// Core clamps a count to its range, as a slider does.
void check_parameter(const WeaveParameter& p, const std::string& value) {
  if (p.kind == ParameterKind::kCount) {
    int count = 0;
    const auto read = std::from_chars(value.data(), value.data() + value.size(), count);
    if (read.ec != std::errc() || read.ptr != value.data() + value.size() || count < p.low || count > p.high)
      bad_value(fmt::format("{} is a whole number of {} to {}, not {}", p.id, p.low, p.high, value));
  }
  const auto is = [&value](const char* choice) { return value == choice; };
  if (p.kind == ParameterKind::kChoice && std::ranges::none_of(p.choices, is))
    bad_value(fmt::format("{} is one of {}, not '{}'", p.id, fmt::join(p.choices, ", "), value));
}

WeaveValues values_of(const WeaveKind& kind, const py::kwargs& given) {
  WeaveValues values;
  for (const auto& [key, to] : given) {
    const auto name = key.cast<std::string>();
    const std::string value = py::str(to);
    check_parameter(parameter_named(kind, name), value);
    values.emplace_back(name, value);
  }
  std::ranges::sort(values);
  if (const auto made = check_values(kind, values); !made) bad_value(base::problem_of(made));
  return values;
}

void warn(const std::string& note) {
  if (!note.empty() && PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 2) != 0) throw py::error_already_set();
}

Design woven(const std::string& name, std::pair<int, int> size, const py::kwargs& parameters) {
  const auto [ends, picks] = size;
  const WeaveKind& kind = kind_named(name);
  const WeaveValues values = values_of(kind, parameters);
  if (ends < 1 || picks < 1 || ends > kMaxThreads || picks > kMaxThreads || int64_t{ends} * picks > kMaxCells)
    bad_value(fmt::format("a draft of {} ends and {} picks is beyond the limits", ends, picks));
  GeneratedWeave made = unlocked([&] { return new_draft(kind, values, {size.first, size.second}); });
  made.design.title = kind.name;
  warn(made.note);
  return std::move(made.design);
}

/// [first, end) of `count` threads; end None: to the last.
int count_from(int first, std::optional<int> end, int count, const char* what) {
  check_index(what, first, count);
  check_index(what, end.value_or(count) - 1, count);
  if (end.value_or(count) <= first) bad_value("the range of threads is empty");
  return end.value_or(count) - first;
}

Design with_weave(const Design& design, const std::string& name, int first_end, std::optional<int> end, int first_pick,
                  std::optional<int> pick, const py::kwargs& parameters) {
  WeaveUse use{name, values_of(kind_named(name), parameters), first_end, 0, first_pick, 0};
  use.ends = count_from(first_end, end, design.draft.ends(), "end");
  use.picks = count_from(first_pick, pick, design.draft.picks(), "pick");
  GeneratedWeave made = value_of(unlocked([&] { return weaves::with_weave(design, use); }));
  warn(made.note);
  return std::move(made.design);
}

const char* parameter_kind(const WeaveParameter& p) {
  constexpr const char* kNames[] = {"count", "choice", "text"};
  return kNames[static_cast<size_t>(p.kind)];
}

void bind_tables(py::module_& module) {
  py::class_<WeaveParameter>(module, "WeaveParameter", "A parameter of a weave.")
      .def_readonly("id", &WeaveParameter::id)
      .def_readonly("label", &WeaveParameter::label)
      .def_readonly("tip", &WeaveParameter::tip)
      .def_property_readonly("kind", &parameter_kind)
      .def_readonly("default", &WeaveParameter::default_value)
      .def_readonly("low", &WeaveParameter::low)
      .def_readonly("high", &WeaveParameter::high)
      .def_property_readonly("choices", [](const WeaveParameter& p) { return py::tuple(py::cast(p.choices)); });
  py::class_<WeaveKind>(module, "WeaveKind", "A weave of the table.")
      .def_readonly("id", &WeaveKind::id)
      .def_readonly("name", &WeaveKind::name)
      .def_readonly("family", &WeaveKind::family)
      .def_readonly("description", &WeaveKind::description)
      .def_property_readonly("parameters", [](const WeaveKind& k) { return py::tuple(py::cast(k.parameters)); })
      .def("__repr__", [](const WeaveKind& k) { return fmt::format("<weftlight.WeaveKind '{}'>", k.id); });
}

}  // namespace

void bind_weaves(py::module_& module, py::class_<Design>& design) {
  bind_tables(module);
  module.def(
      "weaves",
      [] {
        const auto kinds = weave_kinds();
        return std::vector<WeaveKind>(kinds.begin(), kinds.end());
      },
      "Every weave that weave() makes.");
  module.def("weave", &woven, py::arg("name"), py::arg("size") = std::pair(64, 64),
             "A new draft of a weave, by its id and its parameters.");
  design.def("with_weave", &with_weave, py::arg("name"), py::arg("first_end") = 0, py::arg("end") = py::none(),
             py::arg("first_pick") = 0, py::arg("pick") = py::none(), "A weave over the draft or a part of it.");
}

}  // namespace weftlight::python
