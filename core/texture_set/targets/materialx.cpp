// MaterialX 1.39 with OpenPBR 1.1, and USD with the same images as UsdPreviewSurface; a second USD file references the
// .mtlx for renderers that support it.

#include <algorithm>
#include <cmath>

#include "base/mark.h"
#include "base/whole_files.h"
#include "files/zip.h"
#include "texture_set/material_files.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

using base::write_file_atomically;
using draft::Face;
using files::ZipEntry, files::ZipKind, files::write_zip;

namespace {

using enum Channel;
using enum PixelType;

constexpr ImageRow kImages[] = {
    {"", "_basecolor", ".png", kU8, true, kBaseColor},
    {"", "_opacity", ".png", kU8, false, only(kCoverage)},
    {"", "_roughness", ".png", kU8, false, only(kOpenPbrRoughness)},
    {"", "_metalness", ".png", kU8, false, only(kMetal)},
    {"", "_normal", ".png", kU8, false, kNormalUp},
    {"", "_anisotropy", ".png", kU8, false, only(kOpenPbrAnisotropy)},
    {"", "_turn", ".png", kU8, false, only(kWideAngle)},
    {"", "_fuzz", ".png", kU8, true, {kSheenR, kSheenG, kSheenB, kNone}},
    {"", "_occlusion", ".png", kU8, false, only(kOcclusion)},
    {"", "_height", ".exr", kHalf, false, only(kHeightMm)},
};

constexpr const char* kImageNode = R"(    <image name="{WHAT}" type="{TYPE}">
      <input name="file" type="filename" value="{FILE}"{SPACE} />
      <input name="texcoord" type="vector2" nodename="uv" />
    </image>
)";
// One face. Texture coordinates run right and up in the image.
constexpr const char* kGraph = R"(  <nodegraph name="NG_{NAME}">
    <texcoord name="uv_{UNIT}" type="vector2" />
    <multiply name="uv_scaled" type="vector2">
      <input name="in1" type="vector2" nodename="uv_{UNIT}" />
      <input name="in2" type="vector2" value="{SCALE_U}, {SCALE_V}" />
    </multiply>
    <add name="uv" type="vector2">
      <input name="in1" type="vector2" nodename="uv_scaled" />
      <input name="in2" type="vector2" value="{OFFSET_U}, {OFFSET_V}" />
    </add>
{IMAGES}    <normalmap name="normal" type="vector3">
      <input name="in" type="vector3" nodename="normal_image" />
    </normalmap>
    <multiply name="degrees" type="float">
      <input name="in1" type="float" nodename="turn" />
      <input name="in2" type="float" value="360" />
    </multiply>
    <tangent name="right" type="vector3">
      <input name="space" type="string" value="world" />
    </tangent>
    <rotate3d name="tangent" type="vector3">
      <input name="in" type="vector3" nodename="right" />
      <input name="amount" type="float" nodename="degrees" />
      <input name="axis" type="vector3" nodename="normal" />
    </rotate3d>
    <output name="basecolor_out" type="color3" nodename="basecolor" />
    <output name="roughness_out" type="float" nodename="roughness" />
    <output name="metalness_out" type="float" nodename="metalness" />
    <output name="anisotropy_out" type="float" nodename="anisotropy" />
    <output name="fuzz_out" type="color3" nodename="fuzz" />
    <output name="opacity_out" type="float" nodename="opacity" />
    <output name="normal_out" type="vector3" nodename="normal" />
    <output name="tangent_out" type="vector3" nodename="tangent" />
  </nodegraph>
  <open_pbr_surface name="SR_{NAME}" type="surfaceshader">
    <input name="base_color" type="color3" nodegraph="NG_{NAME}" output="basecolor_out" />
    <input name="base_metalness" type="float" nodegraph="NG_{NAME}" output="metalness_out" />
    <input name="specular_ior" type="float" value="{IOR}" />
    <input name="specular_roughness" type="float" nodegraph="NG_{NAME}" output="roughness_out" />
    <input name="specular_roughness_anisotropy" type="float" nodegraph="NG_{NAME}" output="anisotropy_out" />
    <input name="fuzz_weight" type="float" value="{FUZZ_WEIGHT}" />
    <input name="fuzz_color" type="color3" nodegraph="NG_{NAME}" output="fuzz_out" />
    <input name="fuzz_roughness" type="float" value="{FUZZ_ROUGHNESS}" />
{OPACITY_INPUT}    <input name="geometry_normal" type="vector3" nodegraph="NG_{NAME}" output="normal_out" />
    <input name="geometry_tangent" type="vector3" nodegraph="NG_{NAME}" output="tangent_out" />
    <input name="geometry_thin_walled" type="boolean" value="true" />
  </open_pbr_surface>
)";
constexpr const char* kOpacityInput =
    "    <input name=\"geometry_opacity\" type=\"float\" nodegraph=\"NG_{NAME}\" output=\"opacity_out\" />\n";
