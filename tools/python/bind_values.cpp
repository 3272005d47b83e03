// The small values of a design: yarns, finish, plan of the cloth, look, scene, loom, and the tables of its threads.

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "design/cloth_plan.h"
#include "design/dye.h"
#include "design/fibre.h"
#include "design/finish.h"
#include "design/lights.h"
#include "design/yarn_presets.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/values.h"

namespace weftlight::python {

using design::ClothPlan, design::Dye, design::DyedStretch, design::Finish, design::Lobes, design::Look, design::Loom,
    design::Reed, design::Scene, design::Yarn, design::YarnField, design::YarnPurchase, design::clamped,
    design::kFinishFields, design::kLobeFields, design::kYarnFields;
using design::kMaxLoomDents;
using draft::Threads, draft::kFromYarn, draft::kMaxShafts, draft::kMaxThreads;

namespace {

template <class T, size_t N>
void check_fields(const char* name, const T& value, const std::array<YarnField<T>, N>& fields) {
  for (const YarnField<T>& field : fields) {
    const float is = value.*field.member;
    if (!(is >= field.facts.low && is <= field.facts.high))
      bad_value(fmt::format("{}: {} is out of range: {} to {} {}", name, is, field.facts.low, field.facts.high,
                            field.facts.unit) +
                fmt::format(" ({})", field.facts.label));
  }
}

void check_lobes(const Lobes& lobes) {
  check_fields("Lobes", lobes, kLobeFields);
  if (!(clamped(lobes) == lobes)) bad_value("Lobes: a parameter is out of range");
}

void check_yarn(const Yarn& yarn) {
  check_fields("Yarn", yarn, kYarnFields);
  check_lobes(yarn.lobes);
  if (!(design::clamped(yarn.dye) == yarn.dye)) bad_value("Yarn: its dye is out of range");
  if (!(clamped(yarn) == yarn)) bad_value("Yarn: plies are 1 to 8");
}

void check_dye(const Dye& dye) {
  if (!(design::clamped(dye) == dye))
    bad_value(
        fmt::format("Dye: up to {} stretches of 1 to {} threads in colours of 8 bits, shift -{} to {}, scatter 0 to {}",
                    design::kMaxDyedStretches, design::kMaxDyedThreads, design::kMaxDyedThreads,
                    design::kMaxDyedThreads, design::kMaxDyedThreads));
}

void check_finish(const Finish& finish) { check_fields("Finish", finish, kFinishFields); }

/// Every number within its limits.
void check_plan(const ClothPlan& plan) {
  if (design::clamped(plan) != plan)
    bad_value("ClothPlan: a number is out of range, a sleying has no end, or a yarn is bought twice");
}

void check_finite(const char* name, std::initializer_list<float> numbers) {
  for (const float number : numbers)
    if (!std::isfinite(number)) bad_value(fmt::format("{}: a number is not finite", name));
}

void check_look(const Look& look) { check_finite("Look", {look.tolerance, look.exposure_ev}); }

void check_scene(const Scene& s) {
  check_finite("Scene", {s.view_azimuth, s.view_elevation, s.view_distance, s.pan_x, s.pan_y, s.light_azimuth,
                         s.light_elevation, s.light_strength, s.sky_strength});
}

void check_loom(const Loom& loom) {
  const auto within = [](int number, int most) { return number >= 0 && number <= most; };
  if (!within(loom.shafts, kMaxShafts) || !within(loom.treadles, kMaxShafts) || !within(loom.next_pick, kMaxThreads) ||
      !within(loom.next_end, kMaxThreads) || !within(loom.next_dent, kMaxLoomDents))
    bad_value(fmt::format("Loom: shafts and treadles are 0 to {}, next_pick and next_end 0 to {}, next_dent 0 to {}",
                          kMaxShafts, kMaxThreads, kMaxLoomDents));
}

void bind_yarns(py::module_& module) {
  ValueClass<Lobes>(module, "Lobes", "How a yarn reflects and transmits light (docs/yarns.md).", check_lobes)
      .field("specular", &Lobes::specular)
      .field("specular_tint", &Lobes::specular_tint)
      .field("ior", &Lobes::ior)
      .field("along_width", &Lobes::along_width)
      .field("across_width", &Lobes::across_width)
      .field("layers", &Lobes::layers)
      .field("inner", &Lobes::inner)
      .field("inner_depth", &Lobes::inner_depth)
      .field("body", &Lobes::body)
      .field("fuzz", &Lobes::fuzz)
      .field("fuzz_width", &Lobes::fuzz_width)
      .field("transmission", &Lobes::transmission)
      .field("metallic", &Lobes::metallic)
      .finish();
  ValueClass<DyedStretch>(module, "DyedStretch", "A stretch of a thread in one colour.")
      .field("threads", &DyedStretch::threads)
      .field("color", &DyedStretch::color)
      .field("fades", &DyedStretch::fades)
      .finish();
  ValueClass<Dye>(module, "Dye", "Colours along a thread, which repeat (docs/yarns.md).", check_dye)
      .field("stretches", &Dye::stretches)
      .field("shift", &Dye::shift)
      .field("scatter", &Dye::scatter)
      .finish();
  ValueClass<Yarn>(module, "Yarn", "A yarn: its construction and its lobes (docs/yarns.md).", check_yarn)
      .field("name", &Yarn::name)
      .field("diameter_mm", &Yarn::diameter_mm)
      .field("twist", &Yarn::twist)
      .field("turns_per_m", &Yarn::turns_per_m)
      .field("plies", &Yarn::plies)
      .field("fibre_um", &Yarn::fibre_um)
      .field("groove_depth", &Yarn::groove_depth)
      .field("hairiness", &Yarn::hairiness)
      .field("flattening", &Yarn::flattening)
      .field("irregularity", &Yarn::irregularity)
      .field("unevenness", &Yarn::unevenness)
      .field("melange", &Yarn::melange)
      .field("lobes", &Yarn::lobes)
      .field("tex", &Yarn::tex)
      .field("dye", &Yarn::dye)
      .finish();
  module.def(
      "yarn_presets",
      [] {
        const auto all = design::ready_yarns();
        return std::vector<Yarn>(all.begin(), all.end());
      },
      "The yarns that come with the program, by fibre, cotton first.");
  module.def(
      "tex_of", [](const Yarn& yarn) { return design::tex_of(yarn); }, py::arg("yarn"), "The count of a yarn, g/km.");
}

void bind_plan(py::module_& module) {
  ValueClass<Reed>(module, "Reed", "A reed by the number on its end.")
      .field("dents", &Reed::dents)
      .field("per_inch", &Reed::per_inch)
      .finish();
  ValueClass<YarnPurchase>(module, "YarnPurchase", "How a yarn of that name is bought.")
      .field("yarn", &YarnPurchase::yarn)
      .field("cone_g", &YarnPurchase::cone_g)
      .field("cone_m", &YarnPurchase::cone_m)
      .field("price", &YarnPurchase::price)
      .finish();
  ValueClass<ClothPlan>(module, "ClothPlan", "How large the cloth shall be, and how it goes onto the loom.", check_plan)
      .field("width_mm", &ClothPlan::width_mm)
      .field("length_mm", &ClothPlan::length_mm)
      .field("pieces", &ClothPlan::pieces)
      .field("fringe_mm", &ClothPlan::fringe_mm)
      .field("loom_waste_mm", &ClothPlan::loom_waste_mm)
      .field("warp_take_up", &ClothPlan::warp_take_up)
      .field("weft_take_up", &ClothPlan::weft_take_up)
      .field("warp_shrinkage", &ClothPlan::warp_shrinkage)
      .field("weft_shrinkage", &ClothPlan::weft_shrinkage)
      .field("spare", &ClothPlan::spare)
      .field("ends_per_cm", &ClothPlan::ends_per_cm)
      .field("picks_per_cm", &ClothPlan::picks_per_cm)
      .field("reed", &ClothPlan::reed)
      .field("sleying", &ClothPlan::sleying)
      .field("floating_selvedges", &ClothPlan::floating_selvedges)
      .field("bout_mm", &ClothPlan::bout_mm)
      .field("raddle_mm", &ClothPlan::raddle_mm)
      .field("purchases", &ClothPlan::purchases)
      .finish();
}

void bind_scene(py::module_& module) {
  ValueClass<Finish>(module, "Finish", "Degrees of finishing, each 0 to 1.", check_finish)
      .field("washed", &Finish::washed)
      .field("raised", &Finish::raised)
      .field("mercerised", &Finish::mercerised)
      .field("calendered", &Finish::calendered)
      .finish();
  ValueClass<Look>(module, "Look", "Shading method and exposure.", check_look)
      .field("method", &Look::method)
      .field("tolerance", &Look::tolerance)
      .field("exposure_ev", &Look::exposure_ev)
      .field("automatic_exposure", &Look::automatic_exposure)
      .finish();
  ValueClass<Scene>(module, "Scene", "Mesh, camera and light. Angles in degrees.", check_scene)
      .field("mesh", &Scene::mesh)
      .field("simulated_drape", &Scene::simulated_drape)
      .field("view_azimuth", &Scene::view_azimuth)
      .field("view_elevation", &Scene::view_elevation)
      .field("view_distance", &Scene::view_distance)
      .field("pan_x", &Scene::pan_x)
      .field("pan_y", &Scene::pan_y)
      .field("light_azimuth", &Scene::light_azimuth)
      .field("light_elevation", &Scene::light_elevation)
      .field("light_strength", &Scene::light_strength)
      .field("sky_strength", &Scene::sky_strength)
      .field("background", &Scene::background)
      .field("lights", &Scene::lights)
      .field("surroundings", &Scene::surroundings)
      .finish();
  ValueClass<Loom>(module, "Loom", "What leads, and the limits of the loom.", check_loom)
      .field("leading", &Loom::leading)
      .field("locked", &Loom::locked)
      .field("shafts", &Loom::shafts)
      .field("treadles", &Loom::treadles)
      .field("next_pick", &Loom::next_pick)
      .field("next_end", &Loom::next_end)
      .field("next_dent", &Loom::next_dent)
      .field("tabby_between", &Loom::tabby_between)
      .field("at_tabby", &Loom::at_tabby)
      .field("second_tabby", &Loom::second_tabby)
      .finish();
}

/// Lengths in mm; NaN where core has kFromYarn.
py::array_t<float> lengths_of(const std::vector<float>& mm) {
  py::array_t<float> out = array_of(mm);
  for (py::ssize_t i = 0; i < out.size(); ++i)
    if (out.data()[i] == kFromYarn) out.mutable_data()[i] = std::numeric_limits<float>::quiet_NaN();
  return out;
}

std::vector<float> read_lengths(const py::object& value, int size, const char* name) {
  if (value.is_none()) return std::vector<float>(static_cast<size_t>(size), kFromYarn);
  const Numbers array = Numbers::ensure(value);
  if (!array) throw py::error_already_set();
  if (array.ndim() > 1 || (array.ndim() == 1 && array.size() != size))
    bad_value(fmt::format("{} has {} numbers, and there are {} threads", name, array.size(), size));
  std::vector<float> out;
  for (int i = 0; i < size; ++i) {
    const float mm = array.data()[array.ndim() == 0 ? 0 : i];
    if (!std::isnan(mm) && !(mm >= 0 && std::isfinite(mm)))
      bad_value(fmt::format("{}: {} mm is no length; nan lets it follow from the yarn", name, mm));
    out.push_back(std::isnan(mm) ? kFromYarn : mm);
  }
  return out;
}

std::vector<int> read_indices(const py::object& value, int size, const char* name) {
  std::vector<int> out = py::isinstance<py::int_>(value)
                             ? std::vector<int>(static_cast<size_t>(size), value.cast<int>())
                             : indices_of(value, name);
  if (static_cast<int>(out.size()) != size)
    bad_value(fmt::format("{} has {} numbers, and there are {} threads", name, out.size(), size));
  return out;
}

Threads make_threads(const py::object& color, const py::object& yarn, const py::object& spacing_mm,
                     const py::object& thickness_mm) {
  Threads threads;
  threads.color = indices_of(color, "color");
  const int size = threads.size();
  if (size < 1 || size > kMaxThreads) bad_value(fmt::format("there are 1 to {} threads", kMaxThreads));
  threads.yarn = read_indices(yarn, size, "yarn");
  threads.spacing_mm = read_lengths(spacing_mm, size, "spacing_mm");
  threads.thickness_mm = read_lengths(thickness_mm, size, "thickness_mm");
  return threads;
}

py::object equal(const Threads& threads, const py::object& other) {
  if (!py::isinstance<Threads>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
  return py::bool_(threads == other.cast<const Threads&>());
}

void bind_threads(py::module_& module) {
  py::class_<Threads>(module, "Threads", "The ends or the picks: colour, yarn, spacing and thickness of each.")
      .def(py::init(&make_threads), py::arg("color"), py::kw_only(), py::arg("yarn") = 0,
           py::arg("spacing_mm") = py::none(), py::arg("thickness_mm") = py::none())
      .def_property_readonly("color", [](const Threads& t) { return array_of(t.color); })
      .def_property_readonly("yarn", [](const Threads& t) { return array_of(t.yarn); })
      .def_property_readonly("spacing_mm", [](const Threads& t) { return lengths_of(t.spacing_mm); })
      .def_property_readonly("thickness_mm", [](const Threads& t) { return lengths_of(t.thickness_mm); })
      .def(
          "replace",
          [](const py::object& self, const py::kwargs& changes) {
            py::dict fields;
            for (const char* name : {"color", "yarn", "spacing_mm", "thickness_mm"}) fields[name] = self.attr(name);
            fields.attr("update")(changes);
            return py::type::of(self)(**fields);
          },
          "New threads with other fields.")
      .def("__len__", &Threads::size)
      .def("__eq__", &equal)
      .def("__repr__", [](const Threads& t) { return fmt::format("<weftlight.Threads: {}>", t.size()); })
      .def(py::pickle([](const Threads& t) { return py::make_tuple(t.color, t.yarn, t.spacing_mm, t.thickness_mm); },
                      [](const py::tuple& state) {
                        Threads t;
                        t.color = state[0].cast<std::vector<int>>(), t.yarn = state[1].cast<std::vector<int>>();
                        t.spacing_mm = state[2].cast<std::vector<float>>(),
                        t.thickness_mm = state[3].cast<std::vector<float>>();
                        const size_t size = t.color.size();
                        if (t.yarn.size() != size || t.spacing_mm.size() != size || t.thickness_mm.size() != size)
                          bad_value("these are no threads");
                        return t;
                      }));
}

}  // namespace

void bind_values(py::module_& module) {
  bind_yarns(module);
  bind_plan(module);
  bind_scene(module);
  bind_threads(module);
  std::vector<std::string> lights, methods;
  for (const auto& preset : design::kLightingPresets) lights.emplace_back(preset.id);
  for (const auto& method : design::kMethods) methods.emplace_back(method.name);
  module.attr("LIGHTS") = py::tuple(py::cast(lights));
  module.attr("METHODS") = py::tuple(py::cast(methods));
}

}  // namespace weftlight::python
