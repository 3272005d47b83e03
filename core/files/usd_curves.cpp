// Curves as USD text: https://openusd.org/release/api/class_usd_geom_basis_curves.html

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

#include "base/whole_files.h"
#include "files/files.h"

namespace weftlight::files {

using base::write_file_atomically;
using cloth::CurveGroup, cloth::Curves;

namespace {

constexpr const char* kStage = R"(#usda 1.0
(
    defaultPrim = "Cloth"
    metersPerUnit = 0.001
    upAxis = "Y"
    doc = "{width:.6g} x {height:.6g} mm of cloth as curves: x along the weft, y along the warp, z towards the viewer"
)

def Xform "Cloth"
{{
)";

constexpr const char* kMaterial = R"(
        def Material "Material"
        {{
            token outputs:surface.connect = </Cloth/{name}/Material/Surface.outputs:surface>

            def Shader "Surface"
            {{
                uniform token info:id = "UsdPreviewSurface"
                color3f inputs:diffuseColor.connect = </Cloth/{name}/Material/Colour.outputs:result>
                float inputs:roughness = {roughness:.4g}
                float inputs:metallic = {metallic}
                float inputs:ior = {ior:.4g}
                token outputs:surface
            }}

            def Shader "Colour"
            {{
                uniform token info:id = "UsdPrimvarReader_float3"
                string inputs:varname = "displayColor"
                float3 outputs:result
            }}
        }}
    }}
)";

/// Writes numbers of a list, separated.
class List {
 public:
  List(std::string& text, const char* head) : text_(text) { text_.append(head).append(" = ["); }
  template <class... Values>
  void add(fmt::format_string<Values...> form, Values&&... values) {
    if (!first_) text_ += ", ";
    first_ = false;
    fmt::format_to(std::back_inserter(text_), form, std::forward<Values>(values)...);
  }
  /// `interpolation`: of a primvar, or empty.
  void end(const char* interpolation = "") {
    text_ += "]";
    if (*interpolation != 0)
      text_.append(" (\n            interpolation = \"").append(interpolation).append("\"\n        )");
    text_ += "\n";
  }

 private:
  std::string& text_;
  bool first_ = true;
};

/// Calls `visit` with the points of each curve and, before the first and after the last, one more on the same line: a
/// curve of Catmull and Rom runs from its second point to the last but one.
template <class Visit>
void for_each_vertex(const CurveGroup& group, Visit visit) {
  size_t first = 0;
  for (const int count : group.points_in) {
    const glm::vec4* p = group.points.data() + first;
    const auto last = static_cast<size_t>(count - 1);
    visit(glm::vec4(2.0f * glm::vec3(p[0]) - glm::vec3(p[1]), p[0].w));
    for (size_t k = 0; k <= last; ++k) visit(p[k]);
    visit(glm::vec4(2.0f * glm::vec3(p[last]) - glm::vec3(p[last - 1]), p[last].w));
    first += last + 1;
  }
}

void append_extent(std::string& text, const CurveGroup& group) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const glm::vec4& p : group.points) {
    low = glm::min(low, glm::vec3(p) - 0.5f * p.w);
    high = glm::max(high, glm::vec3(p) + 0.5f * p.w);
  }
  List extent(text, "        float3[] extent");
  for (const glm::vec3 v : {low, high}) extent.add("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z);
  extent.end();
}

void append_curves(std::string& text, const CurveGroup& group) {
  append_extent(text, group);
  List counts(text, "        int[] curveVertexCounts");
  for (const int count : group.points_in) counts.add("{}", count + 2);
  counts.end();
  List points(text, "        point3f[] points");
  for_each_vertex(group, [&](glm::vec4 p) { points.add("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z); });
  points.end();
  List widths(text, "        float[] widths");
  for_each_vertex(group, [&](glm::vec4 p) { widths.add("{:.4g}", p.w); });
  widths.end("vertex");
  List colours(text, "        color3f[] primvars:displayColor");
  for (const Linear& c : group.colour) colours.add("({:.4g}, {:.4g}, {:.4g})", c.r, c.g, c.b);
  colours.end("uniform");
  List threads(text, "        int[] primvars:thread");
  for (const int thread : group.thread) threads.add("{}", thread);
  threads.end("uniform");
}

void append_group(std::string& text, const CurveGroup& group) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "    def BasisCurves \"{}\" (\n        prepend apiSchemas = [\"MaterialBindingAPI\"]\n    )\n    {{\n"
                 "        uniform token type = \"cubic\"\n        uniform token basis = \"catmullRom\"\n"
                 "        uniform token wrap = \"nonperiodic\"\n",
                 group.name);
  append_curves(text, group);
  fmt::format_to(out,
                 "        float primvars:turns_per_m = {:.6g} (\n            interpolation = \"constant\"\n"
                 "            doc = \"twist of the yarn; positive: Z\"\n        )\n"
                 "        rel material:binding = </Cloth/{}/Material>\n",
                 group.turns_per_m, group.name);
  fmt::format_to(out, kMaterial, fmt::arg("name", group.name), fmt::arg("roughness", group.roughness),
                 fmt::arg("metallic", group.metallic ? 1 : 0), fmt::arg("ior", group.ior));
}

}  // namespace

base::Result<void> write_curves(const std::string& path, const Curves& curves) {
  std::string text;
  fmt::format_to(std::back_inserter(text), kStage, fmt::arg("width", curves.size_mm.x),
                 fmt::arg("height", curves.size_mm.y));
  for (const CurveGroup& group : curves.groups) append_group(text, group);
  text += "}\n";
  return write_file_atomically(path, text);
}

}  // namespace weftlight::files
