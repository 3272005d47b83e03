#pragma once
// A yarn in a weaver's terms: fibre, cross-section of the fibre, lustre, hairiness. The yarn names its fibre and its
// section; lustre and hairiness are computed from the parameters of yarn_fields.h, relative to the usual yarn of that
// fibre, and set them.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/mark.h"
#include "design/yarn.h"

namespace weftlight::design {

/// As a list shows them. A file names a fibre by its usual yarn (yarn_presets.h).
inline constexpr std::array<const char*, kFibres> kFibreNames{
    base::mark("Cotton"), base::mark("Mercerised cotton"), base::mark("Linen"),     base::mark("Silk"),
    base::mark("Wool"),   base::mark("Viscose"),           base::mark("Polyester"), base::mark("Metallic")};

inline const char* fibre_name(Fibre fibre) { return kFibreNames[static_cast<size_t>(fibre)]; }

/// By the English name of the usual yarn, or of the section, in any case.
std::optional<Fibre> fibre_from_name(std::string_view name);
std::optional<CrossSection> section_from_name(std::string_view name);
/// The yarn made of another fibre: takes the lobes, grooves and hairiness of its usual yarn; name, thickness, twist and
/// evenness stay.
Yarn with_fibre(Yarn yarn, Fibre fibre);
/// The yarn with the fibre and the section of the usual yarn that is most similar to it, regardless of lustre and
/// hairiness: for files that do not name them.
Yarn with_recognised_fibre(Yarn yarn);
/// The same where the fibre is named and its section is not.
Yarn with_recognised_section(Yarn yarn);

inline constexpr std::array<const char*, kCrossSections> kCrossSectionNames{
    base::mark("Round"), base::mark("Trilobal"), base::mark("Bean"), base::mark("Flat film")};

/// The same yarn made of fibres of another cross-section.
Yarn with_cross_section(Yarn yarn, CrossSection section);

/// 0 (dull) to 1 (bright); 1/2 for the usual yarn of its fibre and cross-section. Computed from the spread along the
/// fibre.
float lustre(const Yarn& yarn);
/// A brighter fibre has a narrower highlight (along) from more clear layers; both are clamped to their ranges.
Yarn with_lustre(Yarn yarn, float lustre);

/// Flyaway fibres (0..1), and the fuzz in the same ratio to them as in the preset of the fibre.
Yarn with_hairiness(Yarn yarn, float hairiness);

/// Count in tex, g/km: the one that is set, otherwise that of a round thread of its fibre and diameter with the packing
/// of the preset.
float tex_of(const Yarn& yarn);
/// Count of a thread of the given thickness, proportional to its cross-section.
float tex_of(const Yarn& yarn, float thickness_mm);
/// Fraction of the thread's volume that is fibre: 0.6 for cotton, 0.2 for a lofty woollen; 0 without thickness. The
/// densest packing of round fibres is 0.91.
double packing_fraction(const Yarn& yarn);
/// Diameter of a thread of the given thickness in the cloth before it is woven, by its count and the packing of such
/// yarns as they are spun: a soft yarn opens when it is washed, and its sett is chosen before. A film keeps its own.
double spun_diameter_mm(const Yarn& yarn, float thickness_mm);
/// Another thickness of the same yarn; a set count changes with the cross-section.
Yarn with_thickness(Yarn yarn, float diameter_mm);
/// The yarn with a written count, "Ne 8/2" or "30 tex" (count.h), and its thickness scaled accordingly. "": unsets the
/// count and keeps the thickness. Empty if the text cannot be read.
std::optional<Yarn> with_count(Yarn yarn, std::string_view count);

}  // namespace weftlight::design
