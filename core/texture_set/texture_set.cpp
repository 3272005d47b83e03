#include "texture_set/texture_set.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "cloth/cloth.h"
#include "draft/drawdown.h"
#include "texture_set/contact_sheet.h"
#include "texture_set/material_files.h"
#include "texture_set/set_folder.h"
#include "texture_set/set_images.h"

namespace weftlight::texture_set {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr size_t kMaxTileThreads = 8192;  // of a system, in a tile of many repeats
constexpr float kMinTexelsAThread = 2;
constexpr float kOpenCover = 0.9f;  // from which down gaps are seen
constexpr int kMinSize = 16, kMaxSize = 8192;

std::string millimetres(float v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", static_cast<double>(v));
  return text;
}

std::string size_words(const Surface& s) { return millimetres(s.width_mm) + " x " + millimetres(s.depth_mm) + " mm"; }

/// Which images go together, where not all do.
const char* advice(Target target) {
  if (target == Target::kUnityHdrp)
    return " BaseMap, MaskMap and NormalMap are for HDRP/Lit (the .mat); ThreadMap is for Fabric's thread slot, over a "
           "base of your own, never with them.";
  return "";
}

std::string readme(const FaceSource& face, const TextureSetOptions& o) {
  const Surface& s = face.small();
  return o.name + ": one seamless tile of " + o.source + ", " + size_words(s) + " (" +
         std::to_string(face.size().width) + " x " + std::to_string(face.size().height) + " texels), for " +
         target_name(o.target) + "; files with _back are the other face's.\n" + "Tile it once every " + size_words(s) +
         " (the materials take texture coordinates in millimetres); normal maps are " + normal_convention(o.target) +
         "; end 1 is at the right, pick 1 at the top." + advice(o.target) + "\n" +
         "texture_set.json lists every image, its channels and its colour space; contact_sheet.png shows them.\n";
}

/// What the set consists of, beside its list.
std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> out;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with('.')) out.push_back(name);
  }
  std::sort(out.begin(), out.end());
  return out;
}

json numbers(const glm::vec3& v) { return {v.x, v.y, v.z}; }

/// What a flat piece should send, by direction in the image (x right, y up, z out).
json checks_of(const FaceSource& face) {
  json out = json::array();
  const glm::vec3 turned(-1, -1, 1);
  for (const EngineCheck& c : face.checks())
    out.push_back({{"view", numbers(c.view * turned)},
                   {"light", numbers(c.light * turned)},
                   {"cloth", numbers(c.cloth)},
                   {"engine", numbers(c.engine)}});
  return out;
}

/// How near the material comes, by the elevation of the view.
json scores_of(const FaceSource& face) {
  json out = json::array();
  for (const EngineScore& s : face.scores())
    out.push_back({{"view_deg", s.view_deg}, {"mean", s.mean}, {"rms_error", s.error}});
  return out;
}

json fit_of(const FaceSource& face) {
  const EngineFit& f = face.fit();
  return {{"base_color", {f.base.r, f.base.g, f.base.b}},
          {"reflectance", {f.f0, f.f90}},
          {"highlight", {f.lobe.x, f.lobe.y}},
          {"sheen", f.sheen},
          {"sheen_roughness", f.sheen_roughness},
          {"rms_error", f.error},
          {"views", scores_of(face)},
          {"radiance", checks_of(face)}};
}

