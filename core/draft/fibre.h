#pragma once
// A yarn as a weaver speaks of it: its fibre and that fibre's shape, how it shines, how hairy it is. Each is a choice
// of the numbers of yarn_fields.h, measured against the ready yarn of that fibre; nothing of it is kept beside them.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "draft/yarn.h"

namespace weftlight::draft {

/// Index among yarn_presets() of the one that is most like it, whatever its lustre and hairiness.
int fibre_of(const Yarn& yarn);
/// The yarn spun from that preset's fibre: its light, grooves and hairiness; name, thickness, twist and spinning stay.
Yarn with_fibre(Yarn yarn, int preset);

/// What a fibre looks like where it is cut: wool and melt-spun filament, silk and bright filament, cotton, slit film.
enum class CrossSection : uint8_t { kRound, kTrilobal, kBean, kFlat };
inline constexpr std::array<const char*, 4> kCrossSectionNames{"Round", "Trilobal", "Bean", "Flat film"};

/// The one that is most like it, by the colour that its inner glow has.
CrossSection cross_section(const Yarn& yarn);
/// The same yarn of fibres of another shape. A ready yarn in its own shape is as it was.
Yarn with_cross_section(Yarn yarn, CrossSection section);

/// 0 (dull) to 1 (bright); 1/2 as the ready yarn of its fibre, in its shape, shines. From the spread along the fibre.
float lustre(const Yarn& yarn);
/// A brighter fibre has a narrower highlight (along) from more clear layers; held in their ranges.
Yarn with_lustre(Yarn yarn, float lustre);

/// Stray fibres (0..1) and with them the fuzz that stands off, in the ratio that the fibre's ready yarn has.
Yarn with_hairiness(Yarn yarn, float hairiness);

/// Its count in tex, grams a kilometre: the one that is set, else that of a round thread of its fibre so thick, packed
/// as its ready yarn is.
float tex_of(const Yarn& yarn);
/// Of a thread that the draft makes so thick, mm: as its section.
float tex_of(const Yarn& yarn, float thickness_mm);
/// Share of its thickness that is fibre: 0.6 of cotton, 0.2 of a lofty woollen; 0 of none. More than 0.91 cannot be.
double packing_fraction(const Yarn& yarn);
/// Another thickness of the same yarn: a count that is set becomes that of its section.
Yarn with_thickness(Yarn yarn, float diameter_mm);
/// Of that count, "Ne 8/2" or "30 tex" (count.h), and as much thicker or thinner. "": not set any more; the thickness
/// stays. None: not understood.
std::optional<Yarn> with_count(Yarn yarn, std::string_view count);

}  // namespace weftlight::draft
