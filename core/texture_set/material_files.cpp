#include "texture_set/material_files.h"

#include <algorithm>
#include <cstdio>

#include "base/files.h"

namespace weftlight::texture_set {
namespace {

// Engines cut alpha at one half, so that a texel that is more gap than thread goes.
constexpr float kAlphaCut = 0.5f;

std::string number(float v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", static_cast<double>(v));
  return text;
}

/// Every {KEY} of the template becomes its value.
std::string filled(std::string text, const std::vector<std::pair<std::string, std::string>>& values) {
  for (const auto& [key, value] : values) {
    const std::string mark = "{" + key + "}";
    for (size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size())) {
      text.replace(at, mark.size(), value);
    }
  }
  return text;
}

// Godot 4: StandardMaterial3D; ORM material takes one image for occlusion, roughness and metal.
constexpr const char* kGodotMaterial = R"([gd_resource type="ORMMaterial3D" load_steps=6 format=3]

[ext_resource type="Texture2D" path="{NAME}_albedo.png" id="1"]
[ext_resource type="Texture2D" path="{NAME}_orm.png" id="2"]
[ext_resource type="Texture2D" path="{NAME}_normal.png" id="3"]
[ext_resource type="Texture2D" path="{NAME}_flowmap.png" id="4"]
[ext_resource type="Texture2D" path="{NAME}_backlight.png" id="5"]

[resource]
resource_name = "{NAME}"
transparency = {TRANSPARENCY}
alpha_scissor_threshold = 0.5
cull_mode = 2
albedo_texture = ExtResource("1")
orm_texture = ExtResource("2")
normal_enabled = true
normal_texture = ExtResource("3")
anisotropy_enabled = true
anisotropy = 1.0
anisotropy_flowmap = ExtResource("4")
backlight_enabled = true
backlight_texture = ExtResource("5")
uv1_scale = Vector3({SCALE_U}, {SCALE_V}, 1)
)";

// Blender 3.4 and 4: run it in the scripting tab, or `blender -P` it. Sockets were renamed in 4.0.
constexpr const char* kBlenderScript =
    R"("""Builds the material "{NAME}" from the images beside this file. One UV unit is one repeat of
{WIDTH_MM} x {DEPTH_MM} mm; for a mesh whose UVs are millimetres set MM_UV = True (the .glb's are)."""
import os
import bpy

NAME = "{NAME}"
SIZE_MM = ({WIDTH_MM}, {DEPTH_MM})
MM_UV = False
FOLDER = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else bpy.path.abspath("//")

material = bpy.data.materials.new(NAME)
material.use_nodes = True
material.blend_method = "{BLEND}"
nodes, links = material.node_tree.nodes, material.node_tree.links
shader = nodes["Principled BSDF"]
place = nodes.new("ShaderNodeMapping")
place.inputs["Scale"].default_value = (1 / SIZE_MM[0], 1 / SIZE_MM[1], 1) if MM_UV else (1, 1, 1)
links.new(nodes.new("ShaderNodeTexCoord").outputs["UV"], place.inputs["Vector"])


def image(suffix, colour=False):
    node = nodes.new("ShaderNodeTexImage")
    node.image = bpy.data.images.load(os.path.join(FOLDER, NAME + suffix))
    node.image.colorspace_settings.name = "sRGB" if colour else "Non-Color"
    links.new(place.outputs["Vector"], node.inputs["Vector"])
    return node.outputs["Color"]


def feed(output, *names):
    for name in names:
        if name in shader.inputs:
            links.new(output, shader.inputs[name])
            return


feed(image("_basecolor.png", True), "Base Color")
feed(image("_alpha.png"), "Alpha")
feed(image("_roughness.png"), "Roughness")
feed(image("_metallic.png"), "Metallic")
feed(image("_anisotropic.png"), "Anisotropic")
normal = nodes.new("ShaderNodeNormalMap")
links.new(image("_normal.png"), normal.inputs["Color"])
feed(normal.outputs["Normal"], "Normal")
tangent = nodes.new("ShaderNodeNormalMap")
links.new(image("_tangent.png"), tangent.inputs["Color"])
feed(tangent.outputs["Normal"], "Tangent")
sheen = image("_sheen.png", True)
if "Sheen Weight" in shader.inputs:
    shader.inputs["Sheen Weight"].default_value = 1
    shader.inputs["Sheen Roughness"].default_value = {SHEEN_ROUGHNESS}
    feed(sheen, "Sheen Tint")
else:
    feed(sheen, "Sheen")
for thing in bpy.context.selected_objects:
    if thing.type == "MESH":
        thing.data.materials.clear()
        thing.data.materials.append(material)
)";