std::string list_of(const SetImages& images, const SetFacts& set, const TextureSetOptions& options,
                    const SetIdentity& identity, const std::string& material) {
  const Surface& s = set.front.small();
  const Cloth& cloth = set.front.cloth();
  json root{{"format", "weftlight texture set"},
            {"format_version", 2},
            {"program", "weftlight " + options.program_version},
            {"source", identity.source},
            {"draft", identity.draft},
            {"title", set.design.title},
            {"name", set.name},
            {"target", identity.target},
            {"normal", normal_convention(set.target)},
            {"orientation", "end 1 right, pick 1 top"},
            {"texture_coordinates", "millimetres"},
            {"size_mm", {s.width_mm, s.depth_mm}},
            {"size_texels", {set.front.size().width, set.front.size().height}},
            {"repeat", {{"ends", cloth.ends.size()}, {"picks", cloth.picks.size()}}},
            {"alpha", alpha_name(set.alpha)},
            {"coverage", set.front.coverage()},
            {"distance_m", options.distance_m},
            {"fit", {{"front", fit_of(set.front)}, {"back", fit_of(set.back)}}},
            {"maps", images.maps}};
  if (!material.empty()) root["material"] = material;
  if (!options.key.empty()) root["key"] = options.key;
  if (options.archived) root["archived"] = true;
  root["files"] = files_in(set.folder);
  return root.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

/// A title's bytes may be of any encoding; a picture's text takes the printable ones.
std::string printable(const std::string& text) {
  std::string out;
  for (char c : text) out += static_cast<unsigned char>(c) >= 32 ? c : ' ';
  return out;
}

std::string write_sheet(const SetImages& images, const SetFacts& set) {
  const std::string title = set.design.title.empty() ? set.name : printable(set.design.title);
  const Cloth& cloth = set.front.cloth();
  const std::string facts = std::string(target_name(set.target)) + "   " + size_words(set.front.small()) + "   " +
                            std::to_string(cloth.ends.size()) + " ends x " + std::to_string(cloth.picks.size()) +
                            " picks   " + std::to_string(set.front.size().width) + " x " +
                            std::to_string(set.front.size().height) + " texels";
  return write_image(set.folder + "/contact_sheet.png", contact_sheet(title, facts, set.front.small(), images.sheet),
                     PixelType::kU8);
}

SetIdentity identity_of(const fs::path& folder, const TextureSetOptions& options) {
  return {draft_from(folder, options.draft_path), options.source, target_name(options.target)};
}

int repeats_for(float mm, float tile_mm, size_t threads) {
  const int wanted = static_cast<int>(std::ceil(tile_mm / std::max(mm, 1e-3f) - 1e-3f));
  const int most = static_cast<int>(std::max<size_t>(kMaxTileThreads / std::max<size_t>(threads, 1), 1));
  return std::clamp(wanted, 1, most);
}

Cloth cloth_of(const Design& design, const BitMatrix& cells, Face face, float tile_mm) {
  Cloth cloth = lay_out(design, cells, face, Period::kRepeat);
  // The back's images are seen mirrored: handed the other way there, its yarns are handed the same way on the cloth.
  for (Yarn& yarn : cloth.yarns) {
    if (face == Face::kFront) break;
    yarn.twist = yarn.twist == Twist::kS ? Twist::kZ : yarn.twist == Twist::kZ ? Twist::kS : Twist::kNone;
  }
  if (tile_mm <= 0) return cloth;
  return tiled(cloth, repeats_for(cloth.width_mm, tile_mm, cloth.ends.size()),
               repeats_for(cloth.depth_mm, tile_mm, cloth.picks.size()));
}

/// Of the plane, about: as if threads lay straight.
float cover_of(const Cloth& cloth) {
  const auto share = [](const std::vector<ThreadBody>& threads, float mm) {
    float sum = 0;
    for (const ThreadBody& t : threads) sum += t.width_mm;
    return std::min(sum / std::max(mm, 1e-6f), 1.0f);
  };
  return 1 - (1 - share(cloth.ends, cloth.width_mm)) * (1 - share(cloth.picks, cloth.depth_mm));
}

/// Their importers are told to keep coverage, or they have no mips.
bool keeps_masks(Target target) {
  return target == Target::kUnreal || target == Target::kUnityHdrp || target == Target::kUnityUrp ||
         target == Target::kBlender || target == Target::kRaw;
}

bool has_metal(const Cloth& cloth) {
  return std::any_of(cloth.yarns.begin(), cloth.yarns.end(), [](const Yarn& y) { return y.lobes.metallic; });
}

FaceSource face_of(const Design& design, const BitMatrix& cells, Face face, const TextureSetOptions& options) {
  Cloth cloth = cloth_of(design, cells, face, options.tile_mm);
  const bool raw = options.target == Target::kRaw;
  FaceOptions of;
  of.size = texture_size(cloth.width_mm, cloth.depth_mm, options.size);
  of.horizon = raw, of.fitted = !raw, of.model = engine_model(options.target, has_metal(cloth)),
  of.older = older_model(options.target);
  // A path tracer averages what texels send, not texels: each keeps its own facets.
  const bool traced = options.target == Target::kBlender;
  of.footprint_mm = raw || traced ? 0 : kFootprintMmAtOneMetre * options.distance_m;
  return {std::move(cloth), of};
}

// How much of the work is done, about: once a face is measured, its images are written, and all of both.
constexpr float kMeasured = 0.1f, kFaceDone = 0.45f;

/// Tells how far a face is; false: nobody wants it.
std::function<bool(float)> part_of(const Progress& progress, float from) {
  return [&progress, from](float share) {
    if (progress.tell) progress.tell(from + kMeasured + share * (kFaceDone - kMeasured));
    return !progress.stop.stop_requested();
  };
}

/// Writes into `folder` what will stand in `place`.
std::string write_into(const std::string& folder, const std::string& place, const Design& design, const Mesh& mesh,
                       const TextureSetOptions& options, const Progress& progress) {
  const BitMatrix cells = drawdown(design.draft);
  if (cells.rows() < 1 || cells.cols() < 1) return "the draft has no cloth: it needs at least one end and one pick";
  const FaceSource front = face_of(design, cells, Face::kFront, options);
  SetImages images{folder, options.name,         options.target, json::array(), {},
                   {},     part_of(progress, 0), options.mips,   options.alpha};
  write_face(images, front, Face::kFront);
  if (!images.problem.empty()) return images.problem;
  const FaceSource back = face_of(design, cells, Face::kBack, options);
  images.going = part_of(progress, kFaceDone);
  write_face(images, back, Face::kBack);
  if (!images.problem.empty()) return images.problem;
  const SetFacts set{folder,
                     options.name,
                     options.target,
                     alpha_for(options.target, options.alpha, front.coverage()),
                     options.modified,
                     design,
                     front,
                     back,
                     mesh};
  const MaterialFile material = write_materials(set);
  std::string problem = progress.stop.stop_requested() ? std::string(kStopped) : material.error;
  if (problem.empty()) problem = write_sheet(images, set);
  if (problem.empty()) problem = write_file_atomically(folder + "/README.md", readme(front, options));
  if (problem.empty())
    problem = write_file_atomically(folder + "/texture_set.json",
                                    list_of(images, set, options, identity_of(place, options), material.file));
  return problem;
}

}  // namespace