// Renderers that support backsurfaceshader show both faces with one material.
constexpr const char* kMaterials = R"(  <surfacematerial name="{NAME}" type="material">
    <input name="surfaceshader" type="surfaceshader" nodename="SR_{NAME}" />
    <input name="backsurfaceshader" type="surfaceshader" nodename="SR_{NAME}_back" />
  </surfacematerial>
  <surfacematerial name="{NAME}_back" type="material">
    <input name="surfaceshader" type="surfaceshader" nodename="SR_{NAME}_back" />
  </surfacematerial>
)";

constexpr const char* kStage = R"(#usda 1.0
(
    defaultPrim = "{PRIM}"
    metersPerUnit = 0.001
    upAxis = "Y"
    doc = "100 mm of cloth; texture coordinates are {UNITS}"
)

def Xform "{PRIM}"
{
{MESHES}
    def Scope "Materials"
    {
{MATERIALS}    }
}
)";

constexpr const char* kMesh = R"(    def Mesh "{FACE}" (
        prepend apiSchemas = ["MaterialBindingAPI"]
    )
    {
        uniform token subdivisionScheme = "none"
        uniform token orientation = "{ORIENTATION}"
        uniform bool doubleSided = 0
        float3[] extent = [(0, 0, 0), (100, 100, 0)]
        int[] faceVertexCounts = [4]
        int[] faceVertexIndices = [0, 1, 2, 3]
        point3f[] points = [(0, 0, 0), (100, 0, 0), (100, 100, 0), (0, 100, 0)]
        normal3f[] normals = [(0, 0, {Z}), (0, 0, {Z}), (0, 0, {Z}), (0, 0, {Z})] (
            interpolation = "vertex"
        )
        texCoord2f[] primvars:st = [({LEFT}, {LOW}), (0, {LOW}), (0, 0), ({LEFT}, 0)] (
            interpolation = "vertex"
        )
        rel material:binding = </{PRIM}/Materials/{MATERIAL}>
    }
)";

constexpr const char* kPreview = R"(        def Material "{MATERIAL}"
        {
            token outputs:surface.connect = </{PRIM}/Materials/{MATERIAL}/Surface.outputs:surface>

            def Shader "Surface"
            {
                uniform token info:id = "UsdPreviewSurface"
                color3f inputs:diffuseColor.connect = </{PRIM}/Materials/{MATERIAL}/basecolor.outputs:rgb>
                float inputs:roughness.connect = </{PRIM}/Materials/{MATERIAL}/roughness.outputs:r>
                float inputs:metallic.connect = </{PRIM}/Materials/{MATERIAL}/metalness.outputs:r>
                float inputs:occlusion.connect = </{PRIM}/Materials/{MATERIAL}/occlusion.outputs:r>
                normal3f inputs:normal.connect = </{PRIM}/Materials/{MATERIAL}/normal.outputs:rgb>
                float inputs:ior = {IOR}
{USD_OPACITY}                token outputs:surface
            }

            def Shader "st"
            {
                uniform token info:id = "UsdPrimvarReader_float2"
                string inputs:varname = "st"
                float2 outputs:result
            }

            def Shader "repeat"
            {
                uniform token info:id = "UsdTransform2d"
                float2 inputs:in.connect = </{PRIM}/Materials/{MATERIAL}/st.outputs:result>
                float2 inputs:scale = ({SCALE_U}, {SCALE_V})
                float2 inputs:translation = ({OFFSET_U}, {OFFSET_V})
                float2 outputs:result
            }
{TEXTURES}        }
)";

constexpr const char* kTexture = R"(
            def Shader "{WHAT}"
            {
                uniform token info:id = "UsdUVTexture"
                asset inputs:file = @{FILE}@
                token inputs:sourceColorSpace = "{SPACE}"
                token inputs:wrapS = "repeat"
                token inputs:wrapT = "repeat"
{RANGE}                float2 inputs:st.connect = </{PRIM}/Materials/{MATERIAL}/repeat.outputs:result>
                float3 outputs:rgb
                float outputs:r
            }
)";

