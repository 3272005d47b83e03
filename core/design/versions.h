#pragma once
// Versions of a design: states kept under a name in its file, among them colourways, which differ in colours alone.
// A version keeps what is woven: draft, yarns, finish, plan, weaves, sections, and what leads. Title, notes, look,
// scene, views and the places at the loom belong to the file and stay as they are.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "design/design.h"

namespace weftlight::design {

inline constexpr size_t kMaxVersions = 100, kLongestVersionName = 80;  // bytes of a name
/// Limit of the cells of all grids of all versions, so that a small file cannot take all memory.
inline constexpr int64_t kMaxVersionCells = draft::kMaxCells;
/// Cells of the grids of a draft.
int64_t grid_cells(const Draft& draft);

/// What a version keeps of the design; the rest is the default.
Design version_of(const Design& design);
/// Whether its present state may be kept as one more version.
bool has_room_for_version(const Design& design);
/// Keeps the present state under a name, which replaces the version of that name. Unchanged without a name or room.
Design with_version(Design design, std::string_view name);
/// The design with what the version keeps; everything else, and the versions, stay.
Design at_version(Design design, const Version& version);
/// Renames a version; a name that is taken gets a number. Unchanged without a name.
Design with_renamed_version(Design design, size_t version, std::string_view name);
Design without_version(Design design, size_t version);

/// The name without blanks around it, at most kLongestVersionName bytes.
std::string version_name(std::string_view typed);
/// The name, or that with a number if a version has it.
std::string unused_version_name(const std::vector<Version>& versions, const std::string& name);
/// "Version 3", an unused name.
std::string free_version_name(const Design& design);
/// The version of that name, or else one that differs in the case of ASCII letters; null if there is none.
const Version* version_named(const Design& design, std::string_view name);
/// The version that the design is now; null: none.
const Version* current_version(const Design& design);
/// True if the two differ in colours alone: in the palette, and in which thread has which colour.
bool is_colourway(const Design& a, const Design& b);

}  // namespace weftlight::design