std::string file_name_of(const std::string& text) {
  std::string out;
  for (char c : text) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    if (plain) out += c;
    else if (!out.empty() && out.back() != '_') out += '_';
  }
  while (!out.empty() && out.back() == '_') out.pop_back();
  return out.empty() ? "cloth" : out.substr(0, 100);
}

std::string key_of(const TextureSetOptions& o) {
  return o.program_version + " " + target_name(o.target) + " " + o.name + " " + std::to_string(o.size) + " " +
         alpha_name(o.alpha) + " " + number(static_cast<double>(o.distance_m)) + " " +
         number(static_cast<double>(o.tile_mm)) + (o.mips ? extension_of(*o.mips) : "");
}

namespace {

/// Threads laid side by side so many times, layer by layer. from: which thread each is.
struct Tiled {
  std::vector<ThreadBody> threads;
  std::vector<int> from;
};

Tiled repeated(const std::vector<ThreadBody>& threads, const std::vector<std::pair<int, int>>& runs, int times,
               float period_mm) {
  Tiled out;
  for (const auto& [first, count] : runs) {
    for (int k = 0; k < times; ++k) {
      for (int i = first; i < first + count; ++i) {
        ThreadBody t = threads[static_cast<size_t>(i)];
        t.centre_mm += static_cast<float>(k) * period_mm;
        out.threads.push_back(t), out.from.push_back(i);
      }
    }
  }
  return out;
}

}  // namespace

Cloth tiled(const Cloth& cloth, int across, int up) {
  std::vector<std::pair<int, int>> end_runs{{0, cloth.up.cols()}}, pick_runs{{0, cloth.up.rows()}};
  if (!cloth.layers.empty()) end_runs.clear(), pick_runs.clear();
  Cloth out = cloth;
  for (Layer& l : out.layers) {
    end_runs.emplace_back(l.first_end, l.ends), pick_runs.emplace_back(l.first_pick, l.picks);
    l = {l.first_end * across, l.ends * across, l.first_pick * up, l.picks * up};
  }
  const Tiled ends = repeated(cloth.ends, end_runs, across, cloth.width_mm),
              picks = repeated(cloth.picks, pick_runs, up, cloth.depth_mm);
  out.width_mm *= static_cast<float>(across), out.depth_mm *= static_cast<float>(up);
  out.ends = ends.threads, out.picks = picks.threads;
  out.up = BitMatrix(cloth.up.rows() * up, cloth.up.cols() * across);
  out.warp_level_mm.clear(), out.weft_level_mm.clear();
  for (int pick = 0; pick < out.up.rows(); ++pick) {
    for (int end = 0; end < out.up.cols(); ++end) {
      const int p = picks.from[static_cast<size_t>(pick)], e = ends.from[static_cast<size_t>(end)];
      out.up.set(pick, end, cloth.up.get(p, e));
      if (cloth.layers.empty()) continue;
      const size_t at = static_cast<size_t>(p) * static_cast<size_t>(cloth.up.cols()) + static_cast<size_t>(e);
      out.warp_level_mm.push_back(cloth.warp_level_mm[at]), out.weft_level_mm.push_back(cloth.weft_level_mm[at]);
    }
  }
  return out;
}

