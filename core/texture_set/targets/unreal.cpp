// Unreal Engine 5: images by its naming rules, and a script that imports them and builds cloth materials. Based on: its
// manual of the cloth shading model and its Python API.

#include "base/mark.h"
#include "base/whole_files.h"
#include "texture_set/material_files.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

using base::write_file_atomically;

namespace {

using enum Channel;
using enum PixelType;

constexpr ImageRow kImages[] = {
    {"T_", "_BC", ".png", kU8, true, kBaseColor},
    {"T_", "_N", ".png", kU8, false, {kNormalX, kNormalYDown, kNormalZ, kNone}},
    {"T_", "_ORM", ".png", kU8, false, kOcclusionRoughnessMetal},
    {"T_", "_OM", ".png", kU8, false, only(kCoverage)},
    {"T_", "_FC", ".png", kU8, true, {kSheenHueR, kSheenHueG, kSheenHueB, kNone}},
    {"T_", "_CW", ".png", kU8, false, only(kSheenWeight)},
};

constexpr const char* kScript =
    R"("""Imports this set into Unreal Engine 5 and makes its materials: run it from the editor's Python console
(Python Editor Script Plugin), or Tools > Execute Python Script. Texture coordinates are in {UNIT}, as in
{NAME}_quad.glb. For a mesh on which one UV unit is one repeat of {WIDTH_MM} x {DEPTH_MM} mm, set TILING = (1, 1)."""
import os
import unreal

NAME = "{NAME}"
TILING = ({TILING_U}, {TILING_V})  # repeats in a unit of the coordinates
OFFSET = ({OFFSET_U}, {OFFSET_V})  # in repeats, right and down
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
RECOLOUR = {  # images for recolouring, of sets that have them; indices are neither compressed nor filtered
    "_white": (True, COMPRESSION.TC_DEFAULT),
    "_threads": (False, COMPRESSION.TC_MASKS),
    "_index": (False, COMPRESSION.TC_VECTOR_DISPLACEMENTMAP),
}
RECOLOUR.update({"_shares%d" % k: (False, COMPRESSION.TC_MASKS) for k in range(1, 5)})
KINDS.update(RECOLOUR)
lib = unreal.MaterialEditingLibrary

def image(side, kind):
    return os.path.join(FOLDER, "T_" + NAME + side + kind + ".png")

def texture(side, kind):
    srgb, compression = KINDS[kind]
    task = unreal.AssetImportTask()
    task.filename = image(side, kind)
    task.destination_path, task.automated, task.replace_existing, task.save = INTO, True, True, True
    unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks([task])
    asset = unreal.load_asset(INTO + "/T_" + NAME + side + kind)
    asset.set_editor_property("srgb", srgb)
    asset.set_editor_property("compression_settings", compression)
    if kind == "_OM":  # keeps the coverage in every mip level
        asset.set_editor_property("alpha_coverage_thresholds", unreal.Vector4(0, 0, 0, 0.5))
    if kind == "_index":
        asset.set_editor_property("filter", unreal.TextureFilter.TF_NEAREST)
        asset.set_editor_property("mip_gen_settings", unreal.TextureMipGenSettings.TMGS_NO_MIPMAPS)
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
    place.set_editor_property("u_tiling", TILING[0])
    place.set_editor_property("v_tiling", TILING[1])
    if OFFSET != (0, 0):
        shift = lib.create_material_expression(made, unreal.MaterialExpressionConstant2Vector, -800, 150)
        shift.set_editor_property("r", OFFSET[0])
        shift.set_editor_property("g", OFFSET[1])
        moved = lib.create_material_expression(made, unreal.MaterialExpressionAdd, -650, 50)
        lib.connect_material_expressions(place, "", moved, "A")
        lib.connect_material_expressions(shift, "", moved, "B")
        place = moved

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
for side in ("", "_back"):
    for kind in RECOLOUR:
        if os.path.isfile(image(side, kind)):
            texture(side, kind)
)";

base::Result<void> write_material(const SetFacts& set) {
  const SurfaceTexels& s = set.front.small();
  const UvTransform uv = uv_transform(set);
  base::Result<void> done = write_file_atomically(
      set.folder + "/" + set.name + "_import.py",
      fill_template(kScript, {{"NAME", set.name},
                              {"ALPHA", alpha_name(set.alpha)},
                              {"UNIT", uv_unit_title(set.uv.unit)},
                              {"TILING_U", number(uv.scale_u)},
                              {"TILING_V", number(uv.scale_v)},
                              {"OFFSET_U", number(uv.offset_u)},
                              {"OFFSET_V", number(0 - uv.offset_v)},
                              {"WIDTH_MM", number(static_cast<double>(s.width_mm))},
                              {"DEPTH_MM", number(static_cast<double>(s.depth_mm))},
                              {"SPECULAR", number(static_cast<double>(set.front.fit().specular()))},
                              {"BACK_SPECULAR", number(static_cast<double>(set.back.fit().specular()))}}));
  if (!done) return done;
  return write_scale_quad(set);
}

}  // namespace

const ExportTarget targets::kUnreal{
    .id = "unreal",
    .title = "Unreal Engine",
    .images = kImages,
    .normal = "-Y",
    .model = {.sheen = formulas::kSheenInverseGgx,
              .most_f0 = 2 * formulas::kEngineF0,
              .grazing = false,
              .anisotropic = false},
    .highlight = "cloth model, Specular to 1; round highlight",
    .sheen = "its inverse GGX, fuzz colour x weight once",
    .open = Alpha::kHashed,
    .keeps_masks = true,
    .material = "_import.py",
    .write_material = write_material,
    .note =
        base::mark("In Unreal turn on the Python Editor Script Plugin and run {name}_import.py by Tools > Execute "
                   "Python Script. It imports the images into /Game/Weftlight/{name} and makes two materials "
                   "there, of the front and of the back. {name}_quad.glb is a flat piece of 100 mm to try them on."),
};

}  // namespace weftlight::texture_set
