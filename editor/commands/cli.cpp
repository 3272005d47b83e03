// The command line of the contract, read once here (CLI11 is slow to compile).

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <numeric>
#include <utility>

#include "base/files.h"
#include "base/utf8.h"
#include "commands/chart/scene.h"
#include "commands/commands.h"
#include "draft/lights.h"
#include "draft/methods.h"
#include "drape/mesh.h"
#include "light/formulas.h"

namespace weftlight::commands {
namespace {

constexpr float kUnset = std::numeric_limits<float>::quiet_NaN();

/// What was given, short enough for a line.
std::string quoted(const std::string& text) {
  constexpr size_t kLongest = 40;
  const std::string whole = as_utf8(text);
  const std::string head(cut_utf8(whole, kLongest));
  return "'" + head + (head.size() < whole.size() ? "..." : "") + "'";
}

bool parse_pair(const std::string& text, char between, float& a, float& b) {
  const size_t at = text.find(between, 1);
  if (at == std::string::npos) return false;
  try {
    size_t used_a = 0, used_b = 0;
    a = std::stof(text.substr(0, at), &used_a);
    b = std::stof(text.substr(at + 1), &used_b);
    return used_a == at && used_b == text.size() - at - 1 && std::isfinite(a) && std::isfinite(b);
  } catch (const std::exception&) {
    return false;
  }
}

CLI::Validator pair_of(char between, const std::string& form) {
  return CLI::Validator(
      [between, form](const std::string& text) {
        float a = 0, b = 0;
        return parse_pair(text, between, a, b) ? std::string{} : quoted(text) + " is not of the form " + form;
      },
      form);
}

CLI::Validator whole_number(int64_t low, int64_t high) {
  return CLI::Validator(
      [low, high](const std::string& text) {
        int64_t value = 0;
        const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool good = read.ec == std::errc{} && read.ptr == text.data() + text.size();
        return good && value >= low && value <= high ? std::string{}
                                                     : quoted(text) + " is not a whole number from " +
                                                           std::to_string(low) + " to " + std::to_string(high);
      },
      std::to_string(low) + ".." + std::to_string(high));
}

CLI::Validator above_zero() {
  return CLI::Validator(
      [](const std::string& text) {
        float value = 0;
        const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool good = read.ec == std::errc{} && read.ptr == text.data() + text.size() && std::isfinite(value);
        return good && value > 0 ? std::string{} : quoted(text) + " is not a number greater than 0";
      },
      "> 0");
}

CLI::Validator some_name() {
  return CLI::Validator([](const std::string& text) { return text.empty() ? "no name is given" : std::string{}; },
                        "PATH");
}

/// Letters to change, to add or to leave out (Levenshtein).
size_t distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 0; i < a.size(); ++i) {
    size_t corner = std::exchange(row[0], i + 1);
    for (size_t k = 0; k < b.size(); ++k) {
      const size_t changed = corner + (a[i] != b[k]);
      corner = row[k + 1];
      row[k + 1] = std::min({changed, corner + 1, row[k] + 1});
    }
  }
  return row.back();
}

/// The first word, where it is neither a verb nor like a file: a window would open on nothing.
bool refuse_mistyped_verb(const CLI::App& app, const std::string& word) {
  constexpr size_t kNear = 3;
  const std::filesystem::path file(word);
  std::error_code ignored;
  if (word.empty() || word[0] == '-' || file.has_extension() || file.has_parent_path()) return false;
  if (std::filesystem::exists(file, ignored)) return false;
  std::string nearest, all;
  size_t apart = std::min(kNear, word.size() / 2) + 1;  // most of the word must be right
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    all.append(all.empty() ? "" : ", ").append(verb->get_name());
    const size_t letters = distance(word, verb->get_name());
    if (letters == 0) return false;
    if (letters < apart) apart = letters, nearest = verb->get_name();
  }
  std::fprintf(stderr, "weftlight: %s is neither a verb nor a file; %s\n", quoted(word).c_str(),
               nearest.empty() ? ("the verbs are " + all).c_str() : ("did you mean '" + nearest + "'?").c_str());
  return true;
}

/// What was printed may have nowhere to go: a full device tells so only when it is flushed.
int with_output_flushed(int code) {
  std::cout.flush();
  errno = 0;
  const bool flushed = std::fflush(stdout) == 0;
  const int why = errno;
  if (flushed && !std::ferror(stdout) && std::cout) return code;
  std::fprintf(stderr, "weftlight: the standard output cannot be written%s\n",
               why != 0 ? (": " + cause_of(why)).c_str() : "");
  std::clearerr(stdout);
  std::cout.clear();
  return code == kDone ? kNotWritten : code;
}

