#include "texture_set/targets/blender.h"

#include "base/whole_files.h"
#include "texture_set/material_files.h"
#include "texture_set/targets/gltf.h"

namespace weftlight::texture_set {

using base::write_file_atomically;

namespace {

// The glTF importer stores 1 - v; the script subtracts that one unit.
constexpr const char* kScript =
    R"("""Builds the material "{NAME}" from the images beside this file: front and back, each with its own.
Run it in the Scripting tab (open it there from the folder of the set), or `blender -P` it.
Texture coordinates are in {UNIT}, as in {NAME}.glb. For a mesh on which one UV unit is one repeat of
{WIDTH_MM} x {DEPTH_MM} mm, set TILING = (1, 1).
The material is fitted to {ENGINE}; for {OTHER} export the set "{OTHER_TARGET}"."""
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
if ("EEVEE" in bpy.context.scene.render.engine) != {FOR_EEVEE}:
    print(NAME + " is fitted to {ENGINE}; for {OTHER} export the set \"{OTHER_TARGET}\"")
THROUGH = {THROUGH}  # diffuse transmission as a fraction of the diffuse light
{FACTS}
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

def vector(operation, first, second=None):
    """The first a socket or (r, g, b), the second a socket or a number."""
    node = nodes.new("ShaderNodeVectorMath")
    node.operation = operation
    if isinstance(first, tuple):
        node.inputs[0].default_value = first
    else:
        links.new(first, node.inputs[0])
    socket = node.inputs["Scale"] if operation == "SCALE" else node.inputs[1]
    if isinstance(second, float):
        socket.default_value = second
    elif second is not None:
        links.new(second, socket)
    return node.outputs["Value" if operation == "DOT_PRODUCT" else "Vector"]

def math(operation, first, second=None):
    """Each a socket or a number."""
    node = nodes.new("ShaderNodeMath")
    node.operation = operation
    for socket, given in zip(node.inputs, (first, second)):
        if isinstance(given, (int, float)):
            socket.default_value = given
        elif given is not None:
            links.new(given, socket)
    return node.outputs[0]

def slants():
    """Of the view along the weft and along the warp: x^2 / (1 + z) and y^2 / (1 + z), then both times 1 - z."""
    geometry, along = nodes.new("ShaderNodeNewGeometry"), nodes.new("ShaderNodeTangent")
    along.direction_type = "UV_MAP"
    x = vector("DOT_PRODUCT", geometry.outputs["Incoming"], along.outputs["Tangent"])
    z = vector("DOT_PRODUCT", geometry.outputs["Incoming"], geometry.outputs["Normal"])
    flat = math("SUBTRACT", 1, z)
    along_weft = math("DIVIDE", math("MULTIPLY", x, x), math("ADD", z, 1))
    along_warp = math("MAXIMUM", math("SUBTRACT", flat, along_weft), 0)
    return along_weft, along_warp, math("MULTIPLY", along_weft, flat), math("MULTIPLY", along_warp, flat)

def growth(slanted, logarithms):
    """The factor of a view: exp of its slants times these logarithms, as many as there are."""
    power = 0
    for slant, logarithm in zip(slanted, logarithms):
        power = math("ADD", math("MULTIPLY", slant, logarithm), power)
    return math("POWER", 2.718281828, power)

def by_view(colour, slanted, tint):
    """The colour times a factor: a slant shows more of one system of threads."""
    factor = nodes.new("ShaderNodeCombineXYZ")
    for socket, logarithms in zip(factor.inputs, zip(*tint)):
        links.new(growth(slanted, logarithms), socket)
    return times(colour, factor.outputs[0])

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

{FACE}
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

base::Result<void> write_script(const SetFacts& set, const BlenderRenderer& renderer) {
  const SurfaceTexels& s = set.front.small();
  const UvTransform uv = uv_transform(set);
  const std::string script = fill_template(kScript, {{"FACTS", renderer.facts}, {"FACE", renderer.face}});
  return write_file_atomically(set.folder + "/" + set.name + ".py",
                               fill_template(fill_template(script, renderer.values),
                                             {{"NAME", set.name},
                                              {"ENGINE", renderer.name},
                                              {"OTHER", renderer.other},
                                              {"OTHER_TARGET", renderer.other_target},
                                              {"FOR_EEVEE", renderer.eevee ? "True" : "False"},
                                              {"BLEND", blend_of(set.alpha)},
                                              {"UNIT", uv_unit_title(set.uv.unit)},
                                              {"TILING_U", number(uv.scale_u)},
                                              {"TILING_V", number(uv.scale_v)},
                                              {"OFFSET_U", number(uv.offset_u)},
                                              {"OFFSET_V", number(uv.offset_v)},
                                              {"WIDTH_MM", number(static_cast<double>(s.width_mm))},
                                              {"DEPTH_MM", number(static_cast<double>(s.depth_mm))},
                                              {"THROUGH", number(static_cast<double>(mean_transmission(set)))}}));
}

}  // namespace

std::string python_tint(const light::ViewTint& tint) {
  const auto text = [](float v) { return number(static_cast<double>(v)); };
  return "(" + python_colour(tint.weft) + ", " + python_colour(tint.warp) + ", " + python_colour(tint.late_weft) +
         ", " + python_colour(tint.late_warp) + "), (" + text(tint.shine.x) + ", " + text(tint.shine.y) + ")";
}

std::string python_colour(const glm::vec3& colour) {
  const auto text = [](float v) { return number(static_cast<double>(v)); };
  return "(" + text(colour.r) + ", " + text(colour.g) + ", " + text(colour.b) + ")";
}

/// The images belong to the script; the mesh is a .glb with images of its own.
base::Result<void> write_blender_material(const SetFacts& set, const BlenderRenderer& renderer) {
  return write_gltf(set, ".glb", GltfImages::kEmbedded).and_then([&] { return write_script(set, renderer); });
}

}  // namespace weftlight::texture_set
