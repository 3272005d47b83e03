// Writes a mesh with its material as glTF 2.0: a .glb, or a .gltf with files beside it.
//
// Texture coordinates are in millimetres, (-u, v): those of glTF point right and down in the image, and images show the
// cloth like the editor, with end 1 at the right and pick 1 at the top (core/draft/draft.h). The material scales
// millimetres to repeats by KHR_texture_transform.

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <glm/glm.hpp>
#include <limits>
#include <map>

#include "base/file_names.h"
#include "base/json.h"
#include "base/text.h"
#include "base/whole_files.h"
#include "files/files.h"
#include "files/mesh_uv.h"
#include "platform/file.h"

namespace weftlight::files {

using base::ErrorKind, base::Result, base::cause_of, base::failure, base::tr, base::write_file_atomically,
    base::write_through;
using drape::Mesh, drape::Vec2, drape::Vec3;

namespace {

using nlohmann::json;
using Bytes = std::vector<unsigned char>;

constexpr float kMetresPerMm = 0.001f;
constexpr int kFloat = 5126, kUint = 5125;                   // glTF component types
constexpr int kArrayBuffer = 34962, kElementBuffer = 34963;  // and buffer view targets
constexpr uint32_t kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;

/// An image in the buffer, after the mesh. It is read when it is written, since all together could be large.
struct EmbeddedImage {
  const GltfImage* image = nullptr;
  size_t offset = 0, bytes = 0;
};

struct Document {
  json root;
  Bytes binary;  // of the only buffer, without its images
  std::vector<EmbeddedImage> embedded;
  bool embed = true;                                 // images inside the buffer; false: as files
  std::vector<std::pair<std::string, Bytes>> files;  // written beside a .gltf
  std::string stem, folder;
  MeshUv uv;
  std::map<std::string, int> textures;  // by image file, shared between faces and uses
  Result<void> images;                  // whether all were read
};

void append_u32(Bytes& bytes, uint32_t v) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<unsigned char>(v >> shift));
}

void pad(Bytes& bytes, unsigned char fill) {
  while (bytes.size() % 4) bytes.push_back(fill);
}

int add_view(Document& doc, const void* data, size_t size, int target) {
  assert(doc.embedded.empty());
  pad(doc.binary, 0);
  json view{{"buffer", 0}, {"byteOffset", doc.binary.size()}, {"byteLength", size}};
  if (target) view["target"] = target;
  const auto* bytes = static_cast<const unsigned char*>(data);
  doc.binary.insert(doc.binary.end(), bytes, bytes + size);
  doc.root["bufferViews"].push_back(std::move(view));
  return static_cast<int>(doc.root["bufferViews"].size()) - 1;
}

template <class Vector>
int add_vectors(Document& doc, const std::vector<Vector>& values, bool bounds) {
  constexpr int N = Vector::length();
  json accessor{{"bufferView", add_view(doc, values.data(), values.size() * sizeof values[0], kArrayBuffer)},
                {"componentType", kFloat},
                {"count", values.size()},
                {"type", "VEC" + std::to_string(N)}};
  if (bounds) {
    Vector low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
    for (const Vector& v : values) low = glm::min(low, v), high = glm::max(high, v);
    for (int k = 0; k < N; ++k) accessor["min"].push_back(low[k]), accessor["max"].push_back(high[k]);
  }
  doc.root["accessors"].push_back(std::move(accessor));
  return static_cast<int>(doc.root["accessors"].size()) - 1;
}

/// The unit vector, or `otherwise` for a vector without direction: glTF requires unit length.
Vec3 unit_or(const Vec3& v, const Vec3& otherwise) {
  const float length = glm::length(v);
  if (!(length > 1e-12f) || !std::isfinite(length)) return otherwise;
  return v / length;
}

/// The triangles without those that use a vertex twice, which have no area.
std::vector<uint32_t> proper_triangles(const Mesh& mesh) {
  std::vector<uint32_t> index;
  index.reserve(mesh.index.size());
  for (size_t t = 0; t + 2 < mesh.index.size(); t += 3) {
    const uint32_t a = mesh.index[t], b = mesh.index[t + 1], c = mesh.index[t + 2];
    if (a != b && b != c && c != a) index.insert(index.end(), {a, b, c});
  }
  return index;
}

