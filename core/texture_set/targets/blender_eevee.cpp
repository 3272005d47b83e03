// EEVEE, of Blender 3.4 and 4. It has round highlights alone. Anisotropic GGX is made of some of them whose normals
// lean along the wider axis, by chance within equal parts of the distribution, which the samples of a pixel average:
//
// Its slope along the wider axis has the density ~ (1 + x^2 / wide^2)^(-3/2), which x = wide v / sqrt(1 - v^2) has for
// v uniform in -1..1. Given x, the lobe across has the alpha narrow sqrt(1 + x^2 / wide^2), times the cosine of the
// lean as an angle. Towards a view a facet counts by its projected area over that of all, which are those of Smith's
// masking: Heitz 2014, Understanding the Masking-Shadowing Function, section 3. Differs: lights see no masking; `wide`
// is sqrt(wide^2 - narrow^2), since a round lobe has a width of its own.
//
// The highlight is added to the diffuse shader, which loses nothing to it, so that numbers mean the same in all
// versions.

#include "base/mark.h"
#include "texture_set/material_files.h"
#include "texture_set/targets.h"
#include "texture_set/targets/blender.h"
#include "texture_set/targets/gltf.h"

namespace weftlight::texture_set {

namespace {

using enum Channel;
using enum PixelType;

constexpr ImageRow kImages[] = {
    {"", "_basecolor", ".png", kU8, true, kBaseColor},
    {"", "_alpha", ".png", kU8, false, only(kCoverage)},
    {"", "_roughness", ".png", kU8, false, only(kRoughnessNarrow)},
    {"", "_lean", ".png", kU8, false, only(kLean)},
    {"", "_metallic", ".png", kU8, false, only(kMetal)},
    {"", "_normal", ".png", kU16, false, kNormalUp},
    {"", "_tangent", ".png", kU16, false, {kWideX, kWideY, kOneHalf, kNone}},
    {"", "_occlusion", ".png", kU8, false, only(kOcclusion)},
    {"", "_height", ".exr", kHalf, false, only(kHeightMm)},
};

constexpr int kLobes = 9;  // as noisy with 16 samples as 5 with 64, at half the cost

constexpr const char* kFacts =
    R"(# Reflectance at normal view and at grazing, linear; logarithms of growth() by slants(): of the colour, then of both
# reflectances.
FACES = {"": ({FRONT}), "_back": ({BACK})}
LOBES = {LOBES}  # round highlights side by side
GLOSSY = "ShaderNodeBsdfGlossy" if hasattr(bpy.types, "ShaderNodeBsdfGlossy") else "ShaderNodeBsdfAnisotropic"  # 4: renamed)";

constexpr const char* kFace = R"(def between(factor, first, second):
    """Of two colours; each a socket or (r, g, b)."""
    node = nodes.new("ShaderNodeMixRGB")
    links.new(factor, node.inputs["Fac"])
    for socket, colour in zip((node.inputs["Color1"], node.inputs["Color2"]), (first, second)):
        if isinstance(colour, tuple):
            socket.default_value = (*colour, 1)
        else:
            links.new(colour, socket)
    return node.outputs["Color"]

def added(shaders):
    both = shaders[0].outputs[0]
    for other in shaders[1:]:
        node = nodes.new("ShaderNodeAddShader")
        links.new(both, node.inputs[0])
        links.new(other.outputs[0], node.inputs[1])
        both = node.outputs[0]
    return both

def highlights(side, at_normal, at_grazing, normal):
    """Round ones, from normals that lean along the wider axis: by chance, each within its part of the distribution."""
    shine, grazing = vector("SCALE", at_normal, 1 / LOBES), vector("SCALE", at_grazing, 1 / LOBES)
    roughness, lean = image(side + "_roughness.png"), image(side + "_lean.png")
    wider = normal_map(side + "_tangent.png")
    view = nodes.new("ShaderNodeNewGeometry").outputs["Incoming"]
    upright, sideways = vector("DOT_PRODUCT", view, normal), vector("DOT_PRODUCT", view, wider)
    span = math("MULTIPLY", lean, sideways)
    seen = math("ADD", upright, math("SQRT", math("ADD", math("MULTIPLY", upright, upright), math("MULTIPLY", span, span))))
    narrower = math("SUBTRACT", 1, math("MULTIPLY", lean, lean))
    chance = nodes.new("ShaderNodeTexWhiteNoise")
    links.new(place.outputs["Vector"], chance.inputs["Vector"])
    for at in range(LOBES):
        shader = nodes.new(GLOSSY)
        shader.distribution = "GGX"
        v = math("ADD", math("MULTIPLY", chance.outputs["Value"], 1.96 / LOBES), 1.96 * at / LOBES - 0.98)
        v2 = math("MULTIPLY", v, v)
        slope = math("MULTIPLY", lean, math("DIVIDE", v, math("SQRT", math("SUBTRACT", 1, v2))))
        leaning = vector("NORMALIZE", vector("ADD", normal, vector("SCALE", wider, slope)))
        links.new(leaning, shader.inputs["Normal"])
        wide = math("POWER", math("SUBTRACT", 1, math("MULTIPLY", v2, narrower)), -0.25)
        links.new(math("MINIMUM", math("MULTIPLY", roughness, wide), 1), shader.inputs["Roughness"])
        slant = nodes.new("ShaderNodeLayerWeight")
        links.new(leaning, slant.inputs["Normal"])
        schlick = math("POWER", slant.outputs["Facing"], 5)  # Facing: 1 - the cosine
        facet = math("MAXIMUM", math("ADD", upright, math("MULTIPLY", slope, sideways)), 0)
        weight = math("DIVIDE", math("MULTIPLY", facet, 2), math("MAXIMUM", seen, 0.001))
        links.new(vector("SCALE", between(schlick, shine, grazing), weight), shader.inputs["Color"])
        yield shader

def face(side):
    colour = times(image(side + "_basecolor.png", True), image(side + "_occlusion.png"))
    metal, normal = image(side + "_metallic.png"), normal_map(side + "_normal.png")
    at_normal, at_grazing, tint, shine = FACES[side]
    slanted = slants()
    body, tinted = nodes.new("ShaderNodeBsdfDiffuse"), by_view(colour, slanted, tint)
    shone = growth(slanted[2:], shine)
    at_normal, at_grazing = vector("SCALE", at_normal, shone), vector("SCALE", at_grazing, shone)
    links.new(between(metal, tinted, (0, 0, 0)), body.inputs["Color"])
    links.new(normal, body.inputs["Normal"])
    parts = [body, *highlights(side, between(metal, at_normal, tinted), between(metal, at_grazing, (1, 1, 1)), normal)]
    if THROUGH != 0:  # Transmission through the threads, from a light behind them.
        parts.append(nodes.new("ShaderNodeBsdfTranslucent"))
        links.new(times(colour, number(THROUGH)), parts[-1].inputs["Color"])
    if "{BLEND}" == "OPAQUE":
        return added(parts)
    gaps = nodes.new("ShaderNodeMixShader")
    links.new(image(side + "_alpha.png"), gaps.inputs[0])
    links.new(nodes.new("ShaderNodeBsdfTransparent").outputs[0], gaps.inputs[1])
    links.new(added(parts), gaps.inputs[2])
    return gaps.outputs[0]
)";

/// The numbers of a face as Python text.
std::string face_of(const FaceSource& face) {
  return python_colour(face.fit().f0) + ", " + python_colour(glm::vec3(face.fit().f90)) + ", " +
         python_tint(face.fit().tint);
}

base::Result<void> write_material(const SetFacts& set) {
  return write_blender_material(
      set, {.name = "EEVEE",
            .other = "Cycles",
            .other_target = "blender",
            .eevee = true,
            .facts = kFacts,
            .face = kFace,
            .values = {{"LOBES", std::to_string(kLobes)}, {"FRONT", face_of(set.front)}, {"BACK", face_of(set.back)}}});
}

}  // namespace

const ExportTarget targets::kEevee{
    .id = "eevee",
    .title = "Blender EEVEE",
    .images = kImages,
    .model = {.sheen = formulas::kSheenNoneAdded,
              .most_f0 = 1,
              .grazing = true,
              .anisotropic = true,
              .tinted = true,
              .planes = 20,
              .view_tinted = true},
    .highlight = "anisotropic GGX of nine round ones, whose normals lean by chance; added to the diffuse part",
    .sheen = "none",
    .open = Alpha::kHashed,
    .keeps_masks = true,
    .material = ".py",
    .write_material = write_material,
    .wears_mesh = true,
    .embedded = embedded_images,
    .note = base::mark("Open {name}.py in Blender's Scripting tab and run it, or start blender -P {name}.py: it makes "
                       "the material {name}, and gives it to the meshes that are selected. It is fitted to EEVEE. "
                       "{name}.glb is a mesh to try it on."),
};

}  // namespace weftlight::texture_set
