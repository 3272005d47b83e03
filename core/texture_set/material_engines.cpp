// Material files for Godot 4 and Unity 2021 and later, and an import script for Unreal 5.

#include <cmath>
#include <cstdio>

#include "base/files.h"
#include "cloth/srgb.h"
#include "texture_set/material_files.h"
#include "texture_set/set_images.h"

namespace weftlight::texture_set {
namespace {

constexpr const char* kGodotMaterial = R"([gd_resource type="ORMMaterial3D" load_steps={STEPS} format=3]

[ext_resource type="Texture2D" path="{ALBEDO}" id="1"]
[ext_resource type="Texture2D" path="{ORM}" id="2"]
[ext_resource type="Texture2D" path="{NORMAL}" id="3"]
[ext_resource type="Texture2D" path="{FLOW}" id="4"]
{BACK}
[resource]
resource_name = "{NAME}"
transparency = {TRANSPARENCY}
alpha_scissor_threshold = 0.5
cull_mode = {CULL}
albedo_texture = ExtResource("1")
orm_texture = ExtResource("2")
metallic_specular = {SPECULAR}
normal_enabled = true
normal_texture = ExtResource("3")
anisotropy_enabled = true
anisotropy = 1.0
anisotropy_flowmap = ExtResource("4")
uv1_scale = Vector3({SCALE_U}, {SCALE_V}, 1)
{NEXT})";

constexpr const char* kUnrealScript =
    R"("""Imports this set into Unreal Engine 5 and makes its materials: run it from the editor's Python console
(Python Editor Script Plugin), or Tools > Execute Python Script. Texture coordinates are in millimetres, as in
{NAME}_quad.glb. For a mesh on which one UV unit is one repeat of {WIDTH_MM} x {DEPTH_MM} mm, set MM_UV = False."""
import os
import unreal

NAME = "{NAME}"
SIZE_MM = ({WIDTH_MM}, {DEPTH_MM})
MM_UV = True
ALPHA = "{ALPHA}"
INTO = "/Game/Weftlight/" + NAME
FOLDER = os.path.dirname(os.path.abspath(__file__))
COMPRESSION = unreal.TextureCompressionSettings
KINDS = {  # suffix: (sRGB, compression)
    "_BC": (True, COMPRESSION.TC_DEFAULT),
    "_N": (False, COMPRESSION.TC_NORMALMAP),
    "_ORM": (False, COMPRESSION.TC_MASKS),
    "_OM": (False, COMPRESSION.TC_ALPHA),
    "_FC": (True, COMPRESSION.TC_DEFAULT),
    "_CW": (False, COMPRESSION.TC_ALPHA),
}
lib = unreal.MaterialEditingLibrary


def texture(side, kind):
    srgb, compression = KINDS[kind]
    task = unreal.AssetImportTask()
    task.filename = os.path.join(FOLDER, "T_" + NAME + side + kind + ".png")
    task.destination_path, task.automated, task.replace_existing, task.save = INTO, True, True, True
    unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks([task])
    asset = unreal.load_asset(INTO + "/T_" + NAME + side + kind)
    asset.set_editor_property("srgb", srgb)
    asset.set_editor_property("compression_settings", compression)
    if kind == "_OM":  # keeps the coverage in every mip level
        asset.set_editor_property("alpha_coverage_thresholds", unreal.Vector4(0, 0, 0, 0.5))
    unreal.EditorAssetLibrary.save_loaded_asset(asset)
    return asset


def material(side, specular):
    asset = "M_" + NAME + side
    if unreal.EditorAssetLibrary.does_asset_exist(INTO + "/" + asset):  # from an earlier import: meshes keep their reference
        made = unreal.load_asset(INTO + "/" + asset)
        lib.delete_all_material_expressions(made)
    else:
        made = unreal.AssetToolsHelpers.get_asset_tools().create_asset(
            asset, INTO, unreal.Material, unreal.MaterialFactoryNew())
    made.set_editor_property("shading_model", unreal.MaterialShadingModel.MSM_CLOTH)
    made.set_editor_property("two_sided", False)
    if ALPHA == "blend":
        made.set_editor_property("blend_mode", unreal.BlendMode.BLEND_TRANSLUCENT)
    elif ALPHA != "opaque":
        made.set_editor_property("blend_mode", unreal.BlendMode.BLEND_MASKED)
        made.set_editor_property("dither_opacity_mask", ALPHA == "hashed")
    place = lib.create_material_expression(made, unreal.MaterialExpressionTextureCoordinate, -800, 0)
    place.set_editor_property("u_tiling", 1 / SIZE_MM[0] if MM_UV else 1)
    place.set_editor_property("v_tiling", 1 / SIZE_MM[1] if MM_UV else 1)

    def sample(kind, row):
        node = lib.create_material_expression(made, unreal.MaterialExpressionTextureSample, -500, 250 * row)
        node.set_editor_property("texture", texture(side, kind))
        sampler = {"_N": unreal.MaterialSamplerType.SAMPLERTYPE_NORMAL,
                   "_ORM": unreal.MaterialSamplerType.SAMPLERTYPE_MASKS,
                   "_OM": unreal.MaterialSamplerType.SAMPLERTYPE_ALPHA,
                   "_CW": unreal.MaterialSamplerType.SAMPLERTYPE_ALPHA}
        node.set_editor_property("sampler_type", sampler.get(kind, unreal.MaterialSamplerType.SAMPLERTYPE_COLOR))
        lib.connect_material_expressions(place, "", node, "UVs")
        return node

    slot = unreal.MaterialProperty
    lib.connect_material_property(sample("_BC", 0), "RGB", slot.MP_BASE_COLOR)
    lib.connect_material_property(sample("_N", 1), "RGB", slot.MP_NORMAL)
    orm = sample("_ORM", 2)
    for channel, property in (("R", slot.MP_AMBIENT_OCCLUSION), ("G", slot.MP_ROUGHNESS), ("B", slot.MP_METALLIC)):
        lib.connect_material_property(orm, channel, property)
    if ALPHA != "opaque":
        lib.connect_material_property(sample("_OM", 3), "A", slot.MP_OPACITY if ALPHA == "blend" else slot.MP_OPACITY_MASK)
    lib.connect_material_property(sample("_FC", 4), "RGB", slot.MP_SUBSURFACE_COLOR)  # fuzz colour: the hue
    lib.connect_material_property(sample("_CW", 5), "A", slot.MP_CUSTOM_DATA0)        # cloth: the weight
    shine = lib.create_material_expression(made, unreal.MaterialExpressionConstant, -500, 1500)
    shine.set_editor_property("r", specular)
    lib.connect_material_property(shine, "", slot.MP_SPECULAR)
    lib.recompile_material(made)
    unreal.EditorAssetLibrary.save_loaded_asset(made)


material("", {SPECULAR})
material("_back", {BACK_SPECULAR})
)";

constexpr const char* kUnityTexture = R"(fileFormatVersion: 2
guid: {GUID}
TextureImporter:
  serializedVersion: 12
  mipmaps:
    mipMapMode: 1
    enableMipMap: 1
    sRGBTexture: {SRGB}
    mipMapsPreserveCoverage: {KEEP}
    alphaTestReferenceValue: 0.5
  textureSettings:
    serializedVersion: 2
    filterMode: 2
    aniso: 8
    wrapU: 0
    wrapV: 0
    wrapW: 0
  maxTextureSize: 8192
  textureType: {TYPE}
  textureShape: 1
  alphaUsage: 1
  alphaIsTransparency: 0
)";

constexpr const char* kUnityMaterialMeta = R"(fileFormatVersion: 2
guid: {GUID}
NativeFormatImporter:
  mainObjectFileID: 2100000
)";

constexpr const char* kUnityMaterial = R"(%YAML 1.1
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

constexpr const char* kHdrpLit = "6e4ae4064600d784cac1e41a9e6f2e59";
constexpr const char* kUrpLit = "933532a4fcc9baf4fa0491de14d08ed7";

struct UnitySlot {
  const char* suffix;
  const char* slot;
};
constexpr UnitySlot kHdrpSlots[] = {
    {"_BaseMap", "_BaseColorMap"}, {"_MaskMap", "_MaskMap"}, {"_NormalMap", "_NormalMap"}};
constexpr UnitySlot kUrpSlots[] = {{"_BaseMap", "_BaseMap"},
                                   {"_MetallicSmoothness", "_MetallicGlossMap"},
                                   {"_Normal", "_BumpMap"},
                                   {"_Occlusion", "_OcclusionMap"}};

std::string guid(const std::string& file) { return digest("weftlight unity " + file); }

std::string lines(const std::vector<std::string>& all) {
  std::string out;
  for (const std::string& line : all) out += "    - " + line + "\n";
  return out;
}

std::string write_unity_images(const SetFacts& set, Face face) {
  for (const ImageRow& row : image_rows(set.target)) {
    const std::string file = image_file(row, set.name, face);
    const bool normal = std::string_view(row.suffix).starts_with("_Normal");
    const bool covers = row.channels[3] == Channel::kCoverage && set.alpha == Alpha::kMask;
    std::string problem = write_file_atomically(set.folder + "/" + file + ".meta",
                                                fill_template(kUnityTexture, {{"GUID", guid(file)},
                                                                              {"SRGB", row.srgb ? "1" : "0"},
                                                                              {"KEEP", covers ? "1" : "0"},
                                                                              {"TYPE", normal ? "1" : "0"}}));
    if (!problem.empty()) return problem;
  }
  return {};
}

/// HDRP's Lit has either a specular colour or metal.
bool has_specular_color(const SetFacts& set, Face face) {
  return set.target == ExportTarget::kUnityHdrp && std::abs(set.of(face).fit().f0 - formulas::kEngineF0) > 1e-4f;
}

/// Colours are sRGB encoded, as in the inspector.
std::string unity_colors(const SetFacts& set, Face face) {
  if (!has_specular_color(set, face)) return {};
  const std::string f0 = number(static_cast<double>(srgb_encoded(set.of(face).fit().f0)));
  return "    - _SpecularColor: {r: " + f0 + ", g: " + f0 + ", b: " + f0 + ", a: 1}\n";
}

/// Blending and depth of the passes. The inspector derives them from the surface options, but an import does not. Gaps
/// have no highlight.
std::vector<std::string> unity_blending(bool hdrp, Alpha alpha) {
  const bool blend = alpha == Alpha::kBlend, cut = alpha == Alpha::kMask || alpha == Alpha::kHashed;
  const std::string write = blend ? "_ZWrite: 0" : "_ZWrite: 1";
  const std::string over = blend ? "10" : "0";  // one minus alpha
  if (hdrp)                                     // the shader multiplies by alpha itself
    return {"_BlendMode: 0",
            "_SrcBlend: 1",
            "_DstBlend: " + over,
            "_AlphaSrcBlend: 1",
            "_AlphaDstBlend: " + over,
            "_EnableBlendModePreserveSpecularLighting: 0",
            write,
            "_TransparentZWrite: 0",
            blend ? "_ZTestDepthEqualForOpaque: 4" : "_ZTestDepthEqualForOpaque: 3",
            cut ? "_ZTestGBuffer: 3" : "_ZTestGBuffer: 4"};
  return {"_BlendModePreserveSpecular: 0",
          blend ? "_SrcBlend: 5" : "_SrcBlend: 1",
          "_DstBlend: " + over,
          "_SrcBlendAlpha: 1",
          "_DstBlendAlpha: " + over,
          cut ? "_AlphaToMask: 1" : "_AlphaToMask: 0",
          write};
}

std::vector<std::string> unity_floats(const SetFacts& set, Face face, bool hdrp) {
  const std::string cut = set.alpha == Alpha::kMask || set.alpha == Alpha::kHashed ? "1" : "0";
  const std::string blend = set.alpha == Alpha::kBlend ? "1" : "0";
  std::vector<std::string> out;
  if (hdrp)
    out = {"_AlphaCutoffEnable: " + cut,
           "_AlphaCutoff: 0.5",
           "_SurfaceType: " + blend,
           "_CullMode: 2",
           has_specular_color(set, face) ? "_MaterialID: 4" : "_MaterialID: 1",
           "_NormalScale: 1",
           "_Metallic: 1",
           "_UVBase: 0",
           "_ReceivesSSR: 1"};
  else
    out = {
        "_AlphaClip: " + cut, "_Cutoff: 0.5",   "_Surface: " + blend,    "_Blend: 0",       "_Cull: 2", "_BumpScale: 1",
        "_Metallic: 1",       "_Smoothness: 1", "_OcclusionStrength: 1", "_WorkflowMode: 1"};
  const std::vector<std::string> blending = unity_blending(hdrp, set.alpha);
  out.insert(out.end(), blending.begin(), blending.end());
  return out;
}

std::string write_unity_face(const SetFacts& set, Face face) {
  if (std::string problem = write_unity_images(set, face); !problem.empty()) return problem;
  const bool hdrp = set.target == ExportTarget::kUnityHdrp;
  const SurfaceTexels& s = set.of(face).small();
  std::vector<std::string> textures;
  for (const UnitySlot& slot : hdrp ? std::span<const UnitySlot>(kHdrpSlots) : std::span<const UnitySlot>(kUrpSlots)) {
    textures.push_back(std::string(slot.slot) +
                       ":\n        m_Texture: {fileID: 2800000, guid: " + guid(image_named(set, slot.suffix, face)) +
                       ", type: 3}\n        m_Scale: {x: " + number(1 / static_cast<double>(s.width_mm)) +
                       ", y: " + number(1 / static_cast<double>(s.depth_mm)) + "}\n        m_Offset: {x: 0, y: 0}");
  }
  std::vector<std::string> words{"_NORMALMAP"};
  if (hdrp) words.insert(words.end(), {"_MASKMAP", "_NORMALMAP_TANGENT_SPACE"});
  else words.insert(words.end(), {"_METALLICSPECGLOSSMAP", "_OCCLUSIONMAP"});
  if (has_specular_color(set, face)) words.emplace_back("_MATERIAL_FEATURE_SPECULAR_COLOR");
  if (set.alpha == Alpha::kMask || set.alpha == Alpha::kHashed) words.emplace_back("_ALPHATEST_ON");
  if (set.alpha == Alpha::kBlend) words.emplace_back("_SURFACE_TYPE_TRANSPARENT");
  std::string keywords;
  for (const std::string& w : words) keywords += "  - " + w + "\n";
  const std::string name = set.name + (face == Face::kBack ? "_back" : ""), file = name + ".mat";
  std::string problem = write_file_atomically(
      set.folder + "/" + file,
      fill_template(kUnityMaterial, {{"NAME", name},
                                     {"SHADER", hdrp ? kHdrpLit : kUrpLit},
                                     {"KEYWORDS", keywords},
                                     {"QUEUE", set.alpha == Alpha::kBlend    ? "3000"
                                               : set.alpha == Alpha::kOpaque ? "-1"
                                                                             : "2450"},
                                     {"TYPE", set.alpha == Alpha::kBlend    ? "Transparent"
                                              : set.alpha == Alpha::kOpaque ? "Opaque"
                                                                            : "TransparentCutout"},
                                     {"TEXTURES", lines(textures)},
                                     {"FLOATS", lines(unity_floats(set, face, hdrp))},
                                     {"COLORS", unity_colors(set, face)}}));
  if (!problem.empty()) return problem;
  return write_file_atomically(set.folder + "/" + file + ".meta",
                               fill_template(kUnityMaterialMeta, {{"GUID", guid(file)}}));
}

/// The quad as .obj, since Unity cannot read glTF without a package: metres, texture coordinates in millimetres.
std::string write_obj_quad(const SetFacts& set) {
  const Mesh quad = scale_quad();
  std::string text = "# 100 mm a side; texture coordinates in millimetres\n";
  for (const Vec3& p : quad.position_mm)
    text += "v " + number(static_cast<double>(p[0]) / 1000) + " " + number(static_cast<double>(p[1]) / 1000) + " 0\n";
  for (const Vec2& t : quad.uv_mm)
    text += "vt " + number(-static_cast<double>(t[0])) + " " + number(-static_cast<double>(t[1])) + "\n";
  return write_file_atomically(set.folder + "/" + set.name + "_quad.obj",
                               text + "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n");
}

std::string write_godot_face(const SetFacts& set, Face face) {
  const FaceSource& source = set.of(face);
  const std::string name = set.name + (face == Face::kBack ? "_back" : "");
  // Godot has one material for both sides: the front has the back as its next pass.
  const bool front = face == Face::kFront;
  const std::string back = "[ext_resource type=\"Material\" path=\"" + set.name + "_back.tres\" id=\"5\"]\n";
  const char* transparency = set.alpha == Alpha::kBlend    ? "1"
                             : set.alpha == Alpha::kMask   ? "2"
                             : set.alpha == Alpha::kHashed ? "3"
                                                           : "0";
  return write_file_atomically(
      set.folder + "/" + name + ".tres",
      fill_template(kGodotMaterial, {{"NAME", name},
                                     {"ALBEDO", image_named(set, "_albedo", face)},
                                     {"ORM", image_named(set, "_orm", face)},
                                     {"NORMAL", image_named(set, "_normal", face)},
                                     {"FLOW", image_named(set, "_flowmap", face)},
                                     {"TRANSPARENCY", transparency},
                                     {"CULL", face == Face::kBack ? "1" : "0"},
                                     {"SPECULAR", number(std::sqrt(static_cast<double>(source.fit().f0) / 0.16))},
                                     {"SCALE_U", number(1 / static_cast<double>(source.small().width_mm))},
                                     {"SCALE_V", number(1 / static_cast<double>(source.small().depth_mm))},
                                     {"STEPS", front ? "6" : "5"},
                                     {"BACK", front ? back : std::string{}},
                                     {"NEXT", front ? "next_pass = ExtResource(\"5\")\n" : ""}}));
}

}  // namespace

std::string write_godot_material(const SetFacts& set) {
  const std::string problem = write_godot_face(set, Face::kFront);
  return problem.empty() ? write_godot_face(set, Face::kBack) : problem;
}

std::string write_unreal_script(const SetFacts& set) {
  const SurfaceTexels& s = set.front.small();
  return write_file_atomically(
      set.folder + "/" + set.name + "_import.py",
      fill_template(kUnrealScript, {{"NAME", set.name},
                                    {"ALPHA", alpha_name(set.alpha)},
                                    {"WIDTH_MM", number(static_cast<double>(s.width_mm))},
                                    {"DEPTH_MM", number(static_cast<double>(s.depth_mm))},
                                    {"SPECULAR", number(static_cast<double>(set.front.fit().specular()))},
                                    {"BACK_SPECULAR", number(static_cast<double>(set.back.fit().specular()))}}));
}

std::string write_unity_material(const SetFacts& set) {
  for (const Face face : {Face::kFront, Face::kBack}) {
    if (std::string problem = write_unity_face(set, face); !problem.empty()) return problem;
  }
  return write_obj_quad(set);
}

}  // namespace weftlight::texture_set
