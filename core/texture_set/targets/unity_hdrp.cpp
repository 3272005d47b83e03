// Unity's High Definition Render Pipeline: HDRP/Lit, and a thread map for HDRP/Fabric. Based on: its manual.

#include <algorithm>

#include "base/mark.h"
#include "design/srgb.h"
#include "texture_set/targets.h"
#include "texture_set/targets/unity.h"

namespace weftlight::texture_set {

using design::srgb_encoded;
using draft::Face;
using light::EngineModel;

namespace {

using enum Channel;
using enum PixelType;

constexpr ImageRow kImages[] = {
    {"", "_BaseMap", ".png", kU8, true, kBaseCoverage},
    {"", "_MaskMap", ".png", kU8, false, {kMetal, kOcclusion, kOne, kSmoothness}},
    {"", "_NormalMap", ".png", kU8, false, kNormalUp},
    {"", "_ThreadMap", ".png", kU8, false, {kDetailOcclusion, kDetailNormalY, kDetailSmoothness, kDetailNormalX}},
};

constexpr UnitySlot kSlots[] = {{"_BaseMap", "_BaseColorMap"}, {"_MaskMap", "_MaskMap"}, {"_NormalMap", "_NormalMap"}};

/// Lit has either a specular colour or metal.
bool has_specular_color(const SetFacts& set, Face face) {
  const glm::vec3 more = glm::abs(set.of(face).fit().f0 - formulas::kEngineF0);
  return std::max({more.r, more.g, more.b}) > 1e-4f;
}

std::vector<std::string> keywords(const SetFacts& set, Face face) {
  std::vector<std::string> out{"_NORMALMAP", "_MASKMAP", "_NORMALMAP_TANGENT_SPACE"};
  if (has_specular_color(set, face)) out.emplace_back("_MATERIAL_FEATURE_SPECULAR_COLOR");
  return out;
}

/// With blending and depth of the passes, which the inspector derives from the surface options but an import does not.
/// Gaps have no highlight: the shader multiplies by alpha itself.
std::vector<std::string> floats(const SetFacts& set, Face face) {
  const bool blend = set.alpha == Alpha::kBlend, cut = cuts_out(set.alpha);
  const std::string over = blend ? "10" : "0";  // one minus alpha
  return {cut ? "_AlphaCutoffEnable: 1" : "_AlphaCutoffEnable: 0",
          "_AlphaCutoff: 0.5",
          blend ? "_SurfaceType: 1" : "_SurfaceType: 0",
          "_CullMode: 2",
          has_specular_color(set, face) ? "_MaterialID: 4" : "_MaterialID: 1",
          "_NormalScale: 1",
          "_Metallic: 1",
          "_UVBase: 0",
          "_ReceivesSSR: 1",
          "_BlendMode: 0",
          "_SrcBlend: 1",
          "_DstBlend: " + over,
          "_AlphaSrcBlend: 1",
          "_AlphaDstBlend: " + over,
          "_EnableBlendModePreserveSpecularLighting: 0",
          blend ? "_ZWrite: 0" : "_ZWrite: 1",
          "_TransparentZWrite: 0",
          blend ? "_ZTestDepthEqualForOpaque: 4" : "_ZTestDepthEqualForOpaque: 3",
          cut ? "_ZTestGBuffer: 3" : "_ZTestGBuffer: 4"};
}

/// sRGB encoded, as in the inspector.
std::vector<std::string> colors(const SetFacts& set, Face face) {
  if (!has_specular_color(set, face)) return {};
  const glm::vec3& f0 = set.of(face).fit().f0;
  const auto encoded = [](float v) { return number(static_cast<double>(srgb_encoded(v))); };
  return {"_SpecularColor: {r: " + encoded(f0.r) + ", g: " + encoded(f0.g) + ", b: " + encoded(f0.b) + ", a: 1}"};
}

constexpr UnityShader kLit{"6e4ae4064600d784cac1e41a9e6f2e59", kSlots, keywords, floats, colors};

}  // namespace

const ExportTarget targets::kUnityHdrp{
    .id = "unity-hdrp",
    .title = "Unity HDRP",
    .images = kImages,
    .model = {.sheen = formulas::kSheenNone, .most_f0 = 1, .grazing = false, .anisotropic = false, .tinted = true},
    .metal_model =
        EngineModel{
            .sheen = formulas::kSheenNone, .most_f0 = formulas::kEngineF0, .grazing = false, .anisotropic = false},
    .highlight = "GGX, specular colour (with metal yarns: the usual 0.04); round highlight",
    .sheen = "none",
    .names_dds = true,
    .keeps_masks = true,
    .material = ".mat",
    .write_material = [](const SetFacts& set) { return write_unity_material(set, kLit); },
    .note = base::mark("Copy this folder with its .meta files into Assets of your Unity project. {name}.mat is the "
                       "material of the front, {name}_back.mat that of the back: drag one onto a mesh. {name}_quad.obj "
                       "is a flat piece of 100 mm to try it on. BaseMap, MaskMap "
                       "and NormalMap are for HDRP/Lit (the .mat); ThreadMap is for the thread slot of HDRP/Fabric "
                       "over a base of your own, never together with them."),
};

}  // namespace weftlight::texture_set
