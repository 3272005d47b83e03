// U3M, a format of the textile industry. Based on: U3M 1.1, its schema and specification (Vizoo, Browzwear;
// github.com/vizoogmbh/u3m). Fibre densities:
//   J. W. S. Hearle, W. E. Morton, Physical Properties of Textile Fibres, 2008; 60% of the section of a yarn is fibre.

#include <algorithm>
#include <cmath>
#include <map>

#include "base/json.h"
#include "base/mark.h"
#include "base/whole_files.h"
#include "design/yarn_presets.h"
#include "draft/drawdown.h"
#include "files/fabric_physics.h"
#include "files/zip.h"
#include "texture_set/material_files.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

using base::write_file_atomically;
using cloth::Cloth, cloth::Period, cloth::ThreadBody, cloth::lay_out, cloth::srgb_from_linear;
using design::Design, design::Yarn, design::ready_yarn;
using draft::BitMatrix, draft::Face, draft::Rgb, draft::drawdown;
using files::FabricPhysics, files::ZipEntry, files::ZipKind, files::fabric_physics, files::write_zip;

namespace {

using nlohmann::json;
using enum Channel;
using enum PixelType;

constexpr std::array<Channel, 4> grey(Channel c) { return {c, c, c, kNone}; }  // U3M reads RGB alone

constexpr ImageRow kImages[] = {
    {"", "_basecolor", ".png", kU8, true, kBaseColor},
    {"", "_alpha", ".png", kU8, false, grey(kCoverage), true},
    {"", "_normal", ".png", kU8, false, kNormalUp},
    {"", "_roughness", ".png", kU8, false, grey(kRoughness), true},
    {"", "_metalness", ".png", kU8, false, grey(kMetal), true},
    {"", "_anisotropy", ".png", kU8, false, grey(kAspectAnisotropy), true},
    {"", "_rotation", ".png", kU8, false, grey(kWideAngle), true},
    {"", "_sheen", ".png", kU8, false, grey(kSheenWeight), true},
    {"", "_displacement", ".png", kU16, false, grey(kHeightNormalized)},
};

constexpr double kMmPerInch = 25.4;
constexpr double kPackingFraction = 0.6;  // fibre in the section of a yarn
constexpr double kCrimp = 1.06;           // length of a thread divided by that of the cloth

struct FibreRow {
  const char* word;  // in the yarn's name, lower case
  const char* type;  // of U3M
  double g_per_cm3;
};
constexpr FibreRow kFibres[] = {{"cotton", "Cotton", 1.52},
                                {"linen", "Linen", 1.50},
                                {"wool", "Wool", 1.31},
                                {"silk", "Silk", 1.34},
                                {"viscose", "Rayon", 1.52},
                                {"rayon", "Rayon", 1.52},
                                {"polyester", "Polyester", 1.38},
                                {"metal", "Metallic Fibre", 2.7},
                                {"nylon", "Nylon", 1.14},
                                {"hemp", "Hemp", 1.48},
                                {"jute", "Jute", 1.44}};
/// The row whose word is in the text.
const FibreRow* row_named_in(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const auto named = [&](const FibreRow& row) { return text.find(row.word) != std::string::npos; };
  const auto found = std::ranges::find_if(kFibres, named);
  return found != std::end(kFibres) ? found : nullptr;
}

/// By the yarn's name, since U3M has more fibres than a yarn can name; otherwise by its fibre.
const FibreRow& fibre_of(const Yarn& yarn) {
  const FibreRow* row = row_named_in(yarn.name);
  if (row == nullptr) row = row_named_in(ready_yarn(yarn.fibre).name);
  return row != nullptr ? *row : kFibres[0];
}

/// Grams of each fibre in one period.
std::map<std::string, double> grams_of(const Cloth& cloth) {
  std::map<std::string, double> out;
  const auto add = [&](const ThreadBody& t, double length_mm) {
    const FibreRow& fibre = fibre_of(cloth.yarns[static_cast<size_t>(t.yarn)]);
    const double section = 0.785398 * static_cast<double>(t.width_mm) * static_cast<double>(t.height_mm);
    out[fibre.type] += section * length_mm * kCrimp * kPackingFraction * fibre.g_per_cm3 * 1e-3;
  };
  for (const ThreadBody& t : cloth.ends) add(t, static_cast<double>(cloth.depth_mm));
  for (const ThreadBody& t : cloth.picks) add(t, static_cast<double>(cloth.width_mm));
  return out;
}

/// The step of a regular weave: ends by which each pick is shifted against the one before; -1 if it is not constant.
int step_of(const BitMatrix& cells) {
  const int n = cells.cols();
  for (int step = 1; step < n; ++step) {
    bool all = true;
    for (int pick = 0; all && pick < cells.rows(); ++pick) {
      const int next = (pick + 1) % cells.rows();
      for (int end = 0; all && end < n; ++end) all = cells.get(pick, end) == cells.get(next, (end + step) % n);
    }
    if (all) return step;
  }
  return -1;
}

/// The number of ends that lie over the first pick in one repeat.
int raised_ends(const BitMatrix& cells) {
  int count = 0;
  for (int end = 0; end < cells.cols(); ++end) count += cells.get(0, end) ? 1 : 0;
  return count;
}

std::string construction_of(const Design& design, const BitMatrix& cells) {
  constexpr int kMaxDobbyShafts = 28;
  const int n = cells.cols(), step = step_of(cells);
  if (n == 2 && cells.rows() == 2 && step == 1) return "Plain weave";
  if (step == 1) return "Twill - right hand (Z)";
  if (step == n - 1) return "Twill - left hand (S)";
  const int up = raised_ends(cells);
  if (step > 1 && n >= 5 && (up == 1 || up == n - 1)) return "Satin";
  return design.draft.shafts > kMaxDobbyShafts ? "Jacquard" : "Dobby";
}

std::string physics_file(const SetFacts& set) { return set.name + "_physics.json"; }

/// U3M's file of physics. Its raw data are forces that a machine measured, which there are none of; what is computed
/// from the yarns stands in the part that is free.
base::Result<void> write_physics(const SetFacts& set) {
  const FabricPhysics p = fabric_physics(set.design);
  const json root{{"schema", "1.1"},
                  {"raw_data", nullptr},
                  {"custom",
                   {{"weftlight",
                     {{"source", "computed from yarns and sett, not measured"},
                      {"weight_kg_per_m2", p.kg_per_m2},
                      {"thickness_mm", p.thickness_mm},
                      {"bending_n_m", p.bending_n_m},
                      {"bending_length_mm", p.bending_length_mm},
                      {"stretch_n_per_m", p.stretch_n_per_m},
                      {"bias_n_per_m", p.bias_n_per_m}}}}}};
  return write_file_atomically(set.folder + "/" + physics_file(set), root.dump(2) + "\n");
}

json physics(const SetFacts& set) {
  const Cloth& cloth = set.front.cloth();
  const std::map<std::string, double> grams = grams_of(cloth);
  double total = 0;
  for (const auto& [type, g] : grams) total += g;
  json parts = json::array();
  for (const auto& [type, g] : grams)
    parts.push_back({{"ratio", total > 0 ? g / total : 1.0}, {"type", type}, {"name", nullptr}});
  const SurfaceTexels &front = set.front.small(), &back = set.back.small();
  const BitMatrix weave = lay_out(set.design, drawdown(set.design.draft), Face::kFront, Period::kRepeat).up;
  return {{"thickness", static_cast<double>(front.high_mm + back.high_mm)},
          {"weight", 1000 * fabric_physics(set.design).kg_per_m2},
          {"devices", {{"fab", physics_file(set)}}},
          {"composition", {{"parts", parts}}},
          {"material_type", {{"type", "Woven"}, {"name", nullptr}}},
          {"construction", {{"type", construction_of(set.design, weave)}, {"name", nullptr}}}};
}

json image(const SetFacts& set, const std::string& suffix, Face face) {
  const FaceSource& source = set.of(face);
  const double width = static_cast<double>(source.small().width_mm),
               height = static_cast<double>(source.small().depth_mm);
  return {{"width", width},
          {"height", height},
          {"dpi", {{"x", source.size().width * kMmPerInch / width}, {"y", source.size().height * kMmPerInch / height}}},
          {"path", image_named(set, suffix, face)},
          {"repeat", {{"mode", "normal"}, {"rotation", 0}}}};
}

json constant(double v) { return {{"constant", v}, {"texture", nullptr}}; }

json scalar(const SetFacts& set, const std::string& suffix, Face face, double mean, double factor = 1) {
  if (const std::vector<float> even = factors_of(set, suffix, face); !even.empty())
    return constant(static_cast<double>(even[0]));
  return {{"constant", mean}, {"texture", {{"factor", factor}, {"offset", 0}, {"image", image(set, suffix, face)}}}};
}

json color(double r, double g, double b) { return {{"r", r}, {"g", g}, {"b", b}}; }

json normal_of(const json& texture) { return {{"constant", {{"x", 0}, {"y", 0}, {"z", 1}}}, {"texture", texture}}; }

json visual(const SetFacts& set, Face face) {
  const FaceSource& source = set.of(face);
  const SurfaceTexels& s = source.small();
  const Rgb mean = srgb_from_linear(source.mean_base());
  const FaceMeans& means = source.means();
  const double range = static_cast<double>(s.high_mm - s.low_mm);
  const json base = color(static_cast<double>(mean.r), static_cast<double>(mean.g), static_cast<double>(mean.b));
  return {
      {"shader", "principled"},
      {"basecolor",
       {{"constant", base},
        {"texture", {{"mode", "multiply"}, {"factor", color(1, 1, 1)}, {"image", image(set, "_basecolor", face)}}}}},
      {"alpha",
       set.alpha == Alpha::kOpaque ? constant(1) : scalar(set, "_alpha", face, static_cast<double>(source.coverage()))},
      {"normal", normal_of({{"scale", 1}, {"image", image(set, "_normal", face)}})},
      {"roughness", scalar(set, "_roughness", face, means.roughness)},
      {"metalness", scalar(set, "_metalness", face, means.metal)},
      {"anisotropy_value", scalar(set, "_anisotropy", face, means.aspect)},
      {"anisotropy_rotation", scalar(set, "_rotation", face, 0)},
      {"sheen_value", scalar(set, "_sheen", face, means.sheen)},
      {"sheen_tint", constant(1)},
      {"displacement", scalar(set, "_displacement", face, 0, range)},
      {"specular_value", constant(static_cast<double>(source.fit().specular()))},
      {"specular_tint", constant(0)},
      {"transmission", constant(std::clamp(means.transmitted, 0.0, 1.0))},
      {"ior", constant(1.5)},
      {"clearcoat_value", constant(0)},
      {"clearcoat_normal", normal_of(nullptr)},
      {"clearcoat_roughness", constant(0)},
      {"subsurface_value", constant(0)},
      {"subsurface_radius", constant(0)},
      {"subsurface_color", {{"constant", base}, {"texture", nullptr}}},
      {"preview", nullptr}};
}

/// A UUID of version 4, variant 1, from the digest: constant for the same set.
std::string uuid_of(const SetFacts& set) {
  std::string d = digest("weftlight u3m " + set.name + " " + set.design.title);
  d[12] = '4', d[16] = "89ab"[d[16] % 4];
  return d.substr(0, 8) + "-" + d.substr(8, 4) + "-" + d.substr(12, 4) + "-" + d.substr(16, 4) + "-" + d.substr(20, 12);
}

base::Result<void> write_material(const SetFacts& set) {
  const json root{{"schema", "1.1"},
                  {"custom", nullptr},
                  {"material",
                   {{"id", uuid_of(set)},
                    {"name", set.design.title.empty() ? set.name : set.design.title},
                    {"description", "Woven cloth, one seamless repeat of its draft"},
                    {"created", set.modified},
                    {"modified", set.modified},
                    {"front", visual(set, Face::kFront)},
                    {"back", visual(set, Face::kBack)},
                    {"side", nullptr},
                    {"physics", physics(set)},
                    {"metadata", nullptr}}}};
  const std::string file = set.name + ".u3m", path = set.folder + "/" + file;
  const std::string text = root.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
  base::Result<void> done = write_file_atomically(path, text);
  if (done) done = write_physics(set);
  if (!done) return done;
  std::vector<ZipEntry> entries{{file, path}, {physics_file(set), set.folder + "/" + physics_file(set)}};
  for (const Face face : {Face::kFront, Face::kBack}) {
    for (const ImageRow& row : kImages) {
      if (!factors_of(set, row.suffix, face).empty()) continue;
      const std::string image = image_file(set.target, row, set.name, face);
      entries.push_back({image, set.folder + "/" + image});
    }
  }
  return write_zip(set.folder + "/" + set.name + ".u3ma", entries, ZipKind::kU3ma);
}

}  // namespace

const ExportTarget targets::kU3m{
    .id = "u3m",
    .title = "U3M",
    .images = kImages,
    .model = {.sheen = formulas::kSheenDisney,
              .most_f0 = 2 * formulas::kEngineF0,
              .grazing = false,
              .anisotropic = true,
              .planes = 20},
    .highlight = "principled over Burley's body, specular value to 1",
    .sheen = "Burley's",
    .material = ".u3m",
    .write_material = write_material,
    .embeds_images = true,
    .sized_material = true,
    .note = base::mark("Import {name}.u3ma, one file with all images, or {name}.u3m where a program reads a folder. "
                       "{name}_physics.json has the numbers for a drape."),
};

}  // namespace weftlight::texture_set
