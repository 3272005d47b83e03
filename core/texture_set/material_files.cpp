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
using files::MipContainer, files::extension_of, files::write_mesh;

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
  return set.target.names_dds && set.mips.container == MipContainer::kDds && has_mips(row, set.mips) &&
         !set.constants.contains(image_file(set.target, row, set.name, face));
}

std::string dds_file(const ExportTarget& target, const ImageRow& row, const std::string& name, Face face) {
  const std::string file = image_file(target, row, name, face);
  return file.substr(0, file.size() - std::string_view(row.extension).size()) + extension_of(MipContainer::kDds);
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
  return write_mesh(set.folder + "/" + set.name + "_quad.glb", scale_quad(), nullptr);
}

}  // namespace weftlight::texture_set
