// Godot 4: an ORMMaterial3D for each face. Based on: its manual of standard materials.

#include <cmath>

#include "base/whole_files.h"
#include "texture_set/material_files.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

using base::write_file_atomically;
using draft::Face;
using files::MipFormat;

namespace {

using enum Channel;
using enum PixelType;

constexpr ImageRow kImages[] = {
    {"", "_albedo", ".png", kU8, true, kBaseCoverage},
    {"", "_orm", ".png", kU8, false, kOcclusionRoughnessMetal},
    {"", "_normal", ".png", kU8, false, kNormalUp},
    {"", "_flowmap", ".png", kU8, false, {kWideX, kWideY, kOne, kAspectAnisotropy}},
};

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
uv1_offset = Vector3({OFFSET_U}, {OFFSET_V}, 0)
{NEXT})";

base::Result<void> write_godot_face(const SetFacts& set, Face face) {
  const FaceSource& source = set.of(face);
  const UvTransform uv = uv_transform(set);
  const std::string name = material_name(set, face);
  // Godot has one material for both sides: the front has the back as its next pass.
  const bool front = face == Face::kFront;
  const std::string back = "[ext_resource type=\"Material\" path=\"" + set.name + "_back.tres\" id=\"5\"]\n";
  // Blended with a depth pass of the opaque parts.
  const char* transparency = set.alpha == Alpha::kBlend ? "4" : set.alpha == Alpha::kMask ? "2" : "0";
  return write_file_atomically(
      set.folder + "/" + name + ".tres",
      fill_template(kGodotMaterial, {{"NAME", name},
                                     {"ALBEDO", mipped_image_named(set, "_albedo", face)},
                                     {"ORM", mipped_image_named(set, "_orm", face)},
                                     {"NORMAL", mipped_image_named(set, "_normal", face)},
                                     {"FLOW", mipped_image_named(set, "_flowmap", face)},
                                     {"TRANSPARENCY", transparency},
                                     {"CULL", face == Face::kBack ? "1" : "0"},
                                     {"SPECULAR", number(std::sqrt(static_cast<double>(source.fit().f0.g) / 0.16))},
                                     {"SCALE_U", number(uv.scale_u)},
                                     {"SCALE_V", number(uv.scale_v)},
                                     {"OFFSET_U", number(uv.offset_u)},
                                     {"OFFSET_V", number(0 - uv.offset_v)},
                                     {"STEPS", front ? "6" : "5"},
                                     {"BACK", front ? back : std::string{}},
                                     {"NEXT", front ? "next_pass = ExtResource(\"5\")\n" : ""}}));
}

base::Result<void> write_material(const SetFacts& set) {
  for (const Face face : {Face::kFront, Face::kBack}) {
    if (base::Result<void> done = write_godot_face(set, face); !done) return done;
  }
  return write_scale_quad(set);
}

}  // namespace

const ExportTarget targets::kGodot{
    .id = "godot",
    .title = "Godot",
    .images = kImages,
    .model = {.sheen = formulas::kSheenNone,
              .most_f0 = 4 * formulas::kEngineF0,
              .grazing = false,
              .anisotropic = true,
              .planes = 20},
    .highlight = "anisotropic GGX, specular to 1 (0.16)",
    .sheen = "none",
    // Its Compatibility renderer draws hashed transparency opaque; depth of the opaque parts first works in all three.
    .open = Alpha::kBlend,
    .color_mips = MipFormat::kDds,
    .names_dds = true,
    .material = ".tres",
    .write_material = write_material,
};

}  // namespace weftlight::texture_set