void add_face(CLI::App* verb, std::string& face) {
  verb->add_option("--face", face, "Which face of the cloth")->check(CLI::IsMember({"front", "back"}));
}

std::vector<std::string> drawn_methods() {
  std::vector<std::string> names;
  for (const MethodFacts& m : kMethods)
    if (m.drawn) names.emplace_back(m.name);
  return names;
}

/// Degrees from the normal, as text: "0,30,60" or, from first to last by steps, "-80:80:5".
constexpr double kSteepest = 89.9;
constexpr size_t kMaxAngles = 10000;

std::string parse_angles(const std::string& text, std::vector<double>& out) {
  out.clear();
  const bool range = text.find(':') != std::string::npos;
  std::vector<double> numbers;
  size_t at = 0;
  while (at <= text.size()) {
    const size_t end = std::min(text.find(range ? ':' : ',', at), text.size());
    try {
      size_t used = 0;
      numbers.push_back(std::stod(text.substr(at, end - at), &used));
      if (used != end - at || !std::isfinite(numbers.back())) return "'" + text + "' is not a list of angles";
    } catch (const std::exception&) {
      return "'" + text + "' is not a list of angles";
    }
    at = end + 1;
  }
  if (range) {
    if (numbers.size() != 3 || numbers[2] <= 0 || numbers[1] < numbers[0])
      return "'" + text + "' is not of the form FROM:TO:STEP, upwards";
    const double count = std::floor((numbers[1] - numbers[0]) / numbers[2] + 1e-9) + 1;
    if (count > static_cast<double>(kMaxAngles)) return "'" + text + "': too many angles; take a wider step";
    for (int k = 0; k < static_cast<int>(count); ++k) out.push_back(numbers[0] + k * numbers[2]);
  } else {
    out = numbers;
  }
  if (out.size() > kMaxAngles) return "'" + text + "': too many angles";
  const bool inside = std::all_of(out.begin(), out.end(), [](double a) { return std::abs(a) <= kSteepest; });
  return inside ? std::string{} : "'" + text + "': angles lie between -89.9 and 89.9 degrees";
}

/// Reads the text into `out` as it checks it.
CLI::Validator angles_into(std::vector<double>& out) {
  return CLI::Validator([&out](const std::string& text) { return parse_angles(text, out); }, "A,B,..|FROM:TO:STEP");
}

std::vector<std::string> all_methods() {
  std::vector<std::string> names;
  for (const MethodFacts& m : kMethods) names.emplace_back(m.name);
  return names;
}

void add_response_options(CLI::App* verb, ResponseOptions& o, std::string& views, std::string& lights,
                          std::string& face) {
  verb->add_option("file", o.file, "Draft (.wif)")->required();
  verb->add_option("-o,--output", o.out, "Table (.csv)")->required();
  verb->add_option("--method", o.method, "Shading method, or reference")->check(CLI::IsMember(all_methods()));
  verb->add_option("--plane", o.plane, "What the plane of incidence holds beside the normal")
      ->check(CLI::IsMember({"warp", "weft", "both"}));
  verb->add_option("--views", views, "Degrees from the normal; 0,30,60")->check(angles_into(o.views_deg));
  verb->add_option("--lights", lights, "Degrees from the normal; -80:80:5")->check(angles_into(o.lights_deg));
  add_face(verb, face);
  verb->add_option("--spp", o.spp, "Reference: rays in each of 1,024 places of the repeat")
      ->check(CLI::Range(1, 1 << 16));
}

std::vector<std::string> light_names() {
  std::vector<std::string> names;
  for (const LightingPreset& setup : kLightSetups) names.push_back(setup.id);
  return names;
}

CLI::Validator environment_name() {
  return CLI::Validator(
      [](const std::string& text) {
        return is_environment(text) ? std::string{} : quoted(text) + " is neither an .hdr nor an .exr";
      },
      "FILE.hdr|FILE.exr");
}

struct PictureText {
  std::string size = "1280x800", view, light, exposure, face = "front";
};

