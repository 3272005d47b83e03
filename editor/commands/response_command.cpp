// `weftlight response`: the far-field radiance of the flat cloth under one directional light, as a table. The method
// `cloth` is evaluated on the CPU, `reference` and `fibres` are ray traced, the others are drawn as patches.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/text.h"
#include "commands/commands.h"
#include "commands/open_design.h"
#include "commands/picture_setup.h"
#include "design/methods.h"
#include "files/files.h"
#include "gl/open_headless.h"
#include "gl/renderer.h"
#include "render_data/face_cloth.h"
#include "render_data/flat_radiance.h"
#include "render_data/stages.h"

namespace weftlight::commands {

using base::ErrorKind, base::Result, base::arg, base::failure, base::fill, base::message, base::tr,
    base::write_file_atomically;
using cloth::Cloth, cloth::Period;
using design::Design, design::Look, design::Method, design::method_from_name;
using draft::BitMatrix, draft::Face, draft::drawdown;
using files::Image;
using gl::Renderer;
using render_data::FlatDirections, render_data::FlatPatch, render_data::PackedCloth, render_data::Stages,
    render_data::evaluated_radiance, render_data::face_cloth, render_data::fibre_radiance, render_data::traced_radiance,
    render_data::unit_direction;

namespace {

// A patch as a method draws it: of far cloth, whole repeats of at least so many yarns across a pixel. Single threads
// are drawn nearer, since samples that are larger than threads blur what they reflect; one repeat, with fewer pixels
// where it is long.
constexpr int kFarPixels = 8, kMostNearPixels = 96;  // along each side
constexpr float kFarYarns = 8, kNearYarns = 0.5f;    // across a pixel

std::vector<FlatDirections> directions_of(const ResponseOptions& o) {
  std::vector<FlatDirections> out;
  for (const bool warp : {true, false}) {
    if (o.plane != "both" && (o.plane == "warp") != warp) continue;
    for (const double view : o.views_deg)
      for (const double light : o.lights_deg) out.push_back({warp, view, light});
  }
  return out;
}

/// One value for each direction.
using Radiances = std::vector<glm::vec3>;

Cloth one_face(const Design& design, Face face) {
  const BitMatrix cells = drawdown(design.draft);
  return face_cloth(design, cells, face, Period::kRepeat);
}

Result<Radiances> traced(const Design& design, const ResponseOptions& o,
                         const std::vector<FlatDirections>& directions) {
  const Cloth cloth = one_face(design, o.face);
  Result<Radiances> radiances = o.method == "fibres" ? fibre_radiance(cloth, directions, o.spp)
                                                     : traced_radiance(cloth, directions, {o.spp, o.bounces});
  if (!radiances) return failure(radiances.error().kind, message(radiances.error()), o.file);
  return radiances;
}

FlatPatch drawn_patch(const PackedCloth& packed, Face face, Method method) {
  FlatPatch patch;
  glm::vec2 size_mm(packed.width_mm, packed.depth_mm);  // whole repeats, so that every part has the same weight
  patch.width = patch.height = kFarPixels;
  if (method == Method::kYarn) {
    const auto pixels = [&](float period) {
      return std::clamp(static_cast<int>(std::ceil(period / (kNearYarns * packed.mean_spacing_mm))), 1,
                        kMostNearPixels);
    };
    patch.width = pixels(size_mm.x), patch.height = pixels(size_mm.y);
  } else {
    size_mm *= glm::max(glm::ceil(kFarPixels * kFarYarns * packed.mean_spacing_mm / size_mm), 1.0f);
  }
  patch.step_x_mm = {size_mm.x / static_cast<float>(patch.width), 0};
  patch.step_y_mm = {0, size_mm.y / static_cast<float>(patch.height)};
  patch.face = face;
  patch.samples = formulas::kMaxYarnSamples;
  patch.light_irradiance = glm::vec3(1);
  return patch;
}

base::Failure no_graphics(const base::Error& error) {
  return failure(ErrorKind::kGraphics, fill(tr("no graphics: {problem}"), arg("problem", message(error))));
}

Result<Radiances> drawn(const Design& design, const ResponseOptions& o, const std::vector<FlatDirections>& directions) {
  const auto context = gl::open_headless();
  if (!context) return no_graphics(context.error());
  const auto made = Renderer::create();
  if (!made) return no_graphics(made.error());
  const std::unique_ptr<Renderer>& renderer = *made;
  Radiances out;
  Design shown = design;
  shown.look = Look{};
  shown.look.method = method_from_name(o.method).value_or(Method::kAuto);
  Stages stages;
  stages.update(std::make_shared<const Design>(shown));
  renderer->upload(stages.packed());
  FlatPatch patch = drawn_patch(stages.packed(), o.face, shown.look.method);
  for (const FlatDirections& d : directions) {
    patch.view = unit_direction(d.warp, d.view_deg), patch.light_towards = unit_direction(d.warp, d.light_deg);
    renderer->draw_patch(patch, shown.look);
    const Image image = renderer->read_patch();
    glm::vec3 sum(0);
    for (size_t i = 0; i + 3 < image.texels.size(); i += 4)
      sum += glm::vec3(image.texels[i], image.texels[i + 1], image.texels[i + 2]);
    out.push_back(sum / static_cast<float>(patch.width * patch.height));
  }
  return out;
}

Result<Radiances> radiances_of(const Design& design, const ResponseOptions& o,
                               const std::vector<FlatDirections>& directions) {
  if (o.method == "cloth") return evaluated_radiance(one_face(design, o.face), directions);
  if (o.method == "reference" || o.method == "fibres") return traced(design, o, directions);
  return drawn(design, o, directions);
}

std::string as_csv(const std::vector<FlatDirections>& directions, const Radiances& radiances) {
  std::string text = "plane,view_deg,light_deg,r,g,b\n";
  for (size_t i = 0; i < directions.size(); ++i) {
    const FlatDirections& d = directions[i];
    char row[160];
    const auto channel = [&](int c) { return static_cast<double>(radiances[i][c]); };
    std::snprintf(row, sizeof row, "%s,%g,%g,%.6g,%.6g,%.6g\n", d.warp ? "warp" : "weft", d.view_deg, d.light_deg,
                  channel(0), channel(1), channel(2));
    text += row;
  }
  return text;
}

}  // namespace

int response_command(const ResponseOptions& o) {
  if (const auto place = base::check_writable(o.out); !place) return fail(place.error());
  const OpenedDesign opened = open_design(o.file);
  if (!opened.ok) return kBadInput;
  if (opened.design.draft.ends() == 0 || opened.design.draft.picks() == 0) {
    return fail({ErrorKind::kInput, tr("the draft has no threads; give it at least one end and one pick"), o.file});
  }
  const std::vector<FlatDirections> directions = directions_of(o);
  const Result<Radiances> radiances = radiances_of(opened.design, o, directions);
  if (!radiances) return fail(radiances.error());
  return finish(write_file_atomically(o.out, as_csv(directions, *radiances)));
}

}  // namespace weftlight::commands
