#include "texture_set/targets/unity.h"

#include "base/whole_files.h"
#include "texture_set/recolour.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

using base::write_file_atomically;
using drape::Mesh, drape::Vec2, drape::Vec3;

namespace {

constexpr const char* kTextureMeta = R"(fileFormatVersion: 2
guid: {GUID}
TextureImporter:
  serializedVersion: 12
  mipmaps:
    mipMapMode: 1
    enableMipMap: {MIPS}
    sRGBTexture: {SRGB}
    mipMapsPreserveCoverage: {KEEP}
    alphaTestReferenceValue: 0.5
  textureSettings:
    serializedVersion: 2
    filterMode: {FILTER}
    aniso: 8
    wrapU: 0
    wrapV: 0
    wrapW: 0
  maxTextureSize: 8192
  textureType: {TYPE}
  textureShape: 1
  alphaUsage: 1
  alphaIsTransparency: 0
{PLATFORMS})";

constexpr const char* kUncompressed = R"(  platformSettings:
  - serializedVersion: 3
    buildTarget: DefaultTexturePlatform
    maxTextureSize: 8192
    textureFormat: -1
    textureCompression: 0
)";

constexpr const char* kDdsMeta = R"(fileFormatVersion: 2
guid: {GUID}
IHVImageFormatImporter:
  externalObjects: {}
  textureSettings:
    serializedVersion: 2
    filterMode: 2
    aniso: 8
    mipBias: 0
    wrapU: 0
    wrapV: 0
    wrapW: 0
  isReadable: 0
  sRGBTexture: {SRGB}
)";

constexpr const char* kMaterialMeta = R"(fileFormatVersion: 2
guid: {GUID}
NativeFormatImporter:
  mainObjectFileID: 2100000
)";

constexpr const char* kMaterial = R"(%YAML 1.1
%TAG !u! tag:unity3d.com,2011:
--- !u!21 &2100000
Material:
  serializedVersion: 8
  m_Name: {NAME}
  m_Shader: {fileID: 4800000, guid: {SHADER}, type: 3}
  m_ValidKeywords:
{KEYWORDS}  m_DoubleSidedGI: 0
  m_CustomRenderQueue: {QUEUE}
  stringTagMap:
    RenderType: {TYPE}
  m_SavedProperties:
    serializedVersion: 3
    m_TexEnvs:
{TEXTURES}    m_Floats:
{FLOATS}    m_Colors:
    - _BaseColor: {r: 1, g: 1, b: 1, a: 1}
    - _Color: {r: 1, g: 1, b: 1, a: 1}
{COLORS})";

std::string guid(const std::string& file) { return digest("weftlight unity " + file); }

std::string lines(const std::vector<std::string>& all) {
  std::string out;
  for (const std::string& line : all) out += "    - " + line + "\n";
  return out;
}

/// How the importer is to read an image.
struct Import {
  bool srgb = false, keep_coverage = false, normal = false;
  bool exact = false;  // as it is: not filtered, not compressed
};

base::Result<void> write_texture_meta(const SetFacts& set, const std::string& file, const Import& as) {
  const auto flag = [](bool on) { return on ? "1" : "0"; };
  return write_file_atomically(set.folder + "/" + file + ".meta",
                               fill_template(kTextureMeta, {{"GUID", guid(file)},
                                                            {"SRGB", flag(as.srgb)},
                                                            {"KEEP", flag(as.keep_coverage)},
                                                            {"TYPE", flag(as.normal)},
                                                            {"MIPS", flag(!as.exact)},
                                                            {"FILTER", as.exact ? "0" : "2"},
                                                            {"PLATFORMS", as.exact ? kUncompressed : ""}}));
}

base::Result<void> write_recolour_settings(const SetFacts& set, Face face) {
  if (!set.masks) return {};
  for (const RecolourImage& image : recolour_images(colors_of(set.design, set.of(face).cloth()).size())) {
    const std::string file = recolour_file(set.target, image, set.name, face);
    base::Result<void> done = write_texture_meta(set, file, {.srgb = image.srgb, .exact = image.exact});
    if (!done) return done;
  }
  return {};
}