/// "auto", "auto+0.5", or stops alone.
bool parse_exposure(const std::string& text, bool& automatic, float& stops) {
  constexpr float kMax = 20;
  constexpr std::string_view kAuto = "auto";
  automatic = text.starts_with(kAuto);
  stops = 0;
  std::string_view number(text);
  if (automatic) {
    number.remove_prefix(kAuto.size());
    if (number.empty()) return true;
    if (number[0] != '+' && number[0] != '-') return false;
  }
  if (number.starts_with('+')) number.remove_prefix(1);
  const auto read = std::from_chars(number.data(), number.data() + number.size(), stops);
  return read.ec == std::errc{} && read.ptr == number.data() + number.size() && std::abs(stops) <= kMax;
}

CLI::Validator exposure_form() {
  return CLI::Validator(
      [](const std::string& text) {
        bool automatic = false;
        float stops = 0;
        return parse_exposure(text, automatic, stops)
                   ? std::string{}
                   : quoted(text) + " is no exposure; give stops from -20 to 20, auto, or auto+EV";
      },
      "EV|auto|auto+EV");
}

void add_picture_options(CLI::App* verb, PictureOptions& o, PictureText& t) {
  verb->add_option("file", o.file, "Draft (.wif)")->required();
  verb->add_option("-o,--output", o.out, "Picture: .png or .exr")->required()->check(some_name());
  verb->add_option("--mesh", o.mesh, "A shipped drape or a .glb/.gltf file");
  verb->add_flag("--own-drape", o.simulated_drape,
                 "A shipped drape, simulated with this cloth's own stiffness (seconds)");
  verb->add_option("--size", t.size, "Pixels, WxH")->check(pair_of('x', "WxH"));
  verb->add_option("--method", o.method, "Shading method")->check(CLI::IsMember(drawn_methods()));
  verb->add_option("--yarns-per-pixel", o.yarns_per_pixel, "Footprint at the middle of the picture")
      ->check(above_zero());
  verb->add_option("--view", t.view, "Azimuth,elevation in degrees")->check(pair_of(',', "AZ,EL"));
  verb->add_option("--view-name", o.view_name, "A view kept with the draft, or: whole, head_on, grazing, near");
  verb->add_option("--light", t.light, "Azimuth,elevation in degrees")->check(pair_of(',', "AZ,EL"));
  auto* lights = verb->add_option("--lights", o.lights, "Light set-up; --light moves its key light")
                     ->check(CLI::IsMember(light_names()));
  verb->add_option("--environment", o.lights,
                   "Light from all around, an equirectangular .hdr or .exr; --light turns it")
      ->check(environment_name())
      ->excludes(lights);
  verb->add_flag("--surroundings", o.surroundings, "The environment's picture behind the cloth");
  verb->add_option("--exposure", t.exposure,
                   "Stops; auto: lifts a cloth the more, the less it reflects. An .exr takes the stops alone")
      ->check(exposure_form());
  add_face(verb, t.face);
  verb->add_option("--stats", o.stats, "Write costs as JSON")->check(some_name());
}

/// One option a measured thing, each of the values that the chart knows.
void add_chart_part(CLI::App* verb, ChartPart& part) {
  std::vector<std::string> scenes;
  for (const ChartScene& scene : kChartScenes) scenes.emplace_back(scene.name);
  verb->add_option("--scene", part.scenes, "Only these cloths")->delimiter(',')->check(CLI::IsMember(scenes));
  verb->add_option("--view", part.views_deg, "Only these views, degrees from the normal")
      ->delimiter(',')
      ->check(CLI::IsMember(std::vector<int>(kChartViews.begin(), kChartViews.end())));
  verb->add_option("--yarns-per-pixel", part.yarns_per_pixel, "Only these footprints")
      ->delimiter(',')
      ->check(CLI::IsMember(std::vector<double>(kChartFootprints.begin(), kChartFootprints.end())));
}

