// Cycles, of Blender 3.4 and 4: the principled material.

#include "base/mark.h"
#include "texture_set/material_files.h"
#include "texture_set/targets.h"
#include "texture_set/targets/blender.h"
#include "texture_set/targets/gltf.h"

namespace weftlight::texture_set {

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

// Version 4.0 reduces the diffuse part by the specular reflectance, and renamed sockets.
constexpr const char* kFacts =
    R"(OLDER = bpy.app.version < (4, 0, 0)  # their diffuse part is brighter
# Factor on the colour, Specular, and logarithms of growth() by slants(): of the colour, then of Specular.
FACES = {"": ({OLDER_FRONT}) if OLDER else ({FRONT}),
         "_back": ({OLDER_BACK}) if OLDER else ({BACK})})";

constexpr const char* kFace = R"(def face(side):
    shift, specular, tint, shine = FACES[side]
    slanted = slants()
    shader = nodes.new("ShaderNodeBsdfPrincipled")
    colour = times(image(side + "_basecolor.png", True), image(side + "_occlusion.png"))
    if OLDER:
        node = nodes.new("ShaderNodeCombineRGB")
        for socket, part in zip(node.inputs, shift):
            socket.default_value = part
        colour = times(colour, node.outputs["Image"])
    feed(shader, by_view(colour, slanted, tint), "Base Color")
    if "{BLEND}" != "OPAQUE":
        feed(shader, image(side + "_alpha.png"), "Alpha")
    feed(shader, image(side + "_roughness.png"), "Roughness")
    feed(shader, image(side + "_metallic.png"), "Metallic")
    feed(shader, image(side + "_anisotropic.png"), "Anisotropic")
    feed(shader, normal_map(side + "_normal.png"), "Normal")
    feed(shader, normal_map(side + "_tangent.png"), "Tangent")
    feed(shader, math("MULTIPLY", growth(slanted[2:], shine), specular), "Specular IOR Level", "Specular")
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
)";

/// Versions 3 and 4 differ in the body alone.
constexpr EngineModel model_over(int body) {
  return {.sheen = body,
          .most_f0 = 0.5f,
          .grazing = false,
          .anisotropic = true,
          .planes = 60,
          .each_texel = true,
          .view_tinted = true};
}

/// The numbers of a face for a fit, as Python text; the images have the colours of the face's own.
std::string face_of(const FaceSource& face, const EngineFit& fit) {
  return python_colour(fit.base / face.fit().base) + ", " + number(static_cast<double>(fit.specular())) + ", " +
         python_tint(fit.tint);
}

base::Result<void> write_material(const SetFacts& set) {
  return write_blender_material(set, {.name = "Cycles",
                                      .other = "EEVEE",
                                      .other_target = "eevee",
                                      .eevee = false,
                                      .facts = kFacts,
                                      .face = kFace,
                                      .values = {{"OLDER_FRONT", face_of(set.front, set.front.older_fit())},
                                                 {"OLDER_BACK", face_of(set.back, set.back.older_fit())},
                                                 {"FRONT", face_of(set.front, set.front.fit())},
                                                 {"BACK", face_of(set.back, set.back.fit())}}});
}

}  // namespace

const ExportTarget targets::kBlender{
    .id = "blender",
    .title = "Blender Cycles",
    .images = kImages,
    .model = model_over(formulas::kSheenNone),
    .older_model = model_over(formulas::kSheenNoneDisney),
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
    .note = base::mark("Open {name}.py in Blender's Scripting tab and run it, or start blender -P {name}.py: it makes "
                       "the material {name}, and gives it to the meshes that are selected. It is fitted to Cycles. "
                       "{name}.glb is a mesh to try it on."),
};

}  // namespace weftlight::texture_set
