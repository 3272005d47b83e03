#pragma once
// The table of export targets. The command line, the export dialog, docs and tests read it; a new target is a file in
// targets/ and its name here, in both lists.

#include <array>
#include <span>
#include <string_view>

#include "texture_set/export_target.h"

namespace weftlight::texture_set {
namespace targets {

extern const ExportTarget kGltf, kBlender, kEevee, kUnreal, kUnityHdrp, kUnityUrp, kGodot, kMaterialX, kU3m, kRaw;

}  // namespace targets

/// In the order in which lists show them.
inline constexpr std::array kTargets{&targets::kGltf,      &targets::kBlender,   &targets::kEevee,    &targets::kUnreal,
                                     &targets::kMaterialX, &targets::kUnityHdrp, &targets::kUnityUrp, &targets::kGodot,
                                     &targets::kU3m,       &targets::kRaw};

/// A table of targets: kTargets, or a longer one.
using TargetTable = std::span<const ExportTarget* const>;

/// The target with this id; nullptr if the table has none.
const ExportTarget* target_named(std::string_view id, TargetTable table = kTargets);

}  // namespace weftlight::texture_set
