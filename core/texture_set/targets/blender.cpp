// Blender 3.4 and 4: a script that builds its principled material. Based on: its manual.

#include "base/whole_files.h"
#include "texture_set/targets.h"
#include "texture_set/targets/gltf.h"

namespace weftlight::texture_set {

using base::write_file_atomically;
using light::EngineFit, light::EngineModel;

namespace {

using enum Channel;
using enum PixelType;

constexpr ImageRow kImages[] = {
    {"", "_basecolor", ".png", kU8, true, kBaseColor},
    {"", "_alpha", ".png", kU8, false, only(kCoverage)},
    {"", "_roughness", ".png", kU8, false, only(kRoughness)},
    {"", "_metallic", ".png", kU8, false, only(kMetal)},
    {"", "_normal", ".png", kU16, false, kNormalUp},
    {"", "_tangent", ".png", kU16, false, {kWideX, kWideY, kOneHalf, kNone}},
    {"", "_anisotropic", ".png", kU8, false, only(kAspectAnisotropy)},
    {"", "_occlusion", ".png", kU8, false, only(kOcclusion)},
    {"", "_height", ".exr", kHalf, false, only(kHeightMm)},
};

// Version 4.0 renamed sockets and reduces the diffuse part by the specular reflectance. The glTF
// importer stores 1 - v; the script subtracts that one unit.
constexpr const char* kScript =
    R"("""Builds the material "{NAME}" from the images beside this file: front and back, each with its own.
Run it in the Scripting tab (open it there from the folder of the set), or `blender -P` it.
Texture coordinates are in {UNIT}, as in {NAME}.glb. For a mesh on which one UV unit is one repeat of
{WIDTH_MM} x {DEPTH_MM} mm, set TILING = (1, 1).
The material is fitted to Cycles. EEVEE has round highlights alone, and draws shiny cloth 2 to 5 times too bright."""
import os
import bmesh
import bpy

NAME = "{NAME}"
TILING = ({TILING_U}, {TILING_V})  # repeats in a unit of the coordinates
OFFSET = ({OFFSET_U}, {OFFSET_V})  # in repeats, right and up

def folder():
    """The folder of this script; if it is not saved, that of the .blend."""
    texts = [text.filepath for text in bpy.data.texts if os.path.basename(text.filepath) == NAME + ".py"]
    if texts:
        return os.path.dirname(bpy.path.abspath(texts[0]))
    here = globals().get("__file__", "")
    return os.path.dirname(os.path.abspath(here)) if os.path.isfile(here) else bpy.path.abspath("//")

FOLDER = folder()
if "EEVEE" in bpy.context.scene.render.engine:
    print(NAME + " is fitted to Cycles: EEVEE draws shiny cloth 2 to 5 times too bright. Render Properties > Render Engine > Cycles")
THROUGH = {THROUGH}  # diffuse transmission as a fraction of the diffuse light
OLDER = bpy.app.version < (4, 0, 0)  # their diffuse part is brighter: factor on the colour, Specular
FACES = {"": ({OLDER_FRONT}) if OLDER else ((1, 1, 1), {SPECULAR}),
         "_back": ({OLDER_BACK}) if OLDER else ((1, 1, 1), {BACK_SPECULAR})}
material = bpy.data.materials.new(NAME)
material.use_nodes = True
material.blend_method = "{BLEND}"
nodes, links = material.node_tree.nodes, material.node_tree.links
nodes.remove(nodes["Principled BSDF"])
place = nodes.new("ShaderNodeMapping")
place.inputs["Scale"].default_value = (TILING[0], TILING[1], 1)
place.inputs["Location"].default_value = (OFFSET[0], OFFSET[1] - TILING[1], 0)
links.new(nodes.new("ShaderNodeTexCoord").outputs["UV"], place.inputs["Vector"])

def image(suffix, colour=False):
    node = nodes.new("ShaderNodeTexImage")
    node.image = bpy.data.images.load(os.path.join(FOLDER, NAME + suffix))
    node.image.colorspace_settings.name = "sRGB" if colour else "Non-Color"
    links.new(place.outputs["Vector"], node.inputs["Vector"])
    return node.outputs["Color"]

def feed(shader, output, *names):
    for name in names:
        if name in shader.inputs:
            links.new(output, shader.inputs[name])
            return

def number(value):
    """As a node: a linked value may exceed the range of the socket."""
    node = nodes.new("ShaderNodeValue")
    node.outputs[0].default_value = value
    return node.outputs[0]

def normal_map(suffix):
    node = nodes.new("ShaderNodeNormalMap")
    links.new(image(suffix), node.inputs["Color"])
    return node.outputs["Normal"]

def times(colour, factor):
    node = nodes.new("ShaderNodeMixRGB")
    node.blend_type = "MULTIPLY"
    node.inputs["Fac"].default_value = 1
    links.new(colour, node.inputs["Color1"])
    links.new(factor, node.inputs["Color2"])
    return node.outputs["Color"]

def face(side):
    tint, specular = FACES[side]
    shader = nodes.new("ShaderNodeBsdfPrincipled")
    colour = times(image(side + "_basecolor.png", True), image(side + "_occlusion.png"))
    if OLDER:
        shift = nodes.new("ShaderNodeCombineRGB")
        for socket, part in zip(shift.inputs, tint):
            socket.default_value = part
        colour = times(colour, shift.outputs["Image"])
    feed(shader, colour, "Base Color")
    if "{BLEND}" != "OPAQUE":
        feed(shader, image(side + "_alpha.png"), "Alpha")
    feed(shader, image(side + "_roughness.png"), "Roughness")
    feed(shader, image(side + "_metallic.png"), "Metallic")
    feed(shader, image(side + "_anisotropic.png"), "Anisotropic")
    feed(shader, normal_map(side + "_normal.png"), "Normal")
    feed(shader, normal_map(side + "_tangent.png"), "Tangent")
    feed(shader, number(specular), "Specular IOR Level", "Specular")
    if THROUGH == 0:
        return shader.outputs["BSDF"]
    # Transmission through the threads, from a light behind them.
    translucent = nodes.new("ShaderNodeBsdfTranslucent")
    thread = colour if "{BLEND}" == "OPAQUE" else times(colour, image(side + "_alpha.png"))
    links.new(times(thread, number(THROUGH)), translucent.inputs["Color"])
    both = nodes.new("ShaderNodeAddShader")
    links.new(shader.outputs["BSDF"], both.inputs[0])
    links.new(translucent.outputs["BSDF"], both.inputs[1])
    return both.outputs["Shader"]

def without_back(mesh):
    """{NAME}.glb repeats its triangles for the back; this material handles both sides."""
    back = [at for at, other in enumerate(mesh.materials) if other and other.name.startswith(NAME + "_back")]
    shape = bmesh.new()
    shape.from_mesh(mesh)
    bmesh.ops.delete(shape, geom=[face for face in shape.faces if face.material_index in back], context="FACES")
    shape.to_mesh(mesh)
    shape.free()

both = nodes.new("ShaderNodeMixShader")
links.new(nodes.new("ShaderNodeNewGeometry").outputs["Backfacing"], both.inputs[0])
links.new(face(""), both.inputs[1])
links.new(face("_back"), both.inputs[2])
links.new(both.outputs["Shader"], nodes["Material Output"].inputs["Surface"])
for thing in bpy.context.selected_objects:
    if thing.type == "MESH":
        without_back(thing.data)
        thing.data.materials.clear()
        thing.data.materials.append(material)
        for polygon in thing.data.polygons:
            polygon.material_index = 0
)";

const char* blend_of(Alpha alpha) {
  switch (alpha) {
    case Alpha::kMask:
      return "CLIP";
    case Alpha::kHashed:
      return "HASHED";
    case Alpha::kBlend:
      return "BLEND";
    case Alpha::kAuto:
    case Alpha::kOpaque:
      break;
  }
  return "OPAQUE";
}

/// Tint and Specular for Blender 3, as Python text.
std::string older_of(const FaceSource& face) {
  const EngineFit& older = face.older_fit();
  const glm::vec3 tint = older.base / face.fit().base;
  const auto text = [](float v) { return number(static_cast<double>(v)); };
  return fill_template(
      "({R}, {G}, {B}), {SPECULAR}",
      {{"R", text(tint.r)}, {"G", text(tint.g)}, {"B", text(tint.b)}, {"SPECULAR", text(older.specular())}});
}

base::Result<void> write_script(const SetFacts& set) {
  const EngineFit &front = set.front.fit(), &back = set.back.fit();
  const SurfaceTexels& s = set.front.small();
  const UvTransform uv = uv_transform(set);
  return write_file_atomically(
      set.folder + "/" + set.name + ".py",
      fill_template(kScript, {{"NAME", set.name},
                              {"BLEND", blend_of(set.alpha)},
                              {"UNIT", uv_unit_title(set.uv.unit)},
                              {"TILING_U", number(uv.scale_u)},
                              {"TILING_V", number(uv.scale_v)},
                              {"OFFSET_U", number(uv.offset_u)},
                              {"OFFSET_V", number(uv.offset_v)},
                              {"WIDTH_MM", number(static_cast<double>(s.width_mm))},
                              {"DEPTH_MM", number(static_cast<double>(s.depth_mm))},
                              {"THROUGH", number(static_cast<double>(mean_transmission(set)))},
                              {"OLDER_FRONT", older_of(set.front)},
                              {"OLDER_BACK", older_of(set.back)},
                              {"SPECULAR", number(static_cast<double>(front.specular()))},
                              {"BACK_SPECULAR", number(static_cast<double>(back.specular()))}}));
}

/// The images belong to the script; the mesh is a .glb with images of its own.
base::Result<void> write_material(const SetFacts& set) {
  return write_gltf(set, ".glb", GltfImages::kEmbedded).and_then([&set] { return write_script(set); });
}

}  // namespace

const ExportTarget targets::kBlender{
    .id = "blender",
    .title = "Blender",
    .images = kImages,
    .model = {.sheen = formulas::kSheenNone, .most_f0 = 0.5f, .grazing = false, .anisotropic = true},
    .older_model =
        EngineModel{.sheen = formulas::kSheenNoneDisney, .most_f0 = 0.5f, .grazing = false, .anisotropic = true},
    .highlight =
        "principled, Specular as a node (beyond 1), each texel by itself; colour and Specular for Blender 3 "
        "and for 4",
    .sheen = "none: Blender 3 and 4 have different ones",
    .path_traced = true,
    .open = Alpha::kHashed,
    .keeps_masks = true,
    .material = ".py",
    .write_material = write_material,
    .wears_mesh = true,
    .embedded = embedded_images,
};

}  // namespace weftlight::texture_set
