// What the weaver asks of a draft: floats, layers, heddles, yarn, weight and stiffness; what two drafts differ in.

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "analysis/difference.h"
#include "analysis/floats.h"
#include "analysis/handle.h"
#include "analysis/measures.h"
#include "analysis/threads.h"
#include "analysis/weave_layers.h"
#include "analysis/yarn_need.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/long_call.h"
#include "python/texts.h"

namespace weftlight::python {

using analysis::ClothHandle, analysis::ClothMeasures, analysis::Comparison, analysis::Difference, analysis::Float,
    analysis::Interlacing, analysis::LongFloats, analysis::LongestFloats, analysis::LoomUse, analysis::WeaveLayer,
    analysis::YarnNeed, analysis::YarnReport, analysis::YarnToBuy;
using design::Design;
using draft::BitMatrix, draft::Face, draft::drawdown;

namespace {

/// None for a negative cost, which is not known.
std::optional<double> known(double cost) { return cost < 0 ? std::nullopt : std::optional(cost); }

void bind_floats(py::module_& module) {
  py::class_<LongestFloats>(module, "LongestFloats", "Longest floats, in threads, on each face.")
      .def_readonly("warp_front", &LongestFloats::warp_front)
      .def_readonly("warp_back", &LongestFloats::warp_back)
      .def_readonly("weft_front", &LongestFloats::weft_front)
      .def_readonly("weft_back", &LongestFloats::weft_back);
  py::class_<Float>(module, "Float", "A thread that passes over `length` others from `first` on.")
      .def_readonly("system", &Float::system)
      .def_readonly("face", &Float::face)
      .def_readonly("thread", &Float::thread)
      .def_readonly("first", &Float::first)
      .def_readonly("length", &Float::length)
      .def("__repr__", [](const Float& f) {
        return fmt::format("<weftlight.Float of {} {}: {} long, from {}, {}>",
                           f.system == draft::System::kWarp ? "end" : "pick", f.thread, f.length, f.first,
                           f.face == Face::kFront ? "front" : "back");
      });
}

void bind_threads(py::module_& module) {
  py::class_<WeaveLayer>(module, "WeaveLayer", "Threads that cannot be separated without cutting.")
      .def_property_readonly("ends", [](const WeaveLayer& l) { return array_of(l.ends); })
      .def_property_readonly("picks", [](const WeaveLayer& l) { return array_of(l.picks); })
      .def_property_readonly("loose", &WeaveLayer::loose);
  py::class_<LoomUse>(module, "LoomUse", "Heddles, and the use of shafts and treadles.")
      .def_property_readonly("heddles", [](const LoomUse& u) { return array_of(u.heddles); })
      .def_property_readonly("lifts", [](const LoomUse& u) { return array_of(u.lifts); })
      .def_property_readonly("treadle_uses", [](const LoomUse& u) { return array_of(u.treadle_uses); })
      .def_readonly("unthreaded_ends", &LoomUse::unthreaded_ends)
      .def_readonly("ends_in_several", &LoomUse::ends_in_several)
      .def_readonly("empty_picks", &LoomUse::empty_picks)
      .def_readonly("most_treadles_per_pick", &LoomUse::most_treadles_per_pick);
  py::class_<Interlacing>(module, "Interlacing", "Interlacings per crossing, 0 to 1.")
      .def_readonly("warp", &Interlacing::warp)
      .def_readonly("weft", &Interlacing::weft);
  py::class_<ClothHandle>(module, "ClothHandle", "Weight and stiffness of the cloth.")
      .def_readonly("kg_per_m2", &ClothHandle::kg_per_m2)
      .def_readonly("bending_n_m", &ClothHandle::bending_n_m)
      .def_readonly("bending_length_mm", &ClothHandle::bending_length_mm)
      .def_readonly("thickness_mm", &ClothHandle::thickness_mm);
}

void bind_yarn_report(py::module_& module) {
  py::class_<YarnNeed>(module, "YarnNeed", "One yarn in one colour in one system.")
      .def_readonly("system", &YarnNeed::system)
      .def_readonly("yarn", &YarnNeed::yarn)
      .def_readonly("color", &YarnNeed::color)
      .def_readonly("threads", &YarnNeed::threads)
      .def_readonly("length_m", &YarnNeed::length_m)
      .def_readonly("weight_g", &YarnNeed::weight_g);
  py::class_<YarnToBuy>(module, "YarnToBuy", "One yarn in one colour, for warp and weft together.")
      .def_readonly("yarn", &YarnToBuy::yarn)
      .def_readonly("color", &YarnToBuy::color)
      .def_readonly("length_m", &YarnToBuy::length_m)
      .def_readonly("weight_g", &YarnToBuy::weight_g)
      .def_readonly("cones", &YarnToBuy::cones)
      .def_property_readonly("cost", [](const YarnToBuy& b) { return known(b.cost); });
  py::class_<YarnReport>(module, "YarnReport", "The yarn that a cloth takes.")
      .def_property_readonly("needs", [](const YarnReport& r) { return py::tuple(py::cast(r.needs)); })
      .def_property_readonly("buy", [](const YarnReport& r) { return py::tuple(py::cast(r.buy)); })
      .def_readonly("warp_m", &YarnReport::warp_m)
      .def_readonly("weft_m", &YarnReport::weft_m)
      .def_readonly("weight_g", &YarnReport::weight_g)
      .def_property_readonly("cost", [](const YarnReport& r) { return known(r.cost); })
      .def_readonly("g_per_m2", &YarnReport::g_per_m2);
}

void bind_measures(py::module_& module) {
  py::class_<ClothMeasures>(module, "ClothMeasures", "The measures of the planned cloth, on the loom and finished.")
      .def_readonly("ends", &ClothMeasures::ends)
      .def_readonly("picks", &ClothMeasures::picks)
      .def_readonly("floating", &ClothMeasures::floating)
      .def_readonly("dents", &ClothMeasures::dents)
      .def_readonly("reed_width_mm", &ClothMeasures::reed_width_mm)
      .def_readonly("woven_width_mm", &ClothMeasures::woven_width_mm)
      .def_readonly("width_mm", &ClothMeasures::width_mm)
      .def_readonly("warp_length_mm", &ClothMeasures::warp_length_mm)
      .def_readonly("woven_length_mm", &ClothMeasures::woven_length_mm)
      .def_readonly("length_mm", &ClothMeasures::length_mm)
      .def_readonly("loom_ends_per_cm", &ClothMeasures::loom_ends_per_cm)
      .def_readonly("loom_picks_per_cm", &ClothMeasures::loom_picks_per_cm)
      .def_readonly("cloth_ends_per_cm", &ClothMeasures::cloth_ends_per_cm)
      .def_readonly("cloth_picks_per_cm", &ClothMeasures::cloth_picks_per_cm);
}

void bind_comparison(py::module_& module) {
  py::class_<Difference>(module, "Difference", "One thing that two designs differ in.")
      .def_readonly("what", &Difference::what)
      .def_readonly("a", &Difference::a)
      .def_readonly("b", &Difference::b)
      .def_property_readonly("threads", [](const Difference& d) { return array_of(d.threads); })
      .def("__repr__", [](const Difference& d) {
        return fmt::format("<weftlight.Difference in {}: '{}', '{}'>", d.what, d.a, d.b);
      });
  py::class_<Comparison>(module, "Comparison", "What two designs differ in.")
      .def_property_readonly("differences", [](const Comparison& c) { return py::tuple(py::cast(c.differences)); })
      .def_readonly("same_cloth", &Comparison::same_cloth)
      .def_readonly("crossings", &Comparison::crossings);
  module.def(
      "compare", [](const Design& a, const Design& b) { return unlocked([&] { return analysis::compare(a, b); }); },
      py::arg("a"), py::arg("b"), "What two designs differ in.");
}

py::tuple long_floats(const Design& design, int limit, int most) {
  if (limit < 0 || most < 0) bad_value("limit and most are 0 or more");
  const LongFloats found = unlocked([&] { return analysis::long_floats(drawdown(design.draft), limit, most); });
  return py::make_tuple(found.count, found.listed);
}

double firm_sett(const Design& design, double wraps_per_cm) {
  if (!(wraps_per_cm > 0 && std::isfinite(wraps_per_cm))) bad_value("wraps_per_cm is above 0");
  return unlocked([&] {
    const BitMatrix cells = drawdown(design.draft);
    return analysis::firm_sett_per_cm(cells, analysis::weave_layers(cells), wraps_per_cm);
  });
}

}  // namespace

void bind_analysis(py::module_& module, py::class_<Design>& design) {
  bind_floats(module);
  bind_threads(module);
  bind_yarn_report(module);
  bind_measures(module);
  bind_comparison(module);
  design
      .def(
          "longest_floats",
          [](const Design& d) { return unlocked([&] { return analysis::longest_floats(drawdown(d.draft)); }); },
          "The longest float of each system on each face.")
      .def("long_floats", &long_floats, py::arg("limit"), py::arg("most") = 10000,
           "(count, floats) of more than `limit` threads.")
      .def(
          "layers", [](const Design& d) { return unlocked([&] { return analysis::weave_layers(drawdown(d.draft)); }); },
          "The layers that the cloth falls apart into, front to back.")
      .def(
          "loom_use", [](const Design& d) { return analysis::loom_use(d.draft); },
          "Heddles, and the use of shafts and treadles.")
      .def(
          "interlacing",
          [](const Design& d) { return unlocked([&] { return analysis::interlacing(drawdown(d.draft)); }); },
          "Interlacings per crossing.")
      .def("firm_sett_per_cm", &firm_sett, py::arg("wraps_per_cm"), "Ends per cm of a firm cloth.")
      .def(
          "handle", [](const Design& d) { return analysis::cloth_handle(d); }, "Weight and stiffness.")
      .def(
          "measures", [](const Design& d) { return analysis::cloth_measures(d); }, "The measures of the planned cloth.")
      .def(
          "yarn_report", [](const Design& d) { return unlocked([&] { return analysis::yarn_report(d); }); },
          "The yarn that the planned cloth takes.");
}

}  // namespace weftlight::python
