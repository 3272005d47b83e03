// Cycles, of Blender 3.4 and 4: the principled material.

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
    R"(OLDER = bpy.app.version < (4, 0, 0)  # their diffuse part is brighter: factor on the colour, Specular
FACES = {"": ({OLDER_FRONT}) if OLDER else ((1, 1, 1), {SPECULAR}),
         "_back": ({OLDER_BACK}) if OLDER else ((1, 1, 1), {BACK_SPECULAR})})";

constexpr const char* kFace = R"(def face(side):
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
)";

/// Tint and Specular for Blender 3, as Python text.
std::string older_of(const FaceSource& face) {
  const EngineFit& older = face.older_fit();
  const glm::vec3 tint = older.base / face.fit().base;
  const auto text = [](float v) { return number(static_cast<double>(v)); };
  return fill_template(
      "({R}, {G}, {B}), {SPECULAR}",
      {{"R", text(tint.r)}, {"G", text(tint.g)}, {"B", text(tint.b)}, {"SPECULAR", text(older.specular())}});
}

base::Result<void> write_material(const SetFacts& set) {
  const EngineFit &front = set.front.fit(), &back = set.back.fit();
  return write_blender_material(set, {.name = "Cycles",
                                      .other = "EEVEE",
                                      .other_target = "eevee",
                                      .eevee = false,
                                      .facts = kFacts,
                                      .face = kFace,
                                      .values = {{"OLDER_FRONT", older_of(set.front)},
                                                 {"OLDER_BACK", older_of(set.back)},
                                                 {"SPECULAR", number(static_cast<double>(front.specular()))},
                                                 {"BACK_SPECULAR", number(static_cast<double>(back.specular()))}}});
}

}  // namespace

const ExportTarget targets::kBlender{
    .id = "blender",
    .title = "Blender Cycles",
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