using Values = std::vector<std::pair<std::string, std::string>>;

/// A valid USD name: no digit first, no '-'.
std::string prim_name(std::string name) {
  for (char& c : name) c = c == '-' ? '_' : c;
  return name.empty() || (name[0] >= '0' && name[0] <= '9') ? "_" + name : name;
}

/// Index of refraction for a reflectance at normal incidence.
double ior_of(double f0) { return (1 + std::sqrt(f0)) / (1 - std::sqrt(f0)); }

struct MtlxImage {
  const char* suffix;
  const char* what;
  const char* type;
  bool srgb;
};
constexpr MtlxImage kMtlxImages[] = {{"_basecolor", "basecolor", "color3", true},
                                     {"_roughness", "roughness", "float", false},
                                     {"_metalness", "metalness", "float", false},
                                     {"_anisotropy", "anisotropy", "float", false},
                                     {"_fuzz", "fuzz", "color3", true},
                                     {"_opacity", "opacity", "float", false},
                                     {"_normal", "normal_image", "vector3", false},
                                     {"_turn", "turn", "float", false}};

std::string mtlx_images(const SetFacts& set, Face face) {
  std::string text;
  for (const MtlxImage& image : kMtlxImages)
    text += fill_template(kImageNode, {{"WHAT", image.what},
                                       {"TYPE", image.type},
                                       {"FILE", image_named(set, image.suffix, face)},
                                       {"SPACE", image.srgb ? " colorspace=\"srgb_texture\"" : ""}});
  return text;
}

Values values_of(const SetFacts& set, Face face) {
  const FaceSource& source = set.of(face);
  const UvTransform uv = uv_transform(set);
  return {{"IMAGES", mtlx_images(set, face)},
          {"OPACITY_INPUT", set.alpha == Alpha::kOpaque ? "" : kOpacityInput},
          {"NAME", prim_name(material_name(set, face))},
          {"UNIT", uv_unit_name(set.uv.unit)},
          {"SCALE_U", number(uv.scale_u)},
          {"SCALE_V", number(uv.scale_v)},
          {"OFFSET_U", number(uv.offset_u)},
          {"OFFSET_V", number(uv.offset_v)},
          {"IOR", number(ior_of(static_cast<double>(source.fit().f0.g)))},
          {"FUZZ_WEIGHT", source.fit().has_sheen() ? "1" : "0"},
          {"FUZZ_ROUGHNESS", number(static_cast<double>(source.fit().sheen_roughness))}};
}

base::Result<void> write_mtlx(const SetFacts& set) {
  std::string text = "<?xml version=\"1.0\"?>\n<materialx version=\"1.39\" colorspace=\"lin_rec709\">\n";
  for (const Face face : {Face::kFront, Face::kBack}) text += fill_template(kGraph, values_of(set, face));
  text += fill_template(kMaterials, {{"NAME", prim_name(set.name)}});
  return write_file_atomically(set.folder + "/" + set.name + ".mtlx", text + "</materialx>\n");
}

struct UsdTexture {
  const char* suffix;
  const char* what;
  bool srgb, normal;
};
constexpr UsdTexture kUsdTextures[] = {
    {"_basecolor", "basecolor", true, false},  {"_roughness", "roughness", false, false},
    {"_metalness", "metalness", false, false}, {"_occlusion", "occlusion", false, false},
    {"_normal", "normal", false, true},        {"_opacity", "opacity", false, false}};
constexpr const char* kNormalRange =
    "                float4 inputs:scale = (2, 2, 2, 1)\n                float4 inputs:bias = (-1, -1, -1, 0)\n";

