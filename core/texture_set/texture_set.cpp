#include "texture_set/texture_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "cloth/cloth.h"
#include "draft/drawdown.h"
#include "texture_set/contact_sheet.h"
#include "texture_set/material_files.h"
#include "texture_set/set_folder.h"

namespace weftlight::texture_set {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kLeastSide = 16;
constexpr int kAzimuths = 16;                           // of the horizon, which occlusion is made from
constexpr int64_t kMostBakedTexels = int64_t{1} << 24;  // about 1 GiB of maps
constexpr int kSamplesAThread = 4;

/// Texels baked for each texel of the set, a side: at least two, so that rims are smooth and the spread
/// of normals is known; more where threads are finer than texels; fewer where memory ends.
int supersampling(const Cloth& cloth, TextureSize size) {
  const double texels_x = static_cast<double>(size.width) / static_cast<double>(std::max<size_t>(cloth.ends.size(), 1));
  const double texels_y =
      static_cast<double>(size.height) / static_cast<double>(std::max<size_t>(cloth.picks.size(), 1));
  int factor = 2;
  while (factor < 8 && std::min(texels_x, texels_y) * factor < kSamplesAThread) factor *= 2;
  while (factor > 1 && int64_t{size.width} * size.height * factor * factor > kMostBakedTexels) factor /= 2;
  return factor;
}

Surface surface_of(const Cloth& cloth, TextureSize size, bool with_horizon) {
  const int factor = supersampling(cloth, size);
  Maps maps = bake(cloth, {size.width * factor, size.height * factor, kAzimuths});
  if (!with_horizon) maps.horizon.clear();
  return make_surface(cloth, maps, size.width, size.height);
}

const char* type_words(PixelType type) {
  switch (type) {
    case PixelType::kU8:
      return "8-bit";
    case PixelType::kU16:
      return "16-bit";
    case PixelType::kHalf:
      return "half";
    case PixelType::kFloat:
      break;
  }
  return "float";
}

/// A set while it is written: what the sheet and the list will say.
struct Writing {
  std::string folder, place;
  const TextureSetOptions& options;
  json maps = json::array();
  std::vector<SheetEntry> sheet;
  std::string problem;
};

void record(Writing& set, const std::string& file, const char* face, const char* space, PixelType type,
            const Image& image, json channels) {
  set.maps.push_back({{"file", file},
                      {"face", face},
                      {"color_space", space},
                      {"type", type_words(type)},
                      {"width", image.width},
                      {"height", image.height},
                      {"channels", std::move(channels)}});
}

/// Of an .exr, which has names for its channels; else none.
std::vector<std::string> names_of(const ImageRow& row) {
  std::vector<std::string> out;
  if (std::string_view(row.extension) != ".exr") return out;
  for (size_t c = 0; c < row.channels.size() && row.channels[c] != Channel::kNone; ++c)
    out.emplace_back(exr_name(row.channels[c]));
  return out;
}

json channel_list(const ImageRow& row) {
  constexpr const char* kLetters[] = {"R", "G", "B", "A"};
  const std::vector<std::string> names = names_of(row);
  json out = json::object();
  for (size_t c = 0; c < row.channels.size() && row.channels[c] != Channel::kNone; ++c)
    out[names.empty() ? kLetters[c] : names[c]] = channel_words(row.channels[c]);
  return out;
}

/// Thumbnails show colour as a screen does, and every thread in a colour of its own.
Image shown(const ImageRow& row, const Surface& surface, const Image& image) {
  if (row.channels[0] == Channel::kThreadLow) return thread_thumbnail(image);
  if (row.channels[0] != Channel::kBaseR || row.srgb) return thumbnail(image);
  ImageRow encoded = row;
  encoded.srgb = true;
  return thumbnail(pack(encoded, surface));
}

/// The channels of both, of one size.
Image side_by_side(const Image& a, const Image& b) {
  Image out{a.width, a.height, a.channels + b.channels, {}};
  out.texels.reserve(a.texels.size() + b.texels.size());
  for (size_t i = 0; i < static_cast<size_t>(a.width) * static_cast<size_t>(a.height); ++i) {
    for (int c = 0; c < a.channels; ++c)
      out.texels.push_back(a.texels[i * static_cast<size_t>(a.channels) + static_cast<size_t>(c)]);
    for (int c = 0; c < b.channels; ++c)
      out.texels.push_back(b.texels[i * static_cast<size_t>(b.channels) + static_cast<size_t>(c)]);
  }
  return out;
}

void write_row(Writing& set, const ImageRow& row, const Surface& surface, const char* face,
               const std::string& face_suffix) {
  if (!set.problem.empty()) return;
  const std::string file = row.prefix + set.options.name + face_suffix + row.suffix + row.extension;
  const Image image = pack(row, surface);
  set.problem = write_image(set.folder + "/" + file, image, row.type, names_of(row));
  record(set, file, face, row.srgb ? "sRGB" : "linear", row.type, image, channel_list(row));
  set.sheet.push_back({std::string(row.suffix + 1) + face_suffix, shown(row, surface, image)});
}

/// Normals and roughness of every mip, made together, as one EXR.
void write_mips(Writing& set, const Surface& surface, const char* face, const std::string& face_suffix) {
  constexpr std::array kNormal{Channel::kNormalX, Channel::kNormalY, Channel::kNormalZ, Channel::kNone};
  constexpr std::array kRough{Channel::kRoughnessAlong, Channel::kRoughnessAcross, Channel::kNone, Channel::kNone};
  if (!set.problem.empty()) return;
  std::vector<Image> levels;
  Surface level = surface;
  while (true) {
    levels.push_back(side_by_side(pack({Target::kRaw, "", "", "", PixelType::kHalf, false, kNormal}, level),
                                  pack({Target::kRaw, "", "", "", PixelType::kHalf, false, kRough}, level)));
    if (level.texels.width == 1 && level.texels.height == 1) break;
    level = half_of(level);
  }
  const std::string file = set.options.name + face_suffix + "_mips.exr";
  std::vector<std::string> names;
  json channels;
  for (const Channel c : {kNormal[0], kNormal[1], kNormal[2], kRough[0], kRough[1]}) {
    names.emplace_back(exr_name(c));
    channels[names.back()] = channel_words(c);
  }
  set.problem = write_mipmapped_exr(set.folder + "/" + file, levels, PixelType::kHalf, names);
  record(set, file, face, "linear", PixelType::kHalf, levels[0], std::move(channels));
  set.maps.back()["mip_levels"] = levels.size();
}

void write_horizon(Writing& set, const std::vector<Plane<float>>& planes, const std::string& what, const char* face,
                   const std::string& face_suffix) {
  if (!set.problem.empty() || planes.empty()) return;
  const std::string file = set.options.name + face_suffix + "_horizon_" + what + ".exr";
  const Image image = pack_planes(planes);
  json channels = json::object();
  std::vector<std::string> names;
  for (int k = 0; k < image.channels; ++k) {
    char name[32];
    std::snprintf(name, sizeof name, "azimuth.%05.1f", 360.0 * k / image.channels);
    names.emplace_back(name);
    channels[name] = "sine of the horizon's elevation, " + what + ", towards this azimuth in degrees, from right to up";
  }
  set.problem = write_image(set.folder + "/" + file, image, PixelType::kHalf, names);
  record(set, file, face, "linear", PixelType::kHalf, image, std::move(channels));
  set.sheet.push_back({"horizon_" + what + face_suffix, thumbnail(image)});
}

void write_face(Writing& set, const Surface& surface, Face face) {
  const char* word = face == Face::kFront ? "front" : "back";
  const std::string suffix = set.options.target != Target::kRaw ? "" : face == Face::kFront ? "_front" : "_back";
  for (const ImageRow& row : image_rows(set.options.target)) write_row(set, row, surface, word, suffix);
  write_horizon(set, surface.horizon_mean, "mean", word, suffix);
  write_horizon(set, surface.horizon_spread, "spread", word, suffix);
  if (set.options.target == Target::kRaw) write_mips(set, surface, word, suffix);
}

std::string millimetres(float v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", static_cast<double>(v));
  return text;
}

std::string size_words(const Surface& s) { return millimetres(s.width_mm) + " x " + millimetres(s.depth_mm) + " mm"; }

std::string readme(const Surface& s, const TextureSetOptions& o) {
  return o.name + ": one seamless repeat of " + o.source + ", " + size_words(s) + " (" +
         std::to_string(s.texels.width) + " x " + std::to_string(s.texels.height) + " texels), for " +
         target_name(o.target) + ".\n" + "Tile it once every " + size_words(s) + "; normal maps are " +
         normal_convention(o.target) + "; end 1 is at the right, pick 1 at the top, as in the editor.\n" +
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

std::string list_of(const Writing& set, const Design& design, const Cloth& cloth, const Surface& s,
                    const std::string& material) {
  json root{{"format", "weftlight texture set"},
            {"format_version", 1},
            {"program", "weftlight " + set.options.program_version},
            {"source", set.options.source},
            {"draft", draft_from(set.place, set.options.draft_path)},
            {"title", design.title},
            {"name", set.options.name},
            {"target", target_name(set.options.target)},
            {"normal", normal_convention(set.options.target)},
            {"size_mm", {s.width_mm, s.depth_mm}},
            {"size_texels", {s.texels.width, s.texels.height}},
            {"repeat", {{"ends", cloth.ends.size()}, {"picks", cloth.picks.size()}}},
            {"alpha", has_gaps(s) ? "mask" : "opaque"},
            {"maps", set.maps}};
  if (!material.empty()) root["material"] = material;
  root["files"] = files_in(set.folder);
  return root.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

/// A title's bytes may be of any encoding; a picture's text takes the printable ones.
std::string printable(const std::string& text) {
  std::string out;
  for (char c : text) out += static_cast<unsigned char>(c) >= 32 ? c : ' ';
  return out;
}

void finish(Writing& set, const Design& design, const Cloth& cloth, const Surface& front, const std::string& material) {
  if (!set.problem.empty()) return;
  const std::string title = design.title.empty() ? set.options.name : printable(design.title);
  const std::string facts = std::string(target_name(set.options.target)) + "   " + size_words(front) + "   " +
                            std::to_string(cloth.ends.size()) + " ends x " + std::to_string(cloth.picks.size()) +
                            " picks   " + std::to_string(front.texels.width) + " x " +
                            std::to_string(front.texels.height) + " texels";
  set.problem =
      write_image(set.folder + "/contact_sheet.png", contact_sheet(title, facts, front, set.sheet), PixelType::kU8);
  if (set.problem.empty()) set.problem = write_file_atomically(set.folder + "/README.md", readme(front, set.options));
  if (set.problem.empty())
    set.problem = write_file_atomically(set.folder + "/texture_set.json", list_of(set, design, cloth, front, material));
}

/// Writes into `folder` what will stand in `place`.
std::string write_into(const std::string& folder, const std::string& place, const Design& design, const Mesh& mesh,
                       const TextureSetOptions& options) {
  const BitMatrix cells = drawdown(design.draft);
  if (cells.rows() < 1 || cells.cols() < 1) return "the draft has no cloth: it needs at least one end and one pick";
  const bool raw = options.target == Target::kRaw;
  Writing set{folder, place, options, json::array(), {}, {}};
  const Cloth cloth = lay_out(design, cells, Face::kFront, Period::kRepeat);
  const TextureSize size = texture_size(cloth.width_mm, cloth.depth_mm, options.size);
  const Surface front = surface_of(cloth, size, raw);
  write_face(set, front, Face::kFront);
  if (raw && set.problem.empty()) {
    write_face(set, surface_of(lay_out(design, cells, Face::kBack, Period::kRepeat), size, raw), Face::kBack);
  }
  MaterialFile material;
  if (set.problem.empty()) material = write_material(folder, options.name, options.target, front, mesh);
  if (set.problem.empty()) set.problem = material.error;
  finish(set, design, cloth, front, material.file);
  return set.problem;
}

SetIdentity identity_of(const fs::path& folder, const TextureSetOptions& options) {
  return {draft_from(folder, options.draft_path), options.source, target_name(options.target)};
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

TextureSize texture_size(float width_mm, float depth_mm, int size) {
  const float longer = std::max(width_mm, depth_mm);
  auto side = [&](float mm) {
    const double exact =
        static_cast<double>(size) * static_cast<double>(mm) / static_cast<double>(std::max(longer, 1e-6f));
    const double power = std::exp2(std::round(std::log2(std::max(exact, 1.0))));
    return std::clamp(static_cast<int>(power), std::min(kLeastSide, size), size);
  };
  return {side(width_mm), side(depth_mm)};
}

std::string who_is_there(const std::string& folder, const TextureSetOptions& options) {
  return in_the_way(folder, identity_of(folder, options));
}

std::string write_texture_set(const std::string& folder, const Design& design, const Mesh& mesh,
                              const TextureSetOptions& options) {
  std::string problem = options.force ? std::string{} : who_is_there(folder, options);
  if (!problem.empty()) return problem;
  const fs::path made = make_staging(folder, problem);
  if (!problem.empty()) return problem;
  try {
    problem = write_into(made.string(), folder, design, mesh, options);
  } catch (const std::bad_alloc&) {
    problem = "not enough memory; export a smaller --size";
  }
  if (problem.empty()) problem = put_in_place(made, folder, identity_of(folder, options), options.force);
  std::error_code ec;
  fs::remove_all(made, ec);
  return problem;
}

}  // namespace weftlight::texture_set