float mean_sheen_roughness(const Surface& surface) {
  double sum = 0;
  for (const SurfaceTexel& t : surface.texels.at_) sum += static_cast<double>(t.sheen_roughness);
  return static_cast<float>(sum / static_cast<double>(surface.texels.at_.size()));
}

std::string write_glb(const std::string& path, const std::string& name, const Surface& surface, const Mesh& mesh) {
  const std::span<const ImageRow> rows = image_rows(Target::kGltf);
  auto png = [&](size_t row) { return encode_png(pack(rows[row], surface)); };
  GltfMaterial material;
  material.name = name;
  material.base_color_png = png(0);
  material.orm_png = png(1);
  material.normal_png = png(2);
  material.anisotropy_png = png(3);
  material.sheen_png = png(4);
  material.uv_scale_u = 1 / surface.width_mm;
  material.uv_scale_v = 1 / surface.depth_mm;
  material.sheen_color = {1, 1, 1};
  material.sheen_roughness = 1;
  material.anisotropy_strength = 1;
  material.alpha_mask_or_blend = has_gaps(surface);
  return write_mesh(path, mesh, &material);
}

std::vector<std::pair<std::string, std::string>> template_values(const std::string& name, const Surface& surface) {
  const bool gaps = has_gaps(surface);
  return {{"NAME", name},
          {"TRANSPARENCY", gaps ? "2" : "0"},
          {"BLEND", gaps ? "HASHED" : "OPAQUE"},
          {"SCALE_U", number(1 / surface.width_mm)},
          {"SCALE_V", number(1 / surface.depth_mm)},
          {"WIDTH_MM", number(surface.width_mm)},
          {"DEPTH_MM", number(surface.depth_mm)},
          {"SHEEN_ROUGHNESS", number(mean_sheen_roughness(surface))}};
}

}  // namespace

bool needs_mesh(Target target) { return target == Target::kGltf || target == Target::kBlender; }

bool has_gaps(const Surface& surface) {
  return std::any_of(surface.texels.at_.begin(), surface.texels.at_.end(),
                     [](const SurfaceTexel& t) { return t.coverage < kAlphaCut; });
}

MaterialFile write_material(const std::string& folder, const std::string& name, Target target, const Surface& surface,
                            const Mesh& mesh) {
  const std::string path = folder + "/" + name;
  switch (target) {
    case Target::kGltf:
      return {name + ".glb", write_glb(path + ".glb", name, surface, mesh)};
    case Target::kGodot:
      return {name + ".tres",
              write_file_atomically(path + ".tres", filled(kGodotMaterial, template_values(name, surface)))};
    case Target::kBlender: {
      const std::string problem = write_glb(path + ".glb", name, surface, mesh);
      if (!problem.empty()) return {name + ".glb", problem};
      return {name + ".py",
              write_file_atomically(path + ".py", filled(kBlenderScript, template_values(name, surface)))};
    }
    case Target::kRaw:
    case Target::kUnreal:
    case Target::kUnityHdrp:
    case Target::kUnityUrp:
      break;
  }
  return {};
}

}  // namespace weftlight::texture_set
