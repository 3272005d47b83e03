#include "texture_set/export_target.h"

#include "base/mark.h"

namespace weftlight::texture_set {
namespace {

// Coverage above which gaps stay opaque: blended cloth writes no depth, so that folds show through one another.
constexpr float kPinholes = 0.95f;

struct AlphaRow {
  Alpha alpha;
  const char* name;
};
constexpr AlphaRow kAlphas[] = {{Alpha::kAuto, "auto"},
                                {Alpha::kOpaque, "opaque"},
                                {Alpha::kMask, "mask"},
                                {Alpha::kHashed, "hashed"},
                                {Alpha::kBlend, "blend"}};

struct UvUnitRow {
  const char* name;
  const char* title;
};
constexpr UvUnitRow kUvUnits[] = {{"mm", base::mark("millimetres")},
                                  {"cm", base::mark("centimetres")},
                                  {"m", base::mark("metres")},
                                  {"tile", base::mark("tiles")}};

}  // namespace

const EngineModel& engine_model(const ExportTarget& target, bool metal) {
  return metal && target.metal_model ? *target.metal_model : target.model;
}

Alpha alpha_for(const ExportTarget& target, Alpha requested, float coverage) {
  if (requested == Alpha::kAuto) return coverage >= kPinholes ? Alpha::kOpaque : target.open;
  return requested == Alpha::kHashed && target.open == Alpha::kBlend ? Alpha::kBlend : requested;
}

std::optional<Alpha> alpha_named(const std::string& name) {
  for (const AlphaRow& row : kAlphas) {
    if (name == row.name) return row.alpha;
  }
  return std::nullopt;
}

std::optional<UvUnit> uv_unit_named(const std::string& name) {
  for (size_t i = 0; i < std::size(kUvUnits); ++i)
    if (name == kUvUnits[i].name) return static_cast<UvUnit>(i);
  return std::nullopt;
}

const char* uv_unit_name(UvUnit unit) { return kUvUnits[static_cast<size_t>(unit)].name; }

const char* uv_unit_title(UvUnit unit) { return kUvUnits[static_cast<size_t>(unit)].title; }

const char* alpha_name(Alpha alpha) { return kAlphas[static_cast<size_t>(alpha)].name; }

}  // namespace weftlight::texture_set