int size_for(const Design& design, float texels_per_mm, float tile_mm) {
  const Cloth cloth = cloth_of(design, drawdown(design.draft), Face::kFront, tile_mm);
  const float longer = std::max(cloth.width_mm, cloth.depth_mm) * texels_per_mm;
  int size = kMinSize;
  while (size < kMaxSize && static_cast<float>(size) < longer) size *= 2;
  return size;
}

SetFigures figures_of(const Design& design, const TextureSetOptions& options) {
  const BitMatrix cells = drawdown(design.draft);
  if (cells.rows() < 1 || cells.cols() < 1) return {};
  const Cloth cloth = cloth_of(design, cells, Face::kFront, options.tile_mm);
  SetFigures out{cloth.width_mm,
                 cloth.depth_mm,
                 cloth.ends.size(),
                 cloth.picks.size(),
                 texture_size(cloth.width_mm, cloth.depth_mm, options.size),
                 0,
                 0};
  const int64_t texels = int64_t{out.size.width} * out.size.height;
  for (const ImageRow& row : image_rows(options.target)) {
    // Cards hold one, two or four channels.
    const int channels = channels_of(row), held = channels == 3 ? 4 : channels;
    out.images += 2;
    out.texel_bytes += 2 * texels * held * (row.type == PixelType::kU8 ? 1 : 2) * 4 / 3;
  }
  return out;
}

FaceSource face_at(const Design& design, Face face, const TextureSetOptions& options, int side) {
  TextureSetOptions small = options;
  small.size = std::min(options.size, side);
  return face_of(design, drawdown(design.draft), face, small);
}

std::vector<std::string> warnings_of(const Design& design, const TextureSetOptions& options) {
  const BitMatrix cells = drawdown(design.draft);
  if (cells.rows() < 1 || cells.cols() < 1) return {};
  const Cloth cloth = cloth_of(design, cells, Face::kFront, options.tile_mm);
  const TextureSize size = texture_size(cloth.width_mm, cloth.depth_mm, options.size);
  const float each = std::min(static_cast<float>(size.width) / static_cast<float>(cloth.ends.size()),
                              static_cast<float>(size.height) / static_cast<float>(cloth.picks.size()));
  std::vector<std::string> out;
  if (each < kMinTexelsAThread)
    out.push_back("a thread gets " + millimetres(each) +
                  " texels; give a larger --size (or a smaller tile) to see threads");
  if (options.alpha == Alpha::kMask && !options.mips && !keeps_masks(options.target) && cover_of(cloth) < kOpenCover)
    out.push_back(
        "gaps of a mask close from afar where programs make the mips; --alpha auto keeps them, or --mips ktx2");
  return out;
}

std::string who_is_there(const std::string& folder, const TextureSetOptions& options) {
  return in_the_way(folder, identity_of(folder, options));
}

std::string write_texture_set(const std::string& folder, const Design& design, const Mesh& mesh,
                              const TextureSetOptions& options, const Progress& progress) {
  std::string problem = options.force ? std::string{} : who_is_there(folder, options);
  if (!problem.empty()) return problem;
  const fs::path made = make_staging(folder, problem);
  if (!problem.empty()) return problem;
  try {
    problem = write_into(made.string(), folder, design, mesh, options, progress);
  } catch (const std::bad_alloc&) {
    problem = "not enough memory; export a smaller --size";
  }
  if (problem.empty()) problem = put_in_place(made, folder, identity_of(folder, options), options.force);
  std::error_code ec;
  fs::remove_all(made, ec);
  return problem;
}

}  // namespace weftlight::texture_set