/// Normals and tangents of one side. The back has opposite normals and the same bitangent.
json add_frame(Document& doc, const Mesh& mesh, bool tangents, bool back) {
  const float side = back ? -1.0f : 1.0f;
  std::vector<Vec3> normal(mesh.normal);
  for (Vec3& n : normal) {
    n = unit_or(n, {0, 1, 0}) * side;
  }
  json attributes{{"NORMAL", add_vectors(doc, normal, false)}};
  if (!tangents) return attributes;
  std::vector<glm::vec4> tangent(mesh.tangent.size());
  for (size_t i = 0; i < tangent.size(); ++i) {
    const Vec3& n = normal[i];
    const Vec3 any = unit_or(glm::cross(n, std::abs(n[0]) < 0.9f ? Vec3{1, 0, 0} : Vec3{0, 1, 0}), {1, 0, 0});
    const Vec3 t = unit_or(mesh.tangent[i], any);
    tangent[i] = {-t[0], -t[1], -t[2], side};  // points right in the image; normal x tangent points up
  }
  attributes["TANGENT"] = add_vectors(doc, tangent, false);
  return attributes;
}

int add_index(Document& doc, std::vector<uint32_t> index, bool back) {
  for (size_t t = 0; back && t + 2 < index.size(); t += 3) std::swap(index[t + 1], index[t + 2]);
  doc.root["accessors"].push_back(
      {{"bufferView", add_view(doc, index.data(), index.size() * sizeof index[0], kElementBuffer)},
       {"componentType", kUint},
       {"count", index.size()},
       {"type", "SCALAR"}});
  return static_cast<int>(doc.root["accessors"].size()) - 1;
}

constexpr float kThicknessMm =
    0.1f;  // gap between front and back: path tracers do not cull, so coincident sides would shadow each other

void add_mesh(Document& doc, const Mesh& mesh, const GltfMaterial* front, const GltfMaterial* back) {
  std::vector<Vec3> position(mesh.position_mm);
  std::vector<Vec2> uv(mesh.uv_mm);
  for (Vec3& p : position) p *= kMetresPerMm;
  for (Vec2& t : uv) t[0] = -t[0];
  const int fronts = add_vectors(doc, position, true), uvs = add_vectors(doc, uv, false);
  for (size_t i = 0; back && i < position.size(); ++i)
    position[i] -= unit_or(mesh.normal[i], {0, 1, 0}) * (kThicknessMm * kMetresPerMm);
  const int backs = back ? add_vectors(doc, position, true) : fronts;
  const std::vector<uint32_t> index = proper_triangles(mesh);
  json primitives = json::array();
  // Programs blend surfaces without depth in file order: the far side must come first.
  const bool far_first = back && front->alpha == GltfAlpha::kBlend;
  for (const bool is_back : {far_first, !far_first}) {
    if (is_back && !back) break;
    const GltfMaterial* material = is_back ? back : front;
    json attributes = add_frame(doc, mesh, material && !material->normal.empty(), is_back);
    attributes["POSITION"] = is_back ? backs : fronts, attributes["TEXCOORD_0"] = uvs;
    json primitive{{"attributes", std::move(attributes)}, {"indices", add_index(doc, index, is_back)}};
    if (material) primitive["material"] = is_back ? 1 : 0;
    primitives.push_back(std::move(primitive));
  }
  const std::string name = mesh.name.empty() ? "cloth" : mesh.name;
  doc.root["meshes"] = json::array({{{"name", name}, {"primitives", std::move(primitives)}}});
  doc.root["nodes"] = json::array({{{"name", name}, {"mesh", 0}}});
  doc.root["scenes"] = json::array({{{"nodes", {0}}}});
  doc.root["scene"] = 0;
}

size_t padded(size_t size) { return (size + 3) / 4 * 4; }

size_t buffer_size(const Document& doc) {
  return padded(doc.embedded.empty() ? doc.binary.size() : doc.embedded.back().offset + doc.embedded.back().bytes);
}