void add_analysis_options(CLI::App* verb, AnalyseOptions& o) {
  constexpr double kLongest = 1e7;  // mm
  verb->add_option("file", o.file, "Draft")->required();
  verb->add_flag("--json", o.json, "Machine-readable");
  verb->add_option("--floats", o.float_limit, "List floats of more threads than this")
      ->check(CLI::Range(0, kMaxThreads));
  verb->add_option("--length", o.plan.length_mm, "Finished cloth in mm; as drafted unless said")
      ->check(CLI::Range(0.0, kLongest));
  verb->add_option("--width", o.plan.width_mm, "Finished cloth in mm; as drafted unless said")
      ->check(CLI::Range(0.0, kLongest));
  verb->add_option("--waste", o.plan.loom_waste_mm, "Warp that stays on the loom, mm")
      ->check(CLI::Range(0.0, kLongest));
  verb->add_option("--shrinkage", o.plan.warp_shrinkage, "In the wash, 0.1 for a tenth")->check(CLI::Range(0.0, 0.9));
  verb->add_option("--spare", o.plan.spare, "Yarn lost in winding and shuttles, 0.1 for a tenth")
      ->check(CLI::Range(0.0, 1.0));
  verb->add_option("--price", o.prices, "What a kilogram costs: YARN=PRICE, or PRICE for all yarns");
}

bool take_picture_text(PictureOptions& o, const PictureText& t) {
  float w = 0, h = 0;
  parse_pair(t.size, 'x', w, h);
  if (w < 1 || h < 1 || w > 16384 || h > 16384 || w != std::floor(w) || h != std::floor(h)) {
    std::fprintf(stderr, "weftlight: --size %s: give whole pixels from 1x1 to 16384x16384\n", t.size.c_str());
    return false;
  }
  o.width = static_cast<int>(w);
  o.height = static_cast<int>(h);
  if (!t.view.empty()) parse_pair(t.view, ',', o.view_azimuth, o.view_elevation);
  if (!t.light.empty()) parse_pair(t.light, ',', o.light_azimuth, o.light_elevation);
  if (!t.exposure.empty()) parse_exposure(t.exposure, o.automatic_exposure, o.exposure_ev);
  o.face = t.face == "back" ? Face::kBack : Face::kFront;
  return true;
}

std::string lower(std::string words) {
  for (char& c : words) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return words;
}

/// The options of `print` that are words.
struct PrintText {
  std::string paper = "a4", end1 = "right", pick1 = "top", threading = "above";
  std::vector<std::string> parts;  // empty: all
  bool across = false;
};

void add_print_options(CLI::App* verb, print::PrintOptions& o, PrintText& t) {
  std::vector<std::string> papers, parts;
  for (const print::NamedPaper& paper : print::kPapers) papers.push_back(lower(paper.name));
  for (const print::NamedPart& part : print::kParts) parts.emplace_back(part.name);
  verb->add_option("--parts", t.parts, "What is printed, with commas; all unless said")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(parts));
  verb->add_option("--paper", t.paper, "Size of a sheet")->check(CLI::IsMember(papers));
  verb->add_flag("--across", t.across, "The sheets lie on their longer side");
  verb->add_option("--scale", o.cell_mm, "Side of a cell in mm; as fits unless said")->check(CLI::Range(0.5, 20.0));
  verb->add_option("--heavy", o.heavy_lines, "A heavier line every so many threads; 0: none")
      ->check(whole_number(0, 1000));
  verb->add_option("--end1", t.end1, "The side of end 1")->check(CLI::IsMember({"left", "right"}));
  verb->add_option("--pick1", t.pick1, "Where pick 1 is")->check(CLI::IsMember({"top", "bottom"}));
  verb->add_option("--threading", t.threading, "Where it is of the drawdown")->check(CLI::IsMember({"above", "below"}));
  verb->add_option("--dpi", o.png_dpi, "Dots an inch of a .png")->check(CLI::Range(30.0, 1200.0));
}

void take_print_text(print::PrintOptions& o, const PrintText& t) {
  for (const print::NamedPaper& paper : print::kPapers)
    if (lower(paper.name) == t.paper) o.paper = paper.paper;
  if (t.across) std::swap(o.paper.width_mm, o.paper.height_mm);
  o.end1_right = t.end1 == "right";
  o.pick1_bottom = t.pick1 == "bottom";
  o.threading_below = t.threading == "below";
  for (const print::NamedPart& part : print::kParts)
    o.parts.*part.on = t.parts.empty() || std::ranges::count(t.parts, part.name) > 0;
}

}  // namespace

static std::string drapes_in_words() {
  std::string words;
  for (const std::string& name : drape_names()) words += (words.empty() ? "" : ", ") + name;
  return words;
}

