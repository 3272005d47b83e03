// The options of the verbs that show, export or measure the cloth.

#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "base/text.h"
#include "chart/scene.h"
#include "commands/backdrop.h"
#include "commands/commands.h"
#include "commands/export_options.h"
#include "commands/file_options.h"
#include "commands/option_checks.h"
#include "commands/verbs.h"
#include "design/lights.h"
#include "design/methods.h"
#include "drape/mesh.h"
#include "files/files.h"
#include "light/formulas.h"
#include "texture_set/targets.h"

namespace weftlight::commands {

using base::arg, base::fill, base::mark, base::problem_of, base::tr;
using chart::ChartScene, chart::ChartSelection, chart::kChartFootprints, chart::kChartScenes, chart::kChartViews;
using design::LightingPreset, design::MethodFacts, design::kLightingPresets, design::kMethods;
using drape::drape_names;
using files::check_drape;
using texture_set::ExportTarget, texture_set::kTargets;

namespace {

constexpr Limits kElevation{-90, 90};  // degrees
constexpr float kUnset = std::numeric_limits<float>::quiet_NaN();

/// `drawn`: only those that the renderer draws.
std::vector<std::string> method_names(bool drawn) {
  std::vector<std::string> names;
  for (const MethodFacts& m : kMethods)
    if (m.drawn || !drawn) names.emplace_back(m.name);
  return names;
}

std::vector<std::string> target_ids() {
  std::vector<std::string> out;
  for (const ExportTarget* target : kTargets) out.emplace_back(target->id);
  return out;
}

std::vector<std::string> light_names() {
  std::vector<std::string> names;
  for (const LightingPreset& preset : kLightingPresets) names.push_back(preset.id);
  return names;
}

std::string all_drape_names() {
  std::string text;
  for (const std::string& name : drape_names()) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// The options of `render` and `reference`, and those of their values that are read after the parse.
struct PictureVerb {
  PictureOptions options;
  std::string size = "1280x800", view, light, exposure;
  bool transparent = false;
  Backdrop backdrop() const { return transparent ? Backdrop::kTransparent : Backdrop::kShown; }
};

/// False, with a line on stderr: the size is out of range.
bool apply_picture_texts(PictureVerb& verb) {
  constexpr float kMaxSide = 16384;
  PictureOptions& o = verb.options;
  float w = 0, h = 0;
  parse_pair(verb.size, 'x', w, h);
  if (w < 1 || h < 1 || w > kMaxSide || h > kMaxSide || w != std::floor(w) || h != std::floor(h)) {
    refuse(fill(tr("--size {size}: give whole pixels from 1x1 to 16384x16384"), arg("size", verb.size)));
    return false;
  }
  o.width = static_cast<int>(w);
  o.height = static_cast<int>(h);
  if (!verb.view.empty()) parse_pair(verb.view, ',', o.view_azimuth, o.view_elevation);
  if (!verb.light.empty()) parse_pair(verb.light, ',', o.light_azimuth, o.light_elevation);
  if (!verb.exposure.empty()) parse_exposure(verb.exposure, o.automatic_exposure, o.exposure_ev);
  return true;
}

/// The name of a shipped drape, or a file.
CLI::Validator drape_or_file() {
  return CLI::Validator([](const std::string& text) { return problem_of(check_drape(text)); }, tr("NAME|FILE"));
}

void add_mesh_options(CLI::App& verb, PictureOptions& o) {
  verb.add_option(
          "--mesh", o.mesh,
          fill(tr("Drape: {drapes}; or a .glb or .gltf file; default: the draft's"), arg("drapes", all_drape_names())))
      ->check(drape_or_file())
      ->check(input_file());
  verb.add_flag("--simulate-drape", o.simulated_drape,
                tr("Drape simulated with this fabric's own stiffness; takes up to a minute"));
  verb.add_flag("--own-drape", o.simulated_drape)->group("");  // the earlier name
}

void add_view_options(CLI::App& verb, PictureVerb& p) {
  PictureOptions& o = p.options;
  verb.add_option("--size", p.size, tr("Size of the picture in pixels; default: 1280x800"))->check(pair_of('x', "WxH"));
  verb.add_option("--method", o.method, tr("Shading method; default: the draft's, which is auto unless changed"))
      ->check(one_of(method_names(true)));
  verb.add_option("--yarns-per-pixel", o.yarns_per_pixel,
                  tr("Footprint in yarns per pixel at the middle of the picture; default: as the view frames it"))
      ->check(above_zero());
  verb.add_option(
          "--view", p.view,
          tr("Direction of the view in degrees: azimuth, and elevation from -90 to 90; distance and place stay as they "
             "are saved with the draft, or in --view-name; default: the draft's, for another --mesh the whole drape"))
      ->check(pair_of(',', "AZ,EL", {}, kElevation));
  verb.add_option("--view-name", o.view_name,
                  tr("View that is saved with the draft, or one of: whole, head_on, grazing, near; default: as --view"))
      ->type_name(tr("NAME"));
  add_face(verb, o.face);
}

void add_light_options(CLI::App& verb, PictureVerb& p) {
  PictureOptions& o = p.options;
  verb.add_option(
          "--light", p.light,
          tr("Direction of the key light in degrees: azimuth, and elevation from -90 to 90; default: that of the "
             "lighting"))
      ->check(pair_of(',', "AZ,EL", {}, kElevation));
  auto* preset = verb.add_option("--lights", o.lights,
                                 tr("Lighting preset; --light moves its key light; default: the draft's lighting"))
                     ->check(one_of(light_names()));
  verb.add_option("--environment", o.lights,
                  tr("Environment map, an equirectangular .hdr or .exr; --light rotates it; default: none"))
      ->check(environment_file())
      ->check(input_file())
      ->excludes(preset);
  verb.add_flag("--surroundings", o.surroundings, tr("Environment map as the backdrop"));
  verb.add_option(
          "--exposure", p.exposure,
          tr("Exposure in stops, or auto, which brightens cloth that reflects little; an .exr takes the stops only; "
             "default: the draft's"))
      ->check(exposure_form());
}

std::shared_ptr<PictureVerb> add_picture_options(CLI::App& verb) {
  auto picture = std::make_shared<PictureVerb>();
  PictureOptions& o = picture->options;
  o.view_azimuth = o.view_elevation = o.light_azimuth = o.light_elevation = o.exposure_ev = kUnset;
  verb.add_option("file", o.file, tr("Draft"))->required()->check(input_file());
  verb.add_option("-o,--output", o.out, tr("Output file: .png or .exr"))
      ->required()
      ->check(output_file({{".png", ".exr"}, true}));
  add_mesh_options(verb, o);
  add_view_options(verb, *picture);
  add_light_options(verb, *picture);
  verb.add_flag("--transparent", picture->transparent, tr("Cloth and form only, on a transparent background"))
      ->excludes(verb.get_option("--surroundings"));
  add_progress(verb, o.quiet, o.progress_json);
  verb.add_option("--stats", o.stats,
                  tr("JSON file for the cost and the estimated error of the picture; default: none"))
      ->check(output_file());
  return picture;
}

RunVerb add_render(CLI::App& verb) {
  const std::shared_ptr<PictureVerb> picture = add_picture_options(verb);
  PictureOptions& o = picture->options;
  auto* samples =
      verb.add_option("--samples", o.samples,
                      fill(tr("Samples per pixel where threads are drawn one by one, whatever the tolerance: 1, 2, 3, "
                              "5, 8, 13, 21 or {most}; other counts are rounded down to one of these; default: from "
                              "the tolerance"),
                           arg("most", int{formulas::kMaxYarnSamples})))
          ->check(whole_number(1, 1024));
  auto* tolerance =
      verb.add_option(
              "--tolerance", o.tolerance,
              tr("Error allowed for method auto, as a fraction of the brightness: 0.05 is 5%; default: the draft's"))
          ->check(number_in(0.01, 1.0));
  verb.add_option("--budget-ms", o.budget_ms,
                  tr("Time for drawing the cloth in milliseconds, without the compilation of shaders; the error is the "
                     "smallest that fits into it; default: no limit"))
      ->check(number_in(0.01, 1e7))
      ->excludes(samples)
      ->excludes(tolerance);
  verb.add_option("--turntable", o.turntable,
                  tr("Number of pictures of one full turn, named PICTURE_001.png and so on; the view moves to the "
                     "right; default: "
                     "one picture"))
      ->check(whole_number(1, 3600));
  return [picture] {
    return apply_picture_texts(*picture) ? render_command(picture->options, picture->backdrop()) : kUsage;
  };
}

RunVerb add_reference(CLI::App& verb) {
  const std::shared_ptr<PictureVerb> picture = add_picture_options(verb);
  PictureOptions& o = picture->options;
  verb.add_option("--spp", o.spp, tr("Samples per pixel; default: 64"))->check(whole_number(1, 1 << 20));
  auto* bounces =
      verb.add_option("--bounces", o.bounces, tr("Number of times that light goes from thread to thread; default: 2"))
          ->check(whole_number(0, 16));
  auto* fibres = verb.add_flag("--fibres", o.fibres,
                               tr("Trace every fibre, for close-ups of up to a few square centimetres; light is "
                                  "followed until it leaves the fibres"))
                     ->excludes(bounces);
  verb.add_flag("--layers", o.layers,
                tr("More channels in the .exr, of the cloth alone: depth, normal, place, thread, colour, direct and "
                   "indirect light"))
      ->excludes(fibres);
  verb.add_option("--seed", o.seed, tr("Random seed of the noise; default: 0"))->check(whole_number(0, 1 << 30));
  return [picture] {
    return apply_picture_texts(*picture) ? reference_command(picture->options, picture->backdrop()) : kUsage;
  };
}

void add_texture_options(CLI::App& verb, ExportOptions& o) {
  auto* size = verb.add_option("--size", o.size, tr("Side of the textures in texels, a power of two; default: 1024"))
                   ->check(whole_number(16, 8192));
  verb.add_option("--px-per-mm", o.texels_per_mm,
                  tr("Minimum resolution, in texels per millimetre of cloth; default: as --size gives it"))
      ->check(number_in(0.1, 1000.0))
      ->excludes(size);
  verb.add_option("--tile-cm", o.tile_cm,
                  tr("Minimum side of the tile in cm, filled with whole repeats; default: one repeat, or up to 5 for "
                     "yarns with "
                     "slubs, melange or unevenness"))
      ->check(number_in(0.1, 500.0));
  verb.add_option("--alpha", o.alpha, tr("Alpha mode of the gaps between threads; default: auto"))
      ->check(one_of({"auto", "opaque", "mask", "hashed", "blend"}));
  verb.add_option("--distance", o.distance_m,
                  tr("Viewing distance in metres that the roughness is made for; 0: close up; default: 1"))
      ->check(number_in(0.0, 1000.0));
  verb.add_option(
          "--mips", o.mips,
          tr("Format for 8-bit images with prefiltered mipmaps, written beside each image; in dds-bc and ktx2-bc "
             "colours and masks are compressed (BC4, BC5, BC7); default: none, for godot dds of the colours"))
      ->check(one_of({"dds", "ktx2", "dds-bc", "ktx2-bc"}));
  verb.add_option("--mesh", o.mesh,
                  fill(tr("Drape that the .glb shows: {drapes}; or a .glb or .gltf file; default: plane"),
                       arg("drapes", all_drape_names())))
      ->check(drape_or_file());
}

void add_material_options(CLI::App& verb, MaterialOptions& material) {
  verb.add_flag("--masks", material.masks,
                tr("Also export images for recolouring: the base colour of white yarn, warp and weft, and the colours "
                   "of the draft"));
  verb.add_flag("--lods", material.lods,
                tr("Also export sets for larger distances, named after the draft with -lod1 and -lod2: a quarter and a "
                   "sixteenth of the size, without the shade between threads, and with nothing but their colours"));
  verb.add_option("--uv", material.uv,
                  tr("Unit of the texture coordinates of the meshes that will use the material; tile: a repeat of the "
                     "images; default: mm"))
      ->check(one_of({"mm", "cm", "m", "tile"}));
  verb.add_option_function<std::string>(
          "--uv-offset",
          [&material](const std::string& text) { parse_pair(text, ',', material.uv_right_mm, material.uv_up_mm); },
          tr("Millimetres by which the cloth is moved on these meshes, to the right and up; default: 0,0"))
      ->check(pair_of(',', "X,Y"));
}

RunVerb add_export(CLI::App& verb) {
  struct Options {
    ExportOptions command;
    MaterialOptions material;
  };
  const auto options = std::make_shared<Options>();
  ExportOptions& o = options->command;
  verb.add_option("files", o.files, tr("Drafts (.wif, .dtx, .wpo), or folders of drafts"))
      ->required()
      ->check(input_file());
  verb.add_option("--target", o.targets, tr("Target programs, separated by commas; default: gltf"))
      ->delimiter(',')
      ->allow_extra_args(false)  // what follows is a draft
      ->check(one_of(target_ids()));
  verb.add_option("-o,--output", o.out, tr("Output folder"))->required()->check(some_path(mark("FOLDER")));
  add_texture_options(verb, o);
  add_material_options(verb, options->material);
  verb.add_option("--name", o.name,
                  tr("Template for the folder of a set; {name}, {target} and {size} are filled in; default: {name}, "
                     "with several targets {name}/{target}"))
      ->type_name(tr("TEMPLATE"));
  verb.add_flag("--versions,--colourways", o.versions,
                tr("Also export a set of each version or colourway, named after the draft and the version"));
  verb.add_option("--jobs", o.jobs, tr("Number of sets made at the same time; default: 1"))->check(whole_number(1, 64));
  verb.add_flag("--zip", o.zip, tr("Archive of each set beside its folder"));
  verb.add_flag("--resume", o.resume, tr("Skip sets that are complete and up to date"));
  verb.add_flag("--watch", o.watch, tr("Export again whenever a draft changes"));
  verb.add_flag("--force", o.force, tr("Overwrite other files that have the same names"));
  add_progress(verb, o.quiet, o.progress_json);
  return [options] { return export_command(options->command, options->material); };
}

/// One option for each measured quantity, with the values that the chart knows.
void add_chart_part(CLI::App& verb, ChartSelection& part) {
  std::vector<std::string> scenes;
  for (const ChartScene& scene : kChartScenes) scenes.emplace_back(scene.name);
  verb.add_option("--scene", part.scenes, tr("Cloths to measure, separated by commas; default: all"))
      ->delimiter(',')
      ->check(one_of(scenes));
  verb.add_option("--view", part.views_deg, tr("Views to measure, in degrees from the normal; default: all"))
      ->delimiter(',')
      ->check(one_of_numbers({kChartViews.begin(), kChartViews.end()}));
  verb.add_option("--yarns-per-pixel", part.yarns_per_pixel, tr("Footprints to measure; default: all"))
      ->delimiter(',')
      ->check(one_of_numbers({kChartFootprints.begin(), kChartFootprints.end()}));
}

RunVerb add_chart(CLI::App& verb) {
  const auto options = std::make_shared<ChartOptions>();
  ChartOptions& o = *options;
  verb.add_option("-o,--output", o.out, tr("Output folder"))->required()->check(some_path(mark("FOLDER")));
  add_chart_part(verb, o.part);
  verb.add_flag("--quick", o.quick, tr("Smaller patches; takes a few minutes"));
  verb.add_flag("--count", o.count, tr("Also count instructions, by single-stepping the processor; takes hours"));
  return [options] { return chart_command(*options); };
}

RunVerb add_response(CLI::App& verb) {
  const auto options = std::make_shared<ResponseOptions>();
  ResponseOptions& o = *options;
  verb.add_option("file", o.file, tr("Draft"))->required()->check(input_file());
  verb.add_option("-o,--output", o.out, tr("Output file: .csv"))->required()->check(output_file({{".csv"}}));
  std::vector<std::string> methods = method_names(false);
  methods.emplace_back("fibres");
  verb.add_option("--method", o.method,
                  tr("Shading method, or reference for ray tracing, fibres for tracing each fibre; default: cloth"))
      ->check(one_of(methods));
  verb.add_option("--plane", o.plane, tr("Threads that lie in the plane of incidence; default: both"))
      ->check(one_of({"warp", "weft", "both"}));
  verb.add_option_function<std::string>(
          "--views", [](const std::string&) {}, tr("View angles in degrees from the normal; default: 0,30,60"))
      ->check(angles_into(o.views_deg));
  verb.add_option_function<std::string>(
          "--lights", [](const std::string&) {}, tr("Light angles in degrees from the normal; default: -80:80:5"))
      ->check(angles_into(o.lights_deg));
  add_face(verb, o.face);
  verb.add_option("--spp", o.spp,
                  tr("Rays per sample of reference and fibres, with 1,024 samples per repeat; default: 16"))
      ->check(whole_number(1, 1 << 16));
  verb.add_option("--bounces", o.bounces,
                  tr("Number of times that light goes from thread to thread, reference only; default: 0, where one "
                     "reflection stands for all of them"))
      ->check(whole_number(0, 16));
  return [options] {
    if (options->lights_deg.empty()) options->lights_deg = *parse_angles("-80:80:5");
    return response_command(*options);
  };
}

RunVerb add_lobes(CLI::App& verb) {
  const auto options = std::make_shared<LobesOptions>();
  LobesOptions& o = *options;
  verb.add_option("file", o.file, tr("Draft"))->required()->check(input_file());
  verb.add_option("-o,--output", o.out, tr("Output file: .wif"))->required()->check(changed_file(draft_extensions()));
  verb.add_flag("--fit-lustre", o.fit_lustre, tr("Also fit the roughness along the fibres, which is the lustre"));
  add_progress(verb, o.quiet, o.progress_json);
  return [options] { return lobes_command(*options); };
}

RunVerb add_drape(CLI::App& verb) {
  struct Options {
    DrapeOptions command;
    std::string hang;  // the earlier name of --stiffness
  };
  const auto options = std::make_shared<Options>();
  DrapeOptions& o = options->command;
  verb.add_option("name", o.name,
                  fill(tr("{drapes} or all; or a draft, to drape its own fabric"), arg("drapes", all_drape_names())))
      ->required()
      ->check(input_file());
  verb.add_option("--mesh", o.mesh, tr("Drape for a draft; default: the one in its scene"))->type_name(tr("NAME"));
  verb.add_option("--stiffness", o.stiffness, tr("Drape stiffness of a generic fabric; default: medium"))
      ->check(one_of({"limp", "medium", "stiff"}));
  verb.add_option("--hang", options->hang)->check(one_of({"limp", "medium", "stiff"}))->group("");
  verb.add_option("-o,--output", o.out, tr("Output file: .glb or .gltf; for all: a folder"))
      ->required()
      ->check(output_file());
  return [options] {
    DrapeOptions& command = options->command;
    if (!command.stiffness.empty() && !options->hang.empty())
      return refuse(tr("--hang is the earlier name of --stiffness; give only one of them"));
    if (command.stiffness.empty()) command.stiffness = options->hang;
    return drape_command(command);
  };
}

RunVerb add_curves(CLI::App& verb) {
  struct Options {
    CurvesOptions command;
    std::string patch = "10x10", from = "0,0";
  };
  constexpr Limits kFrom{-10000, 10000};  // there, the step of a float is 0.001 mm, a tenth of a fibre
  const auto options = std::make_shared<Options>();
  CurvesOptions& o = options->command;
  verb.add_option("file", o.file, tr("Draft"))->required()->check(input_file());
  verb.add_option("-o,--output", o.out, tr("Output file: .usda"))->required()->check(output_file({{".usda"}, true}));
  verb.add_option("--as", o.detail, tr("A curve for each thread, ply or fibre; default: plies"))
      ->check(one_of({"threads", "plies", "fibres"}));
  verb.add_option("--patch", options->patch, tr("Width and height of the patch in mm; default: 10x10"))
      ->check(pair_of('x', "WxH"));
  verb.add_option("--from", options->from,
                  tr("Its lower left corner in mm from end 1 and pick 1, each from -10000 to 10000; default: 0,0"))
      ->check(pair_of(',', "X,Y", kFrom, kFrom));
  verb.add_option("--seed", o.seed, tr("Random seed of the fibres; default: 1"))
      ->check(whole_number(0, std::numeric_limits<int>::max()));
  return [options] {
    constexpr float kMax = 1000;
    CurvesOptions& command = options->command;
    parse_pair(options->patch, 'x', command.width_mm, command.height_mm);
    parse_pair(options->from, ',', command.left_mm, command.lower_mm);
    if (!(command.width_mm > 0 && command.height_mm > 0 && command.width_mm <= kMax && command.height_mm <= kMax))
      return refuse(
          fill(tr("--patch {patch}: give millimetres, above 0 and up to 1000"), arg("patch", options->patch)));
    return curves_command(command);
  };
}

constexpr Verb kClothVerbs[] = {
    {"render", mark("Render the lit, draped cloth as a picture"), add_render},
    {"reference", mark("Render the same picture by ray tracing the threads"), add_reference},
    {"export", mark("Export a seamless texture set"), add_export},
    {"chart", mark("Measure the speed and the accuracy of every shading method"), add_chart},
    {"response", mark("Tabulate the far-field radiance of the flat cloth"), add_response},
    {"lobes", mark("Fit the lobes of a draft's yarns to their traced fibres"), add_lobes},
    {"drape", mark("Simulate a drape, with a generic fabric or the fabric of a draft"), add_drape},
    {"curves", mark("Write the threads, plies or fibres of a patch of cloth as curves"), add_curves},
};

}  // namespace

std::span<const Verb> cloth_verbs() { return kClothVerbs; }

}  // namespace weftlight::commands