base::Result<void> write_import_settings(const SetFacts& set, Face face) {
  for (const ImageRow& row : set.target.images) {
    const std::string file = image_file(set.target, row, set.name, face);
    const bool normal = std::string_view(row.suffix).starts_with("_Normal");
    const bool covers = row.channels[3] == Channel::kCoverage && set.alpha == Alpha::kMask;
    base::Result<void> done =
        write_texture_meta(set, file, {.srgb = row.srgb, .keep_coverage = covers, .normal = normal});
    if (done && has_dds(set, row, face)) {
      const std::string dds = dds_file(set.target, row, set.name, face);
      done = write_file_atomically(set.folder + "/" + dds + ".meta",
                                   fill_template(kDdsMeta, {{"GUID", guid(dds)}, {"SRGB", row.srgb ? "1" : "0"}}));
    }
    if (!done) return done;
  }
  return write_recolour_settings(set, face);
}

/// The texture of each slot, scaled to repeats.
std::vector<std::string> textures_of(const SetFacts& set, const UnityShader& shader, Face face) {
  const UvTransform uv = uv_transform(set);
  std::vector<std::string> out;
  for (const UnitySlot& slot : shader.slots) {
    out.push_back(std::string(slot.slot) +
                  ":\n        m_Texture: {fileID: 2800000, guid: " + guid(mipped_image_named(set, slot.suffix, face)) +
                  ", type: 3}\n        m_Scale: {x: " + number(uv.scale_u) + ", y: " + number(uv.scale_v) +
                  "}\n        m_Offset: {x: " + number(uv.offset_u) + ", y: " + number(uv.offset_v) + "}");
  }
  return out;
}

std::string keywords_of(const SetFacts& set, const UnityShader& shader, Face face) {
  std::vector<std::string> words = shader.keywords(set, face);
  if (cuts_out(set.alpha)) words.emplace_back("_ALPHATEST_ON");
  if (set.alpha == Alpha::kBlend) words.emplace_back("_SURFACE_TYPE_TRANSPARENT");
  std::string out;
  for (const std::string& w : words) out += "  - " + w + "\n";
  return out;
}

base::Result<void> write_face(const SetFacts& set, const UnityShader& shader, Face face) {
  if (base::Result<void> done = write_import_settings(set, face); !done) return done;
  const std::string name = material_name(set, face), file = name + ".mat";
  base::Result<void> done = write_file_atomically(
      set.folder + "/" + file, fill_template(kMaterial, {{"NAME", name},
                                                         {"SHADER", shader.guid},
                                                         {"KEYWORDS", keywords_of(set, shader, face)},
                                                         {"QUEUE", set.alpha == Alpha::kBlend    ? "3000"
                                                                   : set.alpha == Alpha::kOpaque ? "-1"
                                                                                                 : "2450"},
                                                         {"TYPE", set.alpha == Alpha::kBlend    ? "Transparent"
                                                                  : set.alpha == Alpha::kOpaque ? "Opaque"
                                                                                                : "TransparentCutout"},
                                                         {"TEXTURES", lines(textures_of(set, shader, face))},
                                                         {"FLOATS", lines(shader.floats(set, face))},
                                                         {"COLORS", lines(shader.colors(set, face))}}));
  if (!done) return done;
  return write_file_atomically(set.folder + "/" + file + ".meta", fill_template(kMaterialMeta, {{"GUID", guid(file)}}));
}

/// The quad as .obj, since Unity cannot read glTF without a package: metres, texture coordinates in the set's unit.
base::Result<void> write_obj_quad(const SetFacts& set) {
  const Mesh quad = mapped(set, scale_quad());
  std::string text = std::string("# 100 mm a side; texture coordinates in ") + uv_unit_title(set.uv.unit) + "\n";
  for (const Vec3& p : quad.position_mm)
    text += "v " + number(static_cast<double>(p[0]) / 1000) + " " + number(static_cast<double>(p[1]) / 1000) + " 0\n";
  for (const Vec2& t : quad.uv_mm)
    text += "vt " + number(-static_cast<double>(t[0])) + " " + number(-static_cast<double>(t[1])) + "\n";
  return write_file_atomically(set.folder + "/" + set.name + "_quad.obj",
                               text + "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n");
}

}  // namespace

bool cuts_out(Alpha alpha) { return alpha == Alpha::kMask || alpha == Alpha::kHashed; }

base::Result<void> write_unity_material(const SetFacts& set, const UnityShader& shader) {
  for (const Face face : {Face::kFront, Face::kBack}) {
    if (base::Result<void> done = write_face(set, shader, face); !done) return done;
  }
  return write_obj_quad(set);
}

}  // namespace weftlight::texture_set