CommandLine run_command_line(int argc, char** argv) {
  CommandLine result;
  CLI::App app{"Weftlight: paint a draft and see the real cloth, lit and draped, at once"};
  app.name("weftlight");
  app.set_version_flag("--version", "weftlight " WEFTLIGHT_VERSION);
  app.require_subcommand(0, 1);
  app.failure_message([](const CLI::App* at, const CLI::Error& e) {
    const std::vector<CLI::App*> verbs = at->get_subcommands();
    const std::string who = verbs.empty() ? "weftlight" : "weftlight " + verbs[0]->get_name();
    return who + ": " + e.what() + "\nSee " + who + " --help.\n";
  });
  app.add_option("file", result.editor.file, "Draft to open in the editor");
  app.add_option("--live-export", result.editor.live_export, "Editor: keep this .wif up to date with every edit");
  app.add_option("--ui-map", result.editor.ui_map, "Editor: write where the controls are, as JSON");

  InfoOptions info;
  auto* info_verb = app.add_subcommand("info", "Counts, floats, repeat and warnings of a draft");
  info_verb->add_option("file", info.file, "Draft (.wif)")->required();
  info_verb->add_flag("--json", info.json, "Machine-readable");

  AnalyseOptions analyse;
  auto* analyse_verb = app.add_subcommand("analyse", "Floats, layers, repeat, heddles, sett and yarn of a draft");
  add_analysis_options(analyse_verb, analyse);

  PrintCommand print;
  auto* print_verb = app.add_subcommand("print", "The draft on paper: grids, lists for the loom, swatch");
  print_verb->add_option("file", print.file, "Draft")->required();
  print_verb->add_option("-o,--output", print.out, "A .pdf, .svg or .png")->required();
  PrintText print_text;
  add_print_options(print_verb, print.options, print_text);

  WeaveOptions weave;
  auto* weave_verb = app.add_subcommand("weave", "A draft from the table of weaves");
  weave_verb->add_option("weave", weave.weave, "Its id, of --list");
  weave_verb->add_option("-o,--output", weave.out, "New .wif");
  weave_verb->add_option("--set", weave.set, "A number of the weave, ID=VALUE");
  weave_verb->add_option("--ends", weave.ends, "Ends")->check(CLI::Range(1, kMaxThreads));
  weave_verb->add_option("--picks", weave.picks, "Picks")->check(CLI::Range(1, kMaxThreads));
  weave_verb->add_flag("--list", weave.list, "Every weave with its numbers");

  DiffOptions diff;
  auto* diff_verb = app.add_subcommand("diff", "What differs between two drafts");
  diff_verb->add_option("a", diff.a, "Draft")->required();
  diff_verb->add_option("b", diff.b, "Draft")->required();

  DrawdownOptions drawdown;
  std::string drawdown_face = "front";
  auto* drawdown_verb = app.add_subcommand("drawdown", "The drawdown as text, or as a coloured picture");
  drawdown_verb->add_option("file", drawdown.file, "Draft (.wif)")->required();
  drawdown_verb->add_flag("--points", drawdown.points,
                          "Picture with a pixel a crossing, black where the warp is on top");
  drawdown_verb
      ->add_option("-o,--output", drawdown.out, "Text file; .png, .jpg, .tif, .svg, .pdf: the coloured drawdown")
      ->check(some_name());
  add_face(drawdown_verb, drawdown_face);
  std::string end1 = "right", pick1 = "top";
  drawdown_verb->add_option("--end1", end1, "The side of end 1 in a coloured picture")
      ->check(CLI::IsMember({"left", "right"}));
  drawdown_verb->add_option("--pick1", pick1, "Where pick 1 is in one")->check(CLI::IsMember({"top", "bottom"}));

  ConvertOptions convert;
  bool to_lifts = false, to_treadles = false;
  auto* convert_verb = app.add_subcommand("convert", "Copy a draft, byte-true unless asked otherwise");
  convert_verb->add_option("in", convert.in, "Draft (.wif)")->required();
  convert_verb->add_option("out", convert.out, "New file")->required()->check(some_name());
  convert_verb->add_flag("--plain", convert.plain, "Save for other programs and looms");
  auto* lifts_flag = convert_verb->add_flag("--liftplan", to_lifts, "ShedControl by a liftplan");
  convert_verb->add_flag("--treadling", to_treadles, "ShedControl by tie-up and treadling")->excludes(lifts_flag);

  auto* shafts_option = convert_verb->add_option("--shafts", convert.loom.shafts, "Shafts that the loom has")
                            ->check(whole_number(1, kMaxShafts));
  auto* treadles_option = convert_verb->add_option("--treadles", convert.loom.treadles, "Treadles that the loom has")
                              ->check(whole_number(1, kMaxShafts))
                              ->excludes(lifts_flag);
  auto* nearest_flag = convert_verb->add_flag("--nearest", convert.nearest,
                                              "What does not fit the loom is woven as nearly as it can be");
  convert_verb->add_option("--ends", convert.picture.ends, "Of a picture: so many ends wide")
      ->check(whole_number(2, kMaxShafts));
  convert_verb->add_option("--colors", convert.picture.colors, "Of a picture: reduced to so many, each a weave")
      ->check(whole_number(2, 16));
  convert_verb->add_option("--floats", convert.picture.longest_float, "Of a picture: longest float of its weaves")
      ->check(whole_number(1, 1000));

  PictureOptions picture;
  picture.view_azimuth = picture.view_elevation = picture.light_azimuth = picture.light_elevation = kUnset;
  picture.exposure_ev = kUnset;
  PictureText picture_text;
  auto* render_verb = app.add_subcommand("render", "The lit, draped cloth as a picture");
  add_picture_options(render_verb, picture, picture_text);
  auto* reference_verb = app.add_subcommand("reference", "The same picture by ray tracing the threads");
  add_picture_options(reference_verb, picture, picture_text);
  constexpr int kMax = formulas::kMaxYarnSamples;
  auto* samples =
      render_verb
          ->add_option("--samples", picture.samples,
                       "Samples a pixel near the threads, whatever the tolerance: 1, 2, 3, 5, 8, 13, 21 or " +
                           std::to_string(kMax) + ", or what of these is next below")
          ->check(whole_number(1, 1024));
  auto* tolerance = render_verb
                        ->add_option("--tolerance", picture.tolerance,
                                     "Error allowed to the method auto, as a share of the brightness: 0.05 is 5%")
                        ->check(above_zero())
                        ->check(CLI::Range(0.01, 1.0));
  render_verb
      ->add_option("--budget-ms", picture.budget_ms,
                   "The least error with which the cloth is drawn in so many milliseconds")
      ->check(above_zero())
      ->check(CLI::Range(0.01, 1e7))
      ->excludes(samples)
      ->excludes(tolerance);
  render_verb
      ->add_option("--turntable", picture.turntable,
                   "So many pictures of one turn, PICTURE_001.png and on, the view going to the right")
      ->check(whole_number(1, 3600));
  reference_verb->add_option("--spp", picture.spp, "Samples a pixel")->check(whole_number(1, 1 << 20));
  reference_verb->add_option("--bounces", picture.bounces, "Indirect bounces")->check(whole_number(0, 16));

  ExportOptions texture;
  auto* export_verb = app.add_subcommand("export", "A seamless texture set of one repeat");
  export_verb->add_option("files", texture.files, "Drafts (.wif), or folders of them")->required();
  export_verb->add_option("--target", texture.targets, "What reads the sets; several with commas")
      ->delimiter(',')
      ->allow_extra_args(false)  // what follows is a draft
      ->check(
          CLI::IsMember({"gltf", "unreal", "unity-hdrp", "unity-urp", "godot", "blender", "u3m", "materialx", "raw"}));
  export_verb->add_option("-o,--output", texture.out, "Folder")->required()->check(some_name());
  auto* size_option =
      export_verb->add_option("--size", texture.size, "Texels a side, a power of two")->check(whole_number(16, 8192));
  export_verb->add_option("--px-per-mm", texture.texels_per_mm, "At least so many texels a millimetre")
      ->check(CLI::Range(0.1, 1000.0))
      ->excludes(size_option);
  export_verb->add_option("--tile-cm", texture.tile_cm, "A tile of many repeats, at least so wide and high")
      ->check(CLI::Range(0.1, 500.0));
  export_verb->add_option("--alpha", texture.alpha, "How gaps are shown")
      ->check(CLI::IsMember({"auto", "opaque", "mask", "hashed", "blend"}));
  export_verb->add_option("--distance", texture.distance_m, "Metres that the roughness is made for; 0: near by")
      ->check(CLI::Range(0.0, 1000.0));
  export_verb->add_option("--mips", texture.mips, "Beside each image of 8 bits, the same with mips of our own")
      ->check(CLI::IsMember({"dds", "ktx2"}));
  export_verb->add_option("--mesh", texture.mesh, "Drape for the .glb");
  export_verb->add_option("--name", texture.name, "Folder of a set: {name}, {target}, {size}");
  export_verb->add_option("--jobs", texture.jobs, "Sets at a time")->check(whole_number(1, 64));
  export_verb->add_flag("--zip", texture.zip, "An archive of each set beside its folder");
  export_verb->add_flag("--resume", texture.resume, "Leave sets that are complete and up to date");
  export_verb->add_flag("--watch", texture.watch, "Export again when a draft changes");
  export_verb->add_flag("--force", texture.force, "Write among files of others, over those of the same names");

  ChartOptions chart;
  auto* chart_verb = app.add_subcommand("chart", "Speed against accuracy, measured");
  chart_verb->add_option("-o,--output", chart.out, "Folder")->required()->check(some_name());
  add_chart_part(chart_verb, chart.part);
  chart_verb->add_flag("--quick", chart.quick, "Smaller patches: a few minutes");
  chart_verb->add_flag("--count", chart.count, "Instructions too, by single steps of the processor: hours");

  ResponseOptions response;
  std::string response_views, response_lights, response_face = "front";
  auto* response_verb = app.add_subcommand("response", "What the flat cloth sends back from afar, as a table");
  add_response_options(response_verb, response, response_views, response_lights, response_face);

  DrapeOptions drape;
  auto* drape_verb = app.add_subcommand("drape", "Simulate a shipped drape again, or a draft's own");
  drape_verb->add_option("name", drape.name, drapes_in_words() + " or all; or a draft, whose cloth is draped")
      ->required();
  drape_verb->add_option("--mesh", drape.mesh, "Of a draft: the drape, instead of its scene's");
  drape_verb->add_option("--hang", drape.hang, "How stiff the cloth is: limp, medium or stiff (all: each of them)")
      ->check(CLI::IsMember({"limp", "medium", "stiff"}));
  drape_verb->add_option("-o,--output", drape.out, "A .glb or .gltf, or a folder for all")
      ->required()
      ->check(some_name());

  if (argc > 1 && refuse_mistyped_verb(app, argv[1])) {
    result.exit_code = kUsage;
    return result;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    result.exit_code = with_output_flushed(app.exit(e) == 0 ? kDone : kUsage);
    return result;
  }

  drawdown.way = {end1 == "left", pick1 == "bottom"};
  drawdown.face = drawdown_face == "back" ? Face::kBack : Face::kFront;
  response.face = response_face == "back" ? Face::kBack : Face::kFront;
  if (response.lights_deg.empty()) parse_angles("-80:80:5", response.lights_deg);
  convert.drive = to_lifts      ? ConvertShedControl::kLiftplan
                  : to_treadles ? ConvertShedControl::kTreadling
                                : ConvertShedControl::kAsIs;
  if ((render_verb->parsed() || reference_verb->parsed()) && !take_picture_text(picture, picture_text)) {
    result.exit_code = kUsage;
    return result;
  }
  if (nearest_flag->count() > 0 && shafts_option->count() + treadles_option->count() == 0) {
    std::fprintf(stderr, "weftlight: --nearest: give the loom's --shafts or --treadles with it\n");
    result.exit_code = kUsage;
    return result;
  }
  take_print_text(print.options, print_text);
  analyse.plan.weft_shrinkage = analyse.plan.warp_shrinkage;
  if (info_verb->parsed()) result.exit_code = info_command(info);
  else if (drawdown_verb->parsed()) result.exit_code = drawdown_command(drawdown);
  else if (convert_verb->parsed()) result.exit_code = convert_command(convert);
  else if (render_verb->parsed()) result.exit_code = render_command(picture);
  else if (reference_verb->parsed()) result.exit_code = reference_command(picture);
  else if (export_verb->parsed()) result.exit_code = export_command(texture);
  else if (chart_verb->parsed()) result.exit_code = chart_command(chart);
  else if (response_verb->parsed()) result.exit_code = response_command(response);
  else if (drape_verb->parsed()) result.exit_code = drape_command(drape);
  else if (analyse_verb->parsed()) result.exit_code = analyse_command(analyse);
  else if (weave_verb->parsed()) result.exit_code = weave_command(weave);
  else if (print_verb->parsed()) result.exit_code = print_command(print);
  else if (diff_verb->parsed()) result.exit_code = diff_command(diff);
  else result.open_editor = true;
  if (!result.open_editor) result.exit_code = with_output_flushed(result.exit_code);
  return result;
}

}  // namespace weftlight::commands
