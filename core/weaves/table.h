#pragma once
// The table of weaves. Dialogs, commands and files use it.

#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "weaves/weave_kind.h"
#include "weaves/weave_values.h"
#include "weaves/weaves.h"

namespace weftlight::weaves {

using design::Design, design::WeaveUse;

/// In menu order, grouped by family.
std::span<const WeaveKind> weave_kinds();
const WeaveKind* find_weave(std::string_view id);
/// A value for every parameter; given values are clamped to their ranges.
WeaveValues complete_values(const WeaveKind& kind, const WeaveValues& given);
/// The same, with each count changed to the nearest allowed one.
WeaveValues allowed_values(const WeaveKind& kind, const WeaveValues& given);
/// Whether these values make a weave, or the error: a ratio that cannot be read.
base::Result<void> check_values(const WeaveKind& kind, const WeaveValues& values);
/// One repeat of the weave with its colours. 0 if that is more than 1,024 threads.
ClothSize repeat_of(const WeaveKind& kind, const WeaveValues& values);
/// Said of a weave whose repeat is longer than the threads that it gets; empty: it is not, or repeat_of knows none.
std::string cut_repeat_note(const WeaveKind& kind, const WeaveValues& values, ClothSize room);
/// The whole number of repeats nearest to `about`, at least one; `about` if there is no repeat.
ClothSize whole_repeats(ClothSize repeat, ClothSize about);

/// A new draft of the requested size with the weave in its colours; the parameters are stored with it.
GeneratedWeave new_draft(const WeaveKind& kind, const WeaveValues& values, ClothSize size);

/// Applies a weave to threads of a draft. Applied to all threads, it replaces threading, tie-up and treadling; size,
/// yarns and (unless the weave has its own) colours stay. Applied to some, only their crossings change (factor.h).
/// `use` is stored instead of weaves that it overlaps. Refused as check_values(), and beyond the loom's limits.
base::Result<GeneratedWeave> with_weave(Design design, const WeaveUse& use);

}  // namespace weftlight::weaves
