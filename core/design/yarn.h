#pragma once
// A yarn: its construction and its optical parameters. WIF has no keys for them, so they are kept in private sections.
// Defaults are here; range, unit, label and source of each parameter in yarn_fields.h.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "draft/draft.h"

namespace weftlight::design {

using draft::Rgb;

enum class Twist : uint8_t { kNone, kS, kZ };

/// What a yarn is spun or thrown of, in the order of yarn_presets().
enum class Fibre : uint8_t { kCotton, kMercerisedCotton, kLinen, kSilk, kWool, kViscose, kPolyester, kMetallic };
inline constexpr int kFibres = 8;

/// Cross-section of a fibre. Round: wool, most filament; trilobal: silk, bright filament; bean: cotton; flat: slit
/// film.
enum class CrossSection : uint8_t { kRound, kTrilobal, kBean, kFlat };
inline constexpr int kCrossSections = 4;

/// The lobes of a yarn's BSDF (formulas in shaders/lobes.glsl).
struct Lobes {
  // Specular: Gaussian of micro-slopes, RMS along and across the fibre. Light that passes the first fibres of the yarn
  // is reflected by the fibres below.
  float specular = 1.0f;       // scale of the Fresnel reflectance
  Rgb specular_tint{1, 1, 1};  // 1 for dielectrics; the metal's colour for metallic yarns
  float ior = 1.53f;           // index of refraction
  float along_width = 0.25f;   // RMS slope along the fibre
  float across_width = 0.45f;  // RMS slope across the fibre
  float layers = 1.0f;         // fibre layers that reflect, untinted
  float inner = 0.0f;          // fraction of it that passed through fibres, tinted (volume scattering)
  float inner_depth = 1.0f;    // path of the inner part through the dye, relative to a round fibre
  // Body: diffuse reflection, times the thread's colour.
  float body = 1.0f;
  // Fuzz: fibres that stand off the yarn, seen at grazing angles and silhouettes.
  float fuzz = 0.15f;       // fraction of the area
  float fuzz_width = 0.5f;  // roughness of the sheen
  // Transmission: diffuse light from behind; the gaps between threads are in the coverage.
  float transmission = 0.1f;  // fraction of the body
  bool metallic = false;      // specular has the thread's colour, no body
  bool operator==(const Lobes&) const = default;
};

/// A stretch of a thread in one colour; its length is the number of threads that it crosses.
struct DyedStretch {
  int threads = 8;           // 1..kMaxDyedThreads
  std::optional<Rgb> color;  // in steps of 8 bits; none: the thread's own
  bool fades = false;        // gradually becomes the next stretch's colour
  bool operator==(const DyedStretch&) const = default;
};

/// Colours along a thread, as in a painted warp, an ikat or a space-dyed yarn. The sequence starts with the first
/// thread of the draft that it crosses, and repeats. Functions in dye.h.
struct Dye {
  std::vector<DyedStretch> stretches;  // empty: the thread has one colour
  int shift = 0;                       // threads by which each thread's sequence starts earlier than the one before
  int scatter = 0;                     // moves each thread's by at most so many to either side, at random
  bool operator==(const Dye&) const = default;
};

struct Yarn {
  std::string name = "Cotton";
  Fibre fibre = Fibre::kCotton;
  CrossSection section = CrossSection::kBean;  // of its fibres
  float diameter_mm = 0.5f;                    // where the draft gives no thickness
  Twist twist = Twist::kZ;
  float turns_per_m = 550.0f;  // of the last twist
  int plies = 1;
  float fibre_um = 60.0f;      // width of the fibre bundles between grooves
  float groove_depth = 0.45f;  // darkness of the grooves
  float hairiness = 0.35f;     // noise of flyaway fibres
  float flattening = 0.8f;     // height over width of the cross-section in the cloth
  float irregularity = 0;      // standard deviation of the thickness between threads, over its mean
  float unevenness = 0;        // coefficient of variation of the mass along the yarn (Uster CVm), %
  float melange = 0;           // difference in colour of neighbouring fibres
  Lobes lobes;
  float tex = 0;  // count, g/km; 0: not set, follows from the thickness (tex_of() in fibre.h)
  Dye dye = {};
  bool operator==(const Yarn&) const = default;
};

}  // namespace weftlight::design