std::string usd_material(const SetFacts& set, Face face) {
  const std::string prim = prim_name(set.name), material = prim_name(material_name(set, face));
  std::string textures;
  for (const UsdTexture& t : kUsdTextures) {
    if (set.alpha == Alpha::kOpaque && std::string_view(t.what) == "opacity") continue;
    textures += fill_template(kTexture, {{"WHAT", t.what},
                                         {"FILE", image_named(set, t.suffix, face)},
                                         {"SPACE", t.srgb ? "sRGB" : "raw"},
                                         {"RANGE", t.normal ? kNormalRange : ""},
                                         {"PRIM", prim},
                                         {"MATERIAL", material}});
  }
  std::string opacity;
  if (set.alpha != Alpha::kOpaque) {
    opacity = "                float inputs:opacity.connect = </{PRIM}/Materials/{MATERIAL}/opacity.outputs:r>\n";
    if (set.alpha == Alpha::kMask) opacity += "                float inputs:opacityThreshold = 0.5\n";
  }
  const UvTransform uv = uv_transform(set);
  return fill_template(kPreview, {{"TEXTURES", textures},
                                  {"USD_OPACITY", opacity},
                                  {"IOR", number(ior_of(static_cast<double>(set.of(face).fit().f0.g)))},
                                  {"PRIM", prim},
                                  {"MATERIAL", material},
                                  {"SCALE_U", number(uv.scale_u)},
                                  {"SCALE_V", number(uv.scale_v)},
                                  {"OFFSET_U", number(uv.offset_u)},
                                  {"OFFSET_V", number(uv.offset_v)}});
}

std::string stage(const SetFacts& set) {
  const std::string prim = prim_name(set.name);
  const auto [across, up] = uv_per_mm(set);
  std::string meshes, materials;
  for (const Face face : {Face::kFront, Face::kBack}) {
    const bool back = face == Face::kBack;
    meshes += fill_template(kMesh, {{"FACE", back ? "Back" : "Front"},
                                    {"ORIENTATION", back ? "leftHanded" : "rightHanded"},
                                    {"Z", back ? "-1" : "1"},
                                    {"LEFT", number(-100 * across)},
                                    {"LOW", number(-100 * up)},
                                    {"PRIM", prim},
                                    {"MATERIAL", prim_name(material_name(set, face))}});
    materials += usd_material(set, face);
  }
  return fill_template(
      kStage, {{"MESHES", meshes}, {"MATERIALS", materials}, {"UNITS", uv_unit_title(set.uv.unit)}, {"PRIM", prim}});
}

/// The same stage with the materials of the .mtlx.
constexpr const char* kReferencing = R"(#usda 1.0
(
    defaultPrim = "{PRIM}"
    metersPerUnit = 0.001
    upAxis = "Y"
    subLayers = [@./{NAME}.usda@]
)

over "{PRIM}"
{
    def Scope "MaterialX" (
        prepend references = @./{NAME}.mtlx@</MaterialX>
    )
    {
    }

    over "Front"
    {
        rel material:binding = </{PRIM}/MaterialX/Materials/{PRIM}>
    }

    over "Back"
    {
        rel material:binding = </{PRIM}/MaterialX/Materials/{PRIM}_back>
    }
}
)";

base::Result<void> write_material(const SetFacts& set) {
  const std::string path = set.folder + "/" + set.name;
  base::Result<void> done = write_mtlx(set);
  if (done) done = write_file_atomically(path + ".usda", stage(set));
  if (done)
    done = write_file_atomically(path + "_openpbr.usda",
                                 fill_template(kReferencing, {{"PRIM", prim_name(set.name)}, {"NAME", set.name}}));
  if (!done) return done;
  std::vector<ZipEntry> entries{{set.name + ".usda", path + ".usda"}};
  for (const Face face : {Face::kFront, Face::kBack}) {
    for (const UsdTexture& t : kUsdTextures) {
      const std::string image = image_named(set, t.suffix, face);
      entries.push_back({image, set.folder + "/" + image});
    }
  }
  return write_zip(path + ".usdz", entries, ZipKind::kUsdz);
}

}  // namespace

const ExportTarget targets::kMaterialX{
    .id = "materialx",
    .title = base::mark("MaterialX, USD"),
    .images = kImages,
    .model = {.sheen = formulas::kSheenZeltner, .most_f0 = 0.25f, .grazing = false, .anisotropic = true, .planes = 20},
    .highlight = "OpenPBR, `specular_ior`",
    .sheen = "Zeltner 2022",
    .material = ".mtlx",
    .write_material = write_material,
    .embeds_images = true,
    .note = base::mark("Take {name}.mtlx where a program reads MaterialX (OpenPBR), and {name}_openpbr.usda for the "
                       "same on a USD stage. {name}.usda is for programs that know UsdPreviewSurface alone; "
                       "{name}.usdz is that with its images in one file."),
};

}  // namespace weftlight::texture_set
