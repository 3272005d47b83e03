#pragma once
// The family of a weave, found in its drawdown: what a weaver would call it at a glance. Whatever fits no description
// below is kOther, and says so.

#include <array>
#include <optional>
#include <string_view>

#include "base/mark.h"
#include "draft/bit_matrix.h"

namespace weftlight::analysis {

using draft::BitMatrix;

enum class WeaveFamily {
  kOther,
  kPlain,     // every end and pick alternate, by one
  kBasket,    // ends, picks or both alternate in groups: basket weave, ribs
  kTwill,     // threads repeat each other shifted by one: straight, pointed, undulating or broken; corkscrew
  kSatin,     // single crossings, shifted by the same step of two and more, none touching
  kBlock,     // areas of a twill or satin beside areas of its reverse: damask, turned twill
  kLace,      // spots of floats in plain weave: huck, Bronson, spot weaves
  kPattern,   // pattern threads float over plain weave, or blocks of a 2/2 twill: overshot, summer and winter, taquete
  kDouble,    // two and more cloths in one, whole or stitched, in blocks or stripes: double weave
  kCells,     // long floats between plain weave draw the cloth into cells: waffle, honeycomb
  kParallel,  // two warps or wefts in turn follow one line: echo weave, jin, shadow weave
};
inline constexpr size_t kWeaveFamilies = 11;

struct WeaveFamilyName {
  const char *id, *label;  // label: to be shown through base::tr()
};
/// By value of WeaveFamily.
inline constexpr std::array<WeaveFamilyName, kWeaveFamilies> kWeaveFamilyNames{{
    {"other", base::mark("Other weave")},
    {"plain", base::mark("Plain weave")},
    {"basket", base::mark("Basket weave and ribs")},
    {"twill", base::mark("Twill")},
    {"satin", base::mark("Satin")},
    {"block", base::mark("Damask and turned twill")},
    {"lace", base::mark("Lace and spot weave")},
    {"pattern", base::mark("Overshot and other pattern threads")},
    {"double", base::mark("Double weave")},
    {"cells", base::mark("Waffle and honeycomb")},
    {"parallel", base::mark("Echo, jin and shadow weave")},
}};

/// `cells`: picks x ends of one face; the drawdown repeats in both directions. Of a large one the first 512 of each are
/// looked at, but for double weave, which counts all.
WeaveFamily weave_family(const BitMatrix& cells);
std::optional<WeaveFamily> family_of_id(std::string_view id);

}  // namespace weftlight::analysis
