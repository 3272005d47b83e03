#include "texture_set/material_files.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "base/hash.h"
#include "files/files.h"

namespace weftlight::texture_set {

using base::content_hash;
using cloth::Cloth, cloth::ThreadBody;
using design::Lobes;
using drape::Vec2, drape::compute_frames;
using files::MeshUv, files::MipFormat, files::extension_of, files::write_mesh;

namespace {

constexpr float kQuadMm = 100;

}  // namespace

std::string number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", v);
  return text;
}

std::string fill_template(std::string text, const std::vector<std::pair<std::string, std::string>>& values) {
  for (const auto& [key, value] : values) {
    const std::string mark = "{" + key + "}";
    for (size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size())) {
      text.replace(at, mark.size(), value);
    }
  }
  return text;
}

std::string face_suffix(const ExportTarget& target, Face face) { return face == Face::kBack ? "_back" : target.front; }

std::string image_file(const ExportTarget& target, const ImageRow& row, const std::string& name, Face face) {
  return row.prefix + name + face_suffix(target, face) + row.suffix + row.extension;
}

namespace {

const ImageRow* row_named(const SetFacts& set, const std::string& suffix) {
  const auto at = std::ranges::find_if(set.target.images,
                                       [&](const ImageRow& row) { return std::string_view(row.suffix) == suffix; });
  return at == set.target.images.end() ? nullptr : &*at;
}

}  // namespace

std::string image_named(const SetFacts& set, const std::string& suffix, Face face) {
  const ImageRow* const row = row_named(set, suffix);
  return row ? image_file(set.target, *row, set.name, face) : std::string{};
}

bool has_dds(const SetFacts& set, const ImageRow& row, Face face) {
  return set.target.names_dds && set.mips.format && is_dds(*set.mips.format) && has_mips(row, set.mips) &&
         !set.constants.contains(image_file(set.target, row, set.name, face));
}

std::string dds_file(const ExportTarget& target, const ImageRow& row, const std::string& name, Face face) {
  const std::string file = image_file(target, row, name, face);
  return file.substr(0, file.size() - std::string_view(row.extension).size()) + extension_of(MipFormat::kDds);
}

std::string mipped_image_named(const SetFacts& set, const std::string& suffix, Face face) {
  const ImageRow* const row = row_named(set, suffix);
  return row && has_dds(set, *row, face) ? dds_file(set.target, *row, set.name, face) : image_named(set, suffix, face);
}

std::vector<float> factors_of(const SetFacts& set, const std::string& suffix, Face face) {
  const ImageRow* const row = row_named(set, suffix);
  if (!row || !row->factor) return {};
  const auto at = set.constants.find(image_named(set, suffix, face));
  return at == set.constants.end() ? std::vector<float>{} : at->second;
}

std::string material_name(const SetFacts& set, Face face) { return set.name + (face == Face::kBack ? "_back" : ""); }

float mean_transmission(const SetFacts& set) {
  constexpr float kMin = 0.005f;
  const Cloth& cloth = set.front.cloth();
  float sum = 0;
  for (const auto* threads : {&cloth.ends, &cloth.picks}) {
    for (const ThreadBody& t : *threads) {
      const Lobes& lobes = cloth.yarns[static_cast<size_t>(t.yarn)].lobes;
      sum += lobes.metallic ? 0 : lobes.transmission;
    }
  }
  const float mean = sum / static_cast<float>(std::max<size_t>(cloth.ends.size() + cloth.picks.size(), 1));
  return mean < kMin ? 0 : std::min(mean, 1.0f);
}

std::string digest(const std::string& text) {
  std::string out;
  for (const uint64_t hash : {content_hash(text), content_hash(text, 7809847782465536322u)}) {
    char hex[17];
    std::snprintf(hex, sizeof hex, "%016llx", static_cast<unsigned long long>(hash));
    out += hex;
  }
  return out;
}

UvTransform uv_transform(const UvMapping& uv, float width_mm, float depth_mm) {
  constexpr std::array kMm{1.0, 10.0, 1000.0};
  const auto width = static_cast<double>(width_mm), depth = static_cast<double>(depth_mm);
  UvTransform out;
  if (uv.unit != UvUnit::kTile) {
    const double mm = kMm[static_cast<size_t>(uv.unit)];
    out.scale_u = mm / width, out.scale_v = mm / depth;
  }
  // Minus nothing would be written as -0.
  if (uv.right_mm != 0) out.offset_u = -static_cast<double>(uv.right_mm) / width;
  if (uv.up_mm != 0) out.offset_v = -static_cast<double>(uv.up_mm) / depth;
  return out;
}

UvTransform uv_transform(const SetFacts& set) {
  return uv_transform(set.uv, set.front.small().width_mm, set.front.small().depth_mm);
}

std::array<double, 2> uv_per_mm(const SetFacts& set) {
  const UvTransform to_repeats = uv_transform(set);
  const SurfaceTexels& s = set.front.small();
  return {1 / (to_repeats.scale_u * static_cast<double>(s.width_mm)),
          1 / (to_repeats.scale_v * static_cast<double>(s.depth_mm))};
}

Mesh mapped(const SetFacts& set, Mesh mesh) {
  if (set.uv.unit == UvUnit::kMm) return mesh;
  const auto [across, up] = uv_per_mm(set);
  for (Vec2& uv : mesh.uv_mm) uv = {uv[0] * static_cast<float>(across), uv[1] * static_cast<float>(up)};
  return mesh;
}

MeshUv mesh_uv(const SetFacts& set) {
  const UvTransform uv = uv_transform(set);
  return {set.uv.unit == UvUnit::kMm, static_cast<float>(uv.offset_u), static_cast<float>(0 - uv.offset_v)};
}

Mesh scale_quad() {
  Mesh mesh;
  mesh.name = "quad_100_mm";
  for (const Vec2 at : {Vec2{0, 0}, Vec2{kQuadMm, 0}, Vec2{kQuadMm, kQuadMm}, Vec2{0, kQuadMm}}) {
    mesh.position_mm.push_back({at[0], at[1], 0});
    mesh.uv_mm.push_back({kQuadMm - at[0], kQuadMm - at[1]});
  }
  mesh.index = {0, 1, 2, 0, 2, 3};
  compute_frames(mesh);
  return mesh;
}

base::Result<void> write_scale_quad(const SetFacts& set) {
  return write_mesh(set.folder + "/" + set.name + "_quad.glb", mapped(set, scale_quad()), nullptr, nullptr,
                    mesh_uv(set));
}

}  // namespace weftlight::texture_set