/// A buffer view of the image.
int embed(Document& doc, const GltfImage& image) {
  std::error_code ec;
  size_t bytes = image.png.size();
  if (!image.file.empty()) {
    const uintmax_t size = std::filesystem::file_size(std::filesystem::path(doc.folder) / image.file, ec);
    bytes = ec ? 0 : static_cast<size_t>(size);
  }
  if (bytes == 0) doc.images = failure(ErrorKind::kInput, tr("cannot be read"), image.file);
  doc.embedded.push_back({&image, buffer_size(doc), bytes});
  doc.root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", doc.embedded.back().offset}, {"byteLength", bytes}});
  return static_cast<int>(doc.root["bufferViews"].size()) - 1;
}

int add_image(Document& doc, const GltfMaterial& material, const std::string& what, const GltfImage& image) {
  json entry{{"name", what}};
  if (doc.embed) {
    entry["mimeType"] = "image/png";
    entry["bufferView"] = embed(doc, image);
  } else if (!image.file.empty()) {
    entry["uri"] = image.file;
  } else {
    entry["uri"] = material.name + "_" + what + ".png";
    doc.files.emplace_back(material.name + "_" + what + ".png", image.png);
  }
  doc.root["images"].push_back(std::move(entry));
  doc.root["textures"].push_back({{"source", doc.root["images"].size() - 1}, {"sampler", 0}});
  return static_cast<int>(doc.root["textures"].size()) - 1;
}

/// A textureInfo with the transform of the texture coordinates.
json add_texture(Document& doc, const GltfMaterial& material, const std::string& what, const GltfImage& image) {
  const std::string key = image.file.empty() ? material.name + "/" + what : image.file;
  const auto [at, fresh] = doc.textures.try_emplace(key, 0);
  if (fresh) at->second = add_image(doc, material, what, image);
  json transform{{"scale", {material.uv_scale_u, material.uv_scale_v}}};
  if (doc.uv.offset_u != 0 || doc.uv.offset_v != 0) transform["offset"] = {doc.uv.offset_u, doc.uv.offset_v};
  return {{"index", at->second}, {"extensions", {{"KHR_texture_transform", std::move(transform)}}}};
}

constexpr float kUsualIor = 1.5f, kUsualF0 = 0.04f;  // index of refraction, and its reflectance

bool has_sheen(const GltfMaterial& m) { return m.sheen_color.r > 0 || m.sheen_color.g > 0 || m.sheen_color.b > 0; }

json sheen_extension(Document& doc, const GltfMaterial& m) {
  json sheen{{"sheenColorFactor", {m.sheen_color.r, m.sheen_color.g, m.sheen_color.b}},
             {"sheenRoughnessFactor", m.sheen_roughness}};
  if (!m.sheen.empty()) {
    sheen["sheenColorTexture"] = add_texture(doc, m, "sheen", m.sheen);
    sheen["sheenRoughnessTexture"] = sheen["sheenColorTexture"];
  }
  return sheen;
}

json anisotropy_extension(Document& doc, const GltfMaterial& m) {
  json anisotropy{{"anisotropyStrength", m.anisotropy_strength}, {"anisotropyRotation", m.anisotropy_rotation}};
  if (!m.anisotropy.empty()) anisotropy["anisotropyTexture"] = add_texture(doc, m, "anisotropy", m.anisotropy);
  return anisotropy;
}

/// Transmitted light has the diffuse colour.
json transmission_extension(Document& doc, const GltfMaterial& m) {
  json out{{"diffuseTransmissionFactor", m.transmission}};
  if (!m.base_color.empty()) out["diffuseTransmissionColorTexture"] = add_texture(doc, m, "basecolor", m.base_color);
  return out;
}

/// Reflectances at normal and grazing incidence by KHR_materials_specular and KHR_materials_ior. The factor is the one
/// at grazing incidence. The one at normal incidence is at most a fraction of it: up to the usual by a darker colour,
/// beyond by the index of refraction, since programs clamp a colour beyond 1.
struct Specular {
  float factor = 1, ior = kUsualIor;
  Linear colour{1, 1, 1};
};
Specular specular_of(const GltfMaterial& m) {
  constexpr float kMaxRatio = 0.99f;  // an index of 398
  Specular out;
  const float most = std::max({m.f0.r, m.f0.g, m.f0.b});
  out.factor = std::clamp(std::max(m.f90, most), 1e-3f, 1.0f);
  const float ratio = std::clamp(most / out.factor, 0.0f, kMaxRatio), amplitude = std::sqrt(ratio);
  const float full = std::max(ratio, kUsualF0);  // reflectance of a colour of 1
  if (ratio > kUsualF0) out.ior = (1 + amplitude) / (1 - amplitude);
  const auto colour = [&](float f0) { return std::clamp(f0 / out.factor / full, 0.0f, 1.0f); };
  out.colour = {colour(m.f0.r), colour(m.f0.g), colour(m.f0.b)};
  return out;
}

