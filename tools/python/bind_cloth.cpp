// One period of the cloth as arrays, and the light that it sends back from afar.

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <cmath>
#include <memory>

#include "cloth/maps.h"
#include "draft/drawdown.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/long_call.h"
#include "python/texts.h"
#include "render_data/face_cloth.h"
#include "render_data/flat_radiance.h"

namespace weftlight::python {

using cloth::Cloth, cloth::Direction, cloth::Linear, cloth::Maps, cloth::MapsSize, cloth::Period, cloth::Plane,
    cloth::Slope, cloth::bake;
using design::Design;
using draft::Face, draft::System, draft::drawdown;
using render_data::FlatDirections, render_data::evaluated_radiance, render_data::face_cloth,
    render_data::traced_radiance;

namespace {

constexpr int kMaxSide = 16384, kMaxAzimuths = 64;

Maps baked(const Design& design, Face face, Period period, const MapsSize& size) {
  return bake(face_cloth(design, drawdown(design.draft), face, period), size);
}

Maps maps_of(const Design& design, std::pair<int, int> size, Face face, Period period, int azimuths) {
  const auto [width, height] = size;
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide)
    bad_value(fmt::format("size is (width, height), each of 1 to {}", kMaxSide));
  if (azimuths < 0 || azimuths > kMaxAzimuths) bad_value(fmt::format("azimuths are 0 to {}", kMaxAzimuths));
  MapsSize asked;
  asked.width = width, asked.height = height, asked.azimuths = azimuths;
  return long_call(py::none(), [&](const base::TaskProgress&) { return baked(design, face, period, asked); });
}

/// (height, width, 3): unit normals, from the slopes.
py::array_t<float> normals_of(const Maps& maps) {
  const Plane<Slope>& slope = maps.slope;
  py::array_t<float> normals({slope.height, slope.width, 3});
  float* at = normals.mutable_data();
  for (const Slope& s : slope.at_) {
    const float length = std::sqrt(s.x * s.x + s.y * s.y + 1);
    *at++ = s.x / length, *at++ = s.y / length, *at++ = 1 / length;
  }
  return normals;
}

/// (azimuths, height, width).
py::array_t<uint8_t> horizons_of(const Maps& maps) {
  py::array_t<uint8_t> horizons({maps.azimuths, maps.height_mm.height, maps.height_mm.width});
  uint8_t* at = horizons.mutable_data();
  for (const Plane<uint8_t>& plane : maps.horizon) at = std::copy(plane.at_.begin(), plane.at_.end(), at);
  return horizons;
}

/// A plane as a read-only view that keeps the maps alive.
template <class Channel, class T>
auto plane(Plane<T> Maps::*member) {
  return [member](const py::object& self) { return view_of<Channel>(self.cast<const Maps&>().*member, self); };
}

void bind_maps(py::module_& module) {
  py::class_<Maps>(module, "Maps", "One period of a face, sampled on a grid without seams.")
      .def_readonly("width_mm", &Maps::width_mm)
      .def_readonly("depth_mm", &Maps::depth_mm)
      .def_property_readonly("height_mm", plane<float>(&Maps::height_mm))
      .def_property_readonly("coverage", plane<float>(&Maps::coverage))
      .def_property_readonly("color", plane<float>(&Maps::colour))
      .def_property_readonly("groove", plane<float>(&Maps::groove))
      .def_property_readonly("slope", plane<float>(&Maps::slope))
      .def_property_readonly("tangent", plane<float>(&Maps::tangent))
      .def_property_readonly("system", plane<uint8_t>(&Maps::system))
      .def_property_readonly("thread", plane<uint32_t>(&Maps::thread))
      .def_property_readonly("occlusion", plane<float>(&Maps::occlusion))
      .def_property_readonly("normal", &normals_of)
      .def_property_readonly("horizon", &horizons_of)
      .def("__repr__", [](const Maps& maps) {
        return fmt::format("<weftlight.Maps: {} x {} texels, {:.2f} x {:.2f} mm>", maps.height_mm.width,
                           maps.height_mm.height, maps.width_mm, maps.depth_mm);
      });
}

std::vector<FlatDirections> directions_of(System plane, const std::vector<double>& views,
                                          const std::vector<double>& lights) {
  std::vector<FlatDirections> directions;
  for (const double view : views) {
    if (!(std::abs(view) < 90)) bad_value("views are within 90 degrees of the normal");
    for (const double light : lights) {
      if (!(std::abs(light) <= 180)) bad_value("lights are within 180 degrees of the normal");
      directions.push_back({plane == System::kWarp, view, light});
    }
  }
  return directions;
}

/// (views, lights, 3).
py::array_t<float> response_of(const Design& design, const std::vector<double>& views,
                               const std::vector<double>& lights, System plane, Face face, bool reference, int spp,
                               const py::object& progress) {
  if (spp < 1 || spp > 1 << 20) bad_value("spp is 1 to 1048576");
  const std::vector<FlatDirections> directions = directions_of(plane, views, lights);
  const std::vector<glm::vec3> radiances = long_call(progress, [&](const base::TaskProgress& task) {
    const Cloth cloth = face_cloth(design, drawdown(design.draft), face, Period::kRepeat);
    return reference ? value_of(traced_radiance(cloth, directions, {spp, 0}, task))
                     : evaluated_radiance(cloth, directions);
  });
  py::array_t<float> out(
      {static_cast<py::ssize_t>(views.size()), static_cast<py::ssize_t>(lights.size()), py::ssize_t{3}});
  float* at = out.mutable_data();
  for (const glm::vec3& rgb : radiances) *at++ = rgb.r, *at++ = rgb.g, *at++ = rgb.b;
  return out;
}

}  // namespace

void bind_cloth(py::module_& module, py::class_<Design>& design) {
  bind_maps(module);
  design
      .def("maps", &maps_of, py::arg("size") = std::pair(1024, 1024), py::kw_only(), py::arg("face") = Face::kFront,
           py::arg("period") = Period::kRepeat, py::arg("azimuths") = 0, "One period of the cloth as arrays.")
      .def("response", &response_of, py::arg("views_deg"), py::arg("lights_deg"), py::kw_only(),
           py::arg("plane") = System::kWarp, py::arg("face") = Face::kFront, py::arg("reference") = false,
           py::arg("spp") = 16, py::arg("progress") = py::none(),
           "(views, lights, 3) float32: far-field radiance of the flat cloth under one light.");
}

}  // namespace weftlight::python
