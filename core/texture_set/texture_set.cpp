#include "texture_set/texture_set.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/hash.h"
#include "base/json.h"
#include "base/loops.h"
#include "base/text.h"
#include "base/utf8.h"
#include "base/whole_files.h"
#include "base/words.h"
#include "cloth/cloth.h"
#include "draft/drawdown.h"
#include "platform/file.h"
#include "platform/removed_at_end.h"
#include "texture_set/contact_sheet.h"
#include "texture_set/material_files.h"
#include "texture_set/recolour.h"
#include "texture_set/set_folder.h"
#include "texture_set/set_images.h"

namespace weftlight::texture_set {

using base::arg, base::fill, base::tr, base::tr_n, base::write_file_atomically;
using cloth::ThreadBody;
using design::Yarn;
using draft::BitMatrix, draft::drawdown;
using files::MipFormat, files::PixelType, files::is_dds, files::write_image;
using light::EngineCheck, light::EngineFit, light::EngineScore, light::kFootprintMmAtOneMetre;

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr float kMinTexelsPerThread = 2;
constexpr float kOpenCover = 0.9f;  // cover below which gaps are visible
constexpr int kMinSize = 16, kMaxSize = 8192;
constexpr int kDenseTileSize = 2048;  // most texels for which a tile is made larger than one repeat unasked

std::string rounded(float v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", static_cast<double>(v));
  return text;
}

std::string size_text(const SurfaceTexels& s) { return rounded(s.width_mm) + " x " + rounded(s.depth_mm) + " mm"; }

std::string readme_of_tile(const FaceSource& face, const TextureSetOptions& o) {
  const std::string size = size_text(face.small());
  const ExportTarget& target = *o.target;
  if (!*target.material || target.sized_material)
    return fill(tr("Tile it once every {size}; normal maps are {normal}; end 1 is at the right, pick 1 at the top."),
                arg("size", size), arg("normal", target.normal));
  return fill(tr("Tile it once every {size} (the materials take texture coordinates in {unit}); normal maps are "
                 "{normal}; end 1 is at the right, pick 1 at the top."),
              arg("size", size), arg("normal", target.normal), arg("unit", tr(uv_unit_title(o.uv.unit))));
}

std::string readme_of_mips(const ExportTarget& target, MipFormat format) {
  if (!is_dds(format)) return tr("The .ktx2 files are the same images with mipmaps, for programs that read them.");
  return target.names_dds ? tr("A .dds is the image of the same name with mipmaps; the material uses it.")
                          : tr("The .dds files are the same images with mipmaps, for programs that read them.");
}

/// Lines on what this set has and others do not.
std::vector<std::string> readme_extras(const TextureSetOptions& o) {
  std::vector<std::string> out;
  const MipChoice mips = mips_for(*o.target, o.mips);
  if (std::ranges::any_of(o.target->images, [&](const ImageRow& row) { return has_mips(row, mips); }))
    out.push_back(readme_of_mips(*o.target, *mips.format));
  if (o.masks)
    out.emplace_back(
        tr("The images that end in _white, _threads, _index and _shares are for recolouring the cloth; `recolour` in "
           "texture_set.json lists the colours and has the formula."));
  if (o.detail != ThreadDetail::kAll)
    out.push_back(fill(tr("This is level of detail {level}: it has the tile of level 0, whose set is another, and "
                          "takes its place on what is further away."),
                       arg("level", static_cast<int>(o.detail))));
  return out;
}

std::string readme(const FaceSource& face, const TextureSetOptions& o) {
  std::vector<std::string> lines{
      fill(tr("{name}: one seamless tile of {source}, {size} ({width} x {height} texels), for {target}; files with "
              "_back show the other face."),
           arg("name", o.name), arg("source", o.source), arg("size", size_text(face.small())),
           arg("width", face.size().width), arg("height", face.size().height),
           arg("target", std::string(tr(o.target->title))))};
  if (*o.target->note) lines.push_back(fill(tr(o.target->note), arg("name", o.name)));
  lines.push_back(readme_of_tile(face, o));
  for (std::string& line : readme_extras(o)) lines.push_back(std::move(line));
  lines.emplace_back(
      tr("texture_set.json lists every image, its channels and its colour space; contact_sheet.png shows them."));
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}

/// The files of the set, without its list.
std::vector<std::string> files_in(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> out = platform::names_in(folder, error);
  if (error) throw fs::filesystem_error("files of a set", folder, error);
  std::erase_if(out, [](const std::string& name) { return name.starts_with('.'); });
  std::sort(out.begin(), out.end());
  return out;
}

json numbers(const glm::vec3& v) { return {v.x, v.y, v.z}; }

/// Radiance of a flat piece by directions in the image (x right, y up, z out), for checks in engines.
json checks_json(const FaceSource& face) {
  json out = json::array();
  const glm::vec3 turned(-1, -1, 1);
  for (const EngineCheck& c : face.checks())
    out.push_back({{"view", numbers(c.view * turned)},
                   {"light", numbers(c.light * turned)},
                   {"cloth", numbers(c.cloth)},
                   {"engine", numbers(c.engine)}});
  return out;
}

/// Error of the material by the elevation of the view.
json scores_json(const std::vector<EngineScore>& scores) {
  json out = json::array();
  for (const EngineScore& s : scores)
    out.push_back({{"view_deg", s.view_deg}, {"mean", s.mean}, {"rms_error", s.error}});
  return out;
}

json fit_json(const FaceSource& face) {
  const EngineFit& f = face.fit();
  return {{"base_color", {f.base.r, f.base.g, f.base.b}},
          {"reflectance", {{"normal", numbers(f.f0)}, {"grazing", f.f90}}},
          {"highlight", {{"along", f.lobe.fibre.x}, {"across", f.lobe.fibre.y}, {"weft", f.lobe.weft}}},
          {"relief", {f.relief.x, f.relief.y}},
          {"view_tint",
           {{"weft", numbers(f.tint.weft)},
            {"warp", numbers(f.tint.warp)},
            {"late_weft", numbers(f.tint.late_weft)},
            {"late_warp", numbers(f.tint.late_warp)},
            {"shine", {f.tint.shine.x, f.tint.shine.y}}}},
          {"sheen", numbers(f.sheen)},
          {"sheen_roughness", f.sheen_roughness},
          {"rms_error", f.error},
          {"views", scores_json(face.scores())},
          {"planes", {{"warp", scores_json(face.plane_scores()[0])}, {"weft", scores_json(face.plane_scores()[1])}}},
          {"radiance", checks_json(face)}};
}

/// Repeats of the tile at texture coordinates: coordinate x scale + offset, right and up in the image.
json uv_json(const SetFacts& set) {
  const UvTransform uv = uv_transform(set);
  return {{"scale", {uv.scale_u, uv.scale_v}}, {"offset", {uv.offset_u, uv.offset_v}}};
}

std::string set_json(const SetImages& images, const SetFacts& set, const TextureSetOptions& options,
                     const SetIdentity& identity) {
  const SurfaceTexels& s = set.front.small();
  const Cloth& cloth = set.front.cloth();
  json root{{"format", "weftlight texture set"},
            {"format_version", 3},
            {"program", "weftlight " + options.program_version},
            {"source", identity.source},
            {"draft", identity.draft},
            {"title", set.design.title},
            {"name", set.name},
            {"target", identity.target},
            {"normal", set.target.normal},
            {"orientation", "end 1 right, pick 1 top"},
            {"texture_coordinates", uv_unit_title(options.uv.unit)},
            {"uv", uv_json(set)},
            {"size_mm", {s.width_mm, s.depth_mm}},
            {"size_texels", {set.front.size().width, set.front.size().height}},
            {"repeat", {{"ends", cloth.ends.size()}, {"picks", cloth.picks.size()}}},
            {"repeats_in_tile", {set.front.tile().across, set.front.tile().up}},
            {"alpha", alpha_name(set.alpha)},
            {"coverage", set.front.coverage()},
            {"distance_m", options.distance_m},
            {"lod", static_cast<int>(options.detail)},
            {"fit", {{"front", fit_json(set.front)}, {"back", fit_json(set.back)}}},
            {"maps", images.maps}};
  if (!images.factors.empty()) root["factors"] = images.factors;
  if (options.masks) root["recolour"] = recolour_json(colors_of(set.design, cloth), images);
  if (*set.target.material) root["material"] = set.name + set.target.material;
  if (!options.key.empty()) root["key"] = options.key;
  if (options.archived) root["archived"] = true;
  const std::vector<std::string> files = files_in(set.folder);
  for (const std::string& file : files) {
    const FileContents contents = contents_of(fs::path(set.folder) / file);
    root["contents"][file] = {{"bytes", contents.bytes}, {"fnv1a", contents.hash}};
  }
  root["files"] = files;
  return root.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

/// The title without control characters.
std::string printable(const std::string& text) {
  std::string out;
  for (char c : text) out += static_cast<unsigned char>(c) >= 32 ? c : ' ';
  return out;
}

base::Result<void> write_sheet(const SetImages& images, const SetFacts& set) {
  const std::string title = set.design.title.empty() ? set.name : printable(set.design.title);
  const Cloth& cloth = set.front.cloth();
  const std::string facts = fill(tr("{target}   {size}   {ends} ends x {picks} picks   {width} x {height} texels"),
                                 arg("target", set.target.id), arg("size", size_text(set.front.small())),
                                 arg("ends", cloth.ends.size()), arg("picks", cloth.picks.size()),
                                 arg("width", set.front.size().width), arg("height", set.front.size().height));
  return write_image(set.folder + "/contact_sheet.png", contact_sheet(title, facts, images.swatch, images.sheet),
                     PixelType::kU8);
}

SetIdentity identity_of(const fs::path& folder, const TextureSetOptions& options) {
  return {draft_from(folder, options.draft_path), options.source, options.target->id};
}

Tile tile_of(const Design& design, const BitMatrix& cells, Face face, const TextureSetOptions& options) {
  return make_tile(design, cells, face, options.tile_mm, options.tile_size > 0 ? options.tile_size : options.size);
}

/// Estimate of the fraction of the plane that is covered, for straight threads.
float estimated_cover(const Cloth& cloth) {
  const auto cover = [](const std::vector<ThreadBody>& threads, float mm) {
    float sum = 0;
    for (const ThreadBody& t : threads) sum += t.width_mm;
    return std::min(sum / std::max(mm, 1e-6f), 1.0f);
  };
  return 1 - (1 - cover(cloth.ends, cloth.width_mm)) * (1 - cover(cloth.picks, cloth.depth_mm));
}

bool has_metal(const Cloth& cloth) {
  return std::any_of(cloth.yarns.begin(), cloth.yarns.end(), [](const Yarn& y) { return y.lobes.metallic; });
}

FaceSource face_of(const Design& design, const BitMatrix& cells, Face face, const TextureSetOptions& options,
                   const std::optional<EngineFit>& near = {}, const MeasuredLight& light = {}) {
  Tile tile = tile_of(design, cells, face, options);
  const Cloth& cloth = tile.cloth;
  const ExportTarget& target = *options.target;
  FaceOptions of;
  of.size = texture_size(cloth.width_mm, cloth.depth_mm, options.size);
  of.horizon = target.raw, of.fitted = !target.raw;
  of.detail = options.detail;
  of.model = engine_model(target, has_metal(cloth)), of.older = target.older_model, of.near = near;
  of.light = light;
  of.footprint_mm = target.raw || target.path_traced ? 0 : kFootprintMmAtOneMetre * options.distance_m;
  return {std::move(tile), of};
}

/// The set that this one is a level of detail of.
TextureSetOptions finest_of(TextureSetOptions options) {
  options.distance_m /= static_cast<float>(1 << static_cast<int>(options.detail));
  options.size = options.tile_size, options.tile_size = 0;
  options.detail = ThreadDetail::kAll;
  return options;
}

/// What the fits of a level's faces stay beside, made here unless they are known; without target for a set that is the
/// finest, whose back stays beside its front.
FinestFits neighbours_of(const Design& design, const BitMatrix& cells, const TextureSetOptions& options,
                         const FinestFits& known = {}) {
  if (options.target->raw || options.detail == ThreadDetail::kAll) return {};
  if (known.target == options.target) return known;
  const TextureSetOptions finest = finest_of(options);
  const EngineFit front = face_of(design, cells, Face::kFront, finest).fit();
  return {options.target, front, face_of(design, cells, Face::kBack, finest, front).fit()};
}

std::optional<EngineFit> beside_front(const FinestFits& near) {
  return near.target ? std::optional(near.front) : std::nullopt;
}

/// What the levels of detail of this set may stay beside without fits of their own (finest_of). Those of a set without
/// a footprint are beside one that is seen from 1 m (at_lod).
FinestFits left_for_levels(const FaceSource& front, const FaceSource& back, const TextureSetOptions& options) {
  if (options.distance_m <= 0) return {};
  return {options.target, front.fit(), back.fit()};
}

/// Whether images of the set need the image library, which a PNG does not.
bool needs_library(const ExportTarget& target) {
  const auto is_png = [](const ImageRow& row) { return std::string_view(row.extension) == ".png"; };
  return target.raw || !std::ranges::all_of(target.images, is_png);
}

/// The front, while the image library is loaded on another core if it is needed.
FaceSource first_face(const Design& design, const BitMatrix& cells, const TextureSetOptions& options,
                      const std::optional<EngineFit>& near, const MeasuredLight& light) {
  std::optional<FaceSource> front;
  base::for_each_job(needs_library(*options.target) ? 2 : 1, [&](int job) {
    if (job == 0) front.emplace(face_of(design, cells, Face::kFront, options, near, light));
    else files::load_pictures();
  });
  return std::move(*front);
}

// Estimated fractions of the work: after a face is measured, and after its images are written.
constexpr float kMeasured = 0.1f, kFaceDone = 0.45f;

/// Reports the progress of a face; false if the export was stopped.
std::function<bool(float)> face_progress(const ExportProgress& progress, float from) {
  return [&progress, from](float fraction) {
    if (progress.report) progress.report(from + kMeasured + fraction * (kFaceDone - kMeasured));
    return !progress.stop.stop_requested();
  };
}

/// All that needs the texels of a face, which are released.
base::Result<void> write_images(SetImages& images, FaceSource& source, const Design& design, Face face,
                                const TextureSetOptions& options) {
  base::Result<void> done = write_face(images, source, face);
  if (done && options.masks) done = write_recolour_images(images, source, colors_of(design, source.cloth()), face);
  const bool is_front = face == Face::kFront;
  if (done && is_front) images.swatch = sheet_swatch(source.small());
  if (done && images.target.embedded != nullptr) images.embedded[is_front ? 0 : 1] = images.target.embedded(source);
  source.release();
  return done;
}

/// Writes the set into `folder`, which is later moved to `destination`.
base::Result<void> write_into(const std::string& folder, const std::string& destination, const Design& design,
                              const Mesh& mesh, const TextureSetOptions& options, const ExportProgress& progress,
                              SharedWork& shared) {
  const BitMatrix cells = drawdown(design.draft);
  if (cells.rows() < 1 || cells.cols() < 1)
    return base::failure(base::ErrorKind::kInput, tr("the draft has no cloth; it needs at least one end and one pick"));
  const FinestFits near = neighbours_of(design, cells, options, shared.finest);
  auto& [front_light, back_light] = shared.light[static_cast<size_t>(options.detail)];
  FaceSource front = first_face(design, cells, options, beside_front(near), front_light);
  front_light = front.light();
  SetImages images{folder,
                   options.name,
                   *options.target,
                   json::array(),
                   {},
                   face_progress(progress, 0),
                   mips_for(*options.target, options.mips),
                   options.alpha};
  if (base::Result<void> written = write_images(images, front, design, Face::kFront, options); !written) return written;
  FaceSource back = face_of(design, cells, Face::kBack, options, near.target ? near.back : front.fit(), back_light);
  back_light = back.light();
  shared.finest = options.detail == ThreadDetail::kAll ? left_for_levels(front, back, options) : near;
  images.keep_going = face_progress(progress, kFaceDone);
  if (base::Result<void> written = write_images(images, back, design, Face::kBack, options); !written) return written;
  const SetFacts set{folder,
                     options.name,
                     *options.target,
                     alpha_for(*options.target, options.alpha, front.coverage()),
                     options.modified,
                     design,
                     front,
                     back,
                     mesh,
                     images.constants,
                     images.embedded,
                     images.mips,
                     options.uv,
                     options.masks};
  base::Result<void> done = set.target.write_material ? set.target.write_material(set) : base::Result<void>();
  if (progress.stop.stop_requested()) return stopped();
  if (done) done = write_sheet(images, set);
  if (done) done = write_file_atomically(folder + "/README.md", readme(front, options));
  if (done)
    done = write_file_atomically(folder + "/texture_set.json",
                                 set_json(images, set, options, identity_of(destination, options)));
  return done;
}

bool is_plain(uint32_t code) {
  return (code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z') || (code >= '0' && code <= '9') || code == '-' ||
         code == '_';
}

/// Some systems write a letter and its mark as two.
bool is_combining_mark(uint32_t code) { return code >= 0x300 && code < 0x370; }

/// Of a script without plain_latin(), and neither punctuation nor a symbol.
bool is_foreign_letter(uint32_t code) {
  const bool sign = code < 0x180 || (code >= 0x2000 && code < 0x2C00) || (code >= 0x3000 && code < 0x3004);
  return !sign && !is_combining_mark(code);
}

struct AsciiName {
  std::string text;
  bool whole = true;  // no letter was left out
};

/// Engines, USD before 24.03 and archives are sure of ASCII alone.
AsciiName ascii_name(std::string_view text) {
  AsciiName out;
  while (!text.empty()) {
    uint32_t code = 0;
    const size_t size = base::utf8_sequence(text, code);
    text.remove_prefix(std::max<size_t>(size, 1));
    if (size == 0) code = 0;
    if (is_combining_mark(code)) continue;
    const std::string letters = is_plain(code) ? std::string(1, static_cast<char>(code)) : base::plain_latin(code);
    out.text += letters;
    if (!letters.empty()) continue;
    if (is_foreign_letter(code)) out.whole = false;
    if (!out.text.empty() && out.text.back() != '_') out.text += '_';
  }
  while (!out.text.empty() && out.text.back() == '_') out.text.pop_back();
  return out;
}

/// Windows has no file of such a name, whatever its extension.
bool is_device_name(std::string_view name) {
  using base::same_word;
  const bool port = name.size() == 4 && name[3] >= '1' && name[3] <= '9';
  if (port) return same_word(name.substr(0, 3), "com") || same_word(name.substr(0, 3), "lpt");
  return same_word(name, "con") || same_word(name, "prn") || same_word(name, "aux") || same_word(name, "nul");
}

/// Along the side that has fewer.
float texels_per_mm_of(const Cloth& cloth, int size) {
  const TextureSize of = texture_size(cloth.width_mm, cloth.depth_mm, size);
  return std::min(static_cast<float>(of.width) / cloth.width_mm, static_cast<float>(of.height) / cloth.depth_mm);
}

std::string short_hash(std::string_view text) {
  char digits[7];
  std::snprintf(digits, sizeof digits, "%06x", static_cast<unsigned>(base::content_hash(text) & 0xFFFFFFu));
  return digits;
}

}  // namespace

std::string file_name_of(const std::string& text) {
  constexpr size_t kLongest = 90;
  const AsciiName name = ascii_name(text);
  std::string out = name.text.empty() ? "cloth" : name.text.substr(0, kLongest);
  if (is_device_name(out)) out.insert(0, "cloth_");
  if (!name.whole) out += "_" + short_hash(text);
  return out;
}

TextureSetOptions at_lod(TextureSetOptions options, int lod) {
  if (lod == 0) return options;
  const int further = 1 << lod;
  options.name += "-lod" + std::to_string(lod);
  options.detail = static_cast<ThreadDetail>(lod);
  options.tile_size = options.size;
  options.size = std::max(options.size / (further * further), kMinSize);
  options.distance_m = (options.distance_m > 0 ? options.distance_m : 1.0f) * static_cast<float>(further);
  return options;
}

std::string key_of(const TextureSetOptions& o) {
  return o.program_version + " " + o.target->id + " " + o.name + " " + std::to_string(o.size) + " " +
         alpha_name(o.alpha) + " " + number(static_cast<double>(o.distance_m)) + " " +
         number(static_cast<double>(o.tile_mm)) + (o.mips ? std::string(" ") + name_of(*o.mips) : "") +
         (o.masks ? " masks" : "") +
         (o.detail == ThreadDetail::kAll ? "" : " lod " + std::to_string(static_cast<int>(o.detail))) +
         (o.uv.unit == UvUnit::kMm && o.uv.right_mm == 0 && o.uv.up_mm == 0
              ? ""
              : std::string(" uv ") + uv_unit_name(o.uv.unit) + " " + number(static_cast<double>(o.uv.right_mm)) + " " +
                    number(static_cast<double>(o.uv.up_mm)));
}

void set_density(TextureSetOptions& options, const Design& design, float texels_per_mm) {
  const BitMatrix cells = drawdown(design.draft);
  if (cells.rows() < 1 || cells.cols() < 1) return;
  options.texels_per_mm = texels_per_mm;
  if (options.tile_mm < 0) {
    const Cloth repeat = make_tile(design, cells, Face::kFront, 0, kMinSize).cloth;
    const float room_mm =
        static_cast<float>(kDenseTileSize) / texels_per_mm - std::max(repeat.width_mm, repeat.depth_mm);
    options.tile_mm = std::clamp(room_mm, 0.0f, tile_mm_for(repeat, kMaxSize));
  }
  const Cloth cloth = make_tile(design, cells, Face::kFront, options.tile_mm, kMaxSize).cloth;
  options.size = kMinSize;
  while (options.size < kMaxSize && texels_per_mm_of(cloth, options.size) < texels_per_mm) options.size *= 2;
}

SetFigures figures_of(const Design& design, const TextureSetOptions& options) {
  const BitMatrix cells = drawdown(design.draft);
  if (cells.rows() < 1 || cells.cols() < 1) return {};
  const Cloth cloth = tile_of(design, cells, Face::kFront, options).cloth;
  SetFigures out{cloth.width_mm,
                 cloth.depth_mm,
                 cloth.ends.size(),
                 cloth.picks.size(),
                 texture_size(cloth.width_mm, cloth.depth_mm, options.size),
                 0,
                 0};
  const int64_t texels = int64_t{out.size.width} * out.size.height;
  for (const ImageRow& row : options.target->images) {
    // Graphics cards store one, two or four channels.
    const int channels = channels_of(row), held = channels == 3 ? 4 : channels;
    const auto format = mip_format_of(row, mips_for(*options.target, options.mips));
    const int64_t bytes = format && has_blocks(*format) ? (channels == 1 ? texels / 2 : texels)
                                                        : texels * held * (row.type == PixelType::kU8 ? 1 : 2);
    out.images += 2;
    out.texel_bytes += 2 * bytes * 4 / 3;
  }
  return out;
}

FaceSource face_at(const Design& design, Face face, const TextureSetOptions& options, int side) {
  const BitMatrix cells = drawdown(design.draft);
  TextureSetOptions small = options;
  small.size = std::min(options.size, side);
  if (options.tile_mm < 0)
    small.tile_mm = tile_mm_for(make_tile(design, cells, face, 0, options.size).cloth, options.size);
  const FinestFits near = neighbours_of(design, cells, small);
  if (face == Face::kFront) return face_of(design, cells, face, small, beside_front(near));
  return face_of(design, cells, face, small,
                 near.target ? near.back : face_of(design, cells, Face::kFront, small).fit());
}

namespace {

/// Mipmaps that keep the coverage of a mask: the program's, or ours where its materials name them.
bool keeps_masks(const ExportTarget& target, const std::optional<MipFormat>& requested) {
  const MipChoice mips = mips_for(target, requested);
  return target.keeps_masks || (target.names_dds && mips.format && is_dds(*mips.format));
}

}  // namespace

std::vector<std::string> warnings_of(const Design& design, const TextureSetOptions& options) {
  const BitMatrix cells = drawdown(design.draft);
  if (cells.rows() < 1 || cells.cols() < 1) return {};
  const Cloth cloth = tile_of(design, cells, Face::kFront, options).cloth;
  const TextureSize size = texture_size(cloth.width_mm, cloth.depth_mm, options.size);
  const float each = std::min(static_cast<float>(size.width) / static_cast<float>(cloth.ends.size()),
                              static_cast<float>(size.height) / static_cast<float>(cloth.picks.size()));
  std::vector<std::string> out;
  const float per_mm = texels_per_mm_of(cloth, options.size);
  if (per_mm < options.texels_per_mm && options.detail == ThreadDetail::kAll)
    out.push_back(fill(tr("at {size}, the largest size, this tile has {density} texels/mm, and {wanted} were asked "
                          "for; make the tile smaller"),
                       arg("size", kMaxSize), arg("density", rounded(per_mm)),
                       arg("wanted", rounded(options.texels_per_mm))));
  else if (each < kMinTexelsPerThread && options.detail == ThreadDetail::kAll)
    out.push_back(fill(
        tr_n("a thread has only {texels} texel; give a larger --size or a smaller tile to see threads",
             "a thread has only {texels} texels; give a larger --size or a smaller tile to see threads", rounded(each)),
        arg("texels", rounded(each))));
  if (options.alpha == Alpha::kMask && !keeps_masks(*options.target, options.mips) &&
      estimated_cover(cloth) < kOpenCover)
    out.push_back(fill(tr("{target}: the gaps of a mask close in the distance, since the program makes the mipmaps; "
                          "use {options}"),
                       arg("target", options.target->id),
                       arg("options", options.target->names_dds ? "--alpha auto, --mips dds" : "--alpha auto")));
  return out;
}

base::Result<void> check_set_folder(const std::string& folder, const TextureSetOptions& options) {
  return check_place(folder, identity_of(folder, options));
}

base::Result<void> write_texture_set(const std::string& folder, const Design& design, const Mesh& mesh,
                                     const TextureSetOptions& options, const ExportProgress& progress,
                                     SharedWork* shared) {
  SharedWork own;
  SharedWork& work = shared ? *shared : own;
  if (options.detail == ThreadDetail::kAll) work.finest = {};
  const SetIdentity identity = identity_of(folder, options);
  base::Result<void> done = options.force ? base::Result<void>() : check_place_with_remedy(folder, identity);
  if (!done) return done;
  base::Result<Staging> staging = make_staging(folder);
  if (!staging) return failed(staging);
  const platform::RemovedAtEnd removed(std::move(staging->name));
  try {
    done = write_into(staging->folder.string(), folder, design, mesh, options, progress, work);
  } catch (const std::bad_alloc&) {
    done = base::failure(base::ErrorKind::kMemory, tr("not enough memory; export with a smaller --size"));
  } catch (...) {
    done = base::thrown(base::ErrorKind::kOutput);
  }
  if (done) done = put_in_place(std::move(*staging), folder, identity, options.force);
  return done;
}

}  // namespace weftlight::texture_set