/// The glTF default, which needs no extension.
bool usual_reflectance(const GltfMaterial& m) {
  return m.f0.r == kUsualF0 && m.f0.g == kUsualF0 && m.f0.b == kUsualF0 && m.f90 == 1;
}

void use(Document& doc, const char* extension) {
  json& used = doc.root["extensionsUsed"];
  if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
}

void extend(Document& doc, json& material, const char* extension, json values) {
  material["extensions"][extension] = std::move(values);
  use(doc, extension);
}

json material_of(Document& doc, const GltfMaterial& m, bool double_sided) {
  json pbr{{"metallicFactor", m.orm.empty() ? 0.0 : 1.0}};
  json material{{"name", m.name}, {"doubleSided", double_sided}};
  if (!m.base_color.empty()) pbr["baseColorTexture"] = add_texture(doc, m, "basecolor", m.base_color);
  if (!m.orm.empty()) {
    pbr["metallicRoughnessTexture"] = add_texture(doc, m, "orm", m.orm);
    material["occlusionTexture"] = pbr["metallicRoughnessTexture"];
  }
  material["pbrMetallicRoughness"] = std::move(pbr);
  if (!m.normal.empty()) material["normalTexture"] = add_texture(doc, m, "normal", m.normal);
  if (m.alpha != GltfAlpha::kOpaque) material["alphaMode"] = m.alpha == GltfAlpha::kMask ? "MASK" : "BLEND";
  if (has_sheen(m)) extend(doc, material, "KHR_materials_sheen", sheen_extension(doc, m));
  const Specular s = specular_of(m);
  if (!usual_reflectance(m))
    extend(doc, material, "KHR_materials_specular",
           {{"specularFactor", s.factor}, {"specularColorFactor", {s.colour.r, s.colour.g, s.colour.b}}});
  if (s.ior != kUsualIor) extend(doc, material, "KHR_materials_ior", {{"ior", s.ior}});
  if (m.anisotropy_strength > 0) extend(doc, material, "KHR_materials_anisotropy", anisotropy_extension(doc, m));
  if (m.transmission > 0) extend(doc, material, "KHR_materials_diffuse_transmission", transmission_extension(doc, m));
  return material;
}

void add_materials(Document& doc, const GltfMaterial& front, const GltfMaterial* back) {
  doc.root["materials"] = json::array({material_of(doc, front, back == nullptr)});
  if (back) doc.root["materials"].push_back(material_of(doc, *back, false));
  if (!doc.root.contains("textures")) return;
  doc.root["samplers"] = json::array({{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 10497}, {"wrapT", 10497}}});
  use(doc, "KHR_texture_transform");
}

Result<void> check_mesh(const Mesh& mesh, const std::string& path) {
  const auto refused = [&](const char* why) { return failure(ErrorKind::kOutput, why, path); };
  const size_t n = mesh.position_mm.size();
  if (mesh.normal.size() != n || mesh.uv_mm.size() != n || mesh.tangent.size() != n) {
    return refused(tr("the mesh lacks normals, tangents or texture coordinates"));
  }
  if (proper_triangles(mesh).empty()) return refused(tr("the mesh has no triangles"));
  for (uint32_t i : mesh.index) {
    if (i >= n) return refused(tr("the mesh refers to a missing vertex"));
  }
  return {};
}

