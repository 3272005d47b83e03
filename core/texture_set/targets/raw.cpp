// The maps of the cloth itself, for programs and renderers of one's own: nothing is fitted, and there is no material.

#include "base/mark.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {
namespace {

using enum Channel;
using enum PixelType;

constexpr ImageRow kImages[] = {
    {"", "_albedo", ".exr", kHalf, false, kBaseColor},
    {"", "_coverage", ".png", kU16, false, only(kCoverage)},
    {"", "_height", ".exr", kHalf, false, only(kHeightMm)},
    {"", "_normal", ".png", kU16, false, kNormalUp},
    {"", "_tangent", ".png", kU16, false, {kFibreX, kFibreY, kFibreZ, kNone}},
    {"", "_roughness", ".png", kU16, false, {kRoughnessAlong, kRoughnessAcross, kMetal, kNone}},
    {"", "_occlusion", ".png", kU16, false, only(kOcclusion)},
    {"", "_thread", ".png", kU16, false, {kThreadLow, kThreadHigh, kSystem, kNone}},
};

}  // namespace

const ExportTarget targets::kRaw{
    .id = "raw",
    .title = base::mark("Raw maps"),
    .images = kImages,
    .front = "_front",
    .model = {.sheen = formulas::kSheenNone, .most_f0 = 1, .grazing = true, .anisotropic = true},
    .raw = true,
    .keeps_masks = true,
    .note = base::mark("There is no material: give the maps to a shader of your own. {name}_front_albedo.exr is the "
                       "colour of the threads, {name}_front_height.exr their height in mm."),
};

}  // namespace weftlight::texture_set
