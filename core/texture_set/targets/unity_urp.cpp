// Unity's Universal Render Pipeline: URP/Lit. Based on: its manual.

#include "base/mark.h"
#include "texture_set/targets.h"
#include "texture_set/targets/unity.h"

namespace weftlight::texture_set {

using draft::Face;

namespace {

using enum Channel;
using enum PixelType;

constexpr ImageRow kImages[] = {
    {"", "_BaseMap", ".png", kU8, true, kBaseCoverage},
    {"", "_MetallicSmoothness", ".png", kU8, false, {kMetal, kMetal, kMetal, kSmoothness}},
    {"", "_Normal", ".png", kU8, false, kNormalUp},
    {"", "_Occlusion", ".png", kU8, false, only(kOcclusion)},
};

constexpr UnitySlot kSlots[] = {{"_BaseMap", "_BaseMap"},
                                {"_MetallicSmoothness", "_MetallicGlossMap"},
                                {"_Normal", "_BumpMap"},
                                {"_Occlusion", "_OcclusionMap"}};

std::vector<std::string> keywords(const SetFacts&, Face) {
  return {"_NORMALMAP", "_METALLICSPECGLOSSMAP", "_OCCLUSIONMAP"};
}

/// With blending and depth of the passes, which the inspector derives from the surface options but an import does not.
/// Gaps have no highlight.
std::vector<std::string> floats(const SetFacts& set, Face) {
  const bool blend = set.alpha == Alpha::kBlend, cut = cuts_out(set.alpha);
  const std::string over = blend ? "10" : "0";  // one minus alpha
  return {cut ? "_AlphaClip: 1" : "_AlphaClip: 0",
          "_Cutoff: 0.5",
          blend ? "_Surface: 1" : "_Surface: 0",
          "_Blend: 0",
          "_Cull: 2",
          "_BumpScale: 1",
          "_Metallic: 1",
          "_Smoothness: 1",
          "_OcclusionStrength: 1",
          "_WorkflowMode: 1",
          "_BlendModePreserveSpecular: 0",
          blend ? "_SrcBlend: 5" : "_SrcBlend: 1",
          "_DstBlend: " + over,
          "_SrcBlendAlpha: 1",
          "_DstBlendAlpha: " + over,
          cut ? "_AlphaToMask: 1" : "_AlphaToMask: 0",
          blend ? "_ZWrite: 0" : "_ZWrite: 1"};
}

std::vector<std::string> colors(const SetFacts&, Face) { return {}; }

constexpr UnityShader kLit{"933532a4fcc9baf4fa0491de14d08ed7", kSlots, keywords, floats, colors};

}  // namespace

const ExportTarget targets::kUnityUrp{
    .id = "unity-urp",
    .title = "Unity URP",
    .images = kImages,
    .model = {.sheen = formulas::kSheenNone, .most_f0 = formulas::kEngineF0, .grazing = false, .anisotropic = false},
    .highlight = "GGX, round; its reflectance is fixed",
    .sheen = "none",
    .names_dds = true,
    .keeps_masks = true,
    .material = ".mat",
    .write_material = [](const SetFacts& set) { return write_unity_material(set, kLit); },
    .note = base::mark("Copy this folder with its .meta files into Assets of your Unity project. {name}.mat is the "
                       "material of the front, {name}_back.mat that of the back: drag one onto a mesh. {name}_quad.obj "
                       "is a flat piece of 100 mm to try it on."),
};

}  // namespace weftlight::texture_set