std::string_view text_of(const Bytes& bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

bool put(std::FILE* file, const void* data, size_t size) { return std::fwrite(data, 1, size, file) == size; }

/// The image, from the file in `folder` if it has one, and zeros to a multiple of four bytes.
bool put_image(std::FILE* file, const EmbeddedImage& embedded, const std::string& folder) {
  const GltfImage& image = *embedded.image;
  size_t written = 0;
  if (image.file.empty()) {
    if (!put(file, image.png.data(), image.png.size())) return false;
    written = image.png.size();
  } else {
    std::ifstream in(std::filesystem::path(folder) / image.file, std::ios::binary);
    std::vector<char> part(1 << 18);
    while (in.read(part.data(), static_cast<std::streamsize>(part.size())), in.gcount() > 0) {
      if (!put(file, part.data(), static_cast<size_t>(in.gcount()))) return false;
      written += static_cast<size_t>(in.gcount());
    }
  }
  constexpr std::array<unsigned char, 4> kZeros{};
  return written == embedded.bytes && put(file, kZeros.data(), padded(written) - written);
}

Result<void> write_glb(const std::string& path, Document& doc) {
  pad(doc.binary, 0);
  const size_t buffer = buffer_size(doc);
  doc.root["buffers"] = json::array({{{"byteLength", buffer}}});
  const std::string text = doc.root.dump();
  Bytes start{'g', 'l', 'T', 'F'}, head(text.begin(), text.end());
  pad(head, ' ');
  const uint64_t total = 12 + 8 + head.size() + 8 + buffer;
  if (total > std::numeric_limits<uint32_t>::max())
    return failure(ErrorKind::kOutput, tr("a .glb cannot be larger than 4 GB; export smaller textures"), path);
  for (uint32_t v : {uint32_t{2}, static_cast<uint32_t>(total), static_cast<uint32_t>(head.size()), kJsonChunk}) {
    append_u32(start, v);
  }
  start.insert(start.end(), head.begin(), head.end());
  append_u32(start, static_cast<uint32_t>(buffer));
  append_u32(start, kBinChunk);
  return write_through(path, [&](const std::string& beside) {
    std::FILE* file = platform::open_stream(beside, "wb");
    bool whole = file && put(file, start.data(), start.size()) && put(file, doc.binary.data(), doc.binary.size());
    for (const EmbeddedImage& image : doc.embedded) whole = whole && put_image(file, image, doc.folder);
    const int error = errno;
    whole = file && std::fclose(file) == 0 && whole;
    return base::written_unless(whole ? std::string{} : cause_of(error != 0 ? error : EIO));
  });
}

/// Writes the other files first, so that the .gltf never refers to a missing file.
Result<void> write_gltf(const std::string& path, Document& doc) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  doc.root["buffers"] = json::array({{{"byteLength", doc.binary.size()}, {"uri", doc.stem + ".bin"}}});
  doc.files.emplace_back(doc.stem + ".bin", std::move(doc.binary));
  for (const auto& [name, bytes] : doc.files) {
    if (Result<void> file = write_file_atomically((folder / name).string(), text_of(bytes)); !file) return file;
  }
  return write_file_atomically(path, doc.root.dump(1) + "\n");
}

}  // namespace

Result<void> write_mesh(const std::string& path, const Mesh& mesh, const GltfMaterial* front,
                        const GltfMaterial* back) {
  return write_mesh(path, mesh, front, back, MeshUv{});
}

Result<void> write_mesh(const std::string& path, const Mesh& mesh, const GltfMaterial* front, const GltfMaterial* back,
                        const MeshUv& uv) {
  if (Result<void> whole = check_mesh(mesh, path); !whole) return whole;
  const std::filesystem::path target(path);
  Document doc;
  doc.embed = base::extension_of(path) != ".gltf";
  doc.stem = target.stem().string();
  doc.folder = target.parent_path().string();
  doc.uv = uv;
  doc.root["asset"] = {{"version", "2.0"}, {"generator", "Weftlight"}};
  if (uv.millimetres) doc.root["asset"]["extras"] = {{"weftlight_uv_mm", true}};
  add_mesh(doc, mesh, front, back);
  if (front) add_materials(doc, *front, back);
  if (!doc.images) return doc.images;
  try {
    return doc.embed ? write_glb(path, doc) : write_gltf(path, doc);
  } catch (const json::exception& e) {  // a name that is not UTF-8
    return failure(ErrorKind::kOutput, e.what(), path);
  }
}

}  // namespace weftlight::files
