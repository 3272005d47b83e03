#pragma once
// The table of a yarn's parameters: label, unit, range and source. The private section of WIF files, the yarn panel,
// the bounds of the lobes and docs/yarns.md are made from it; defaults are in yarn.h.

#include <array>

#include "base/mark.h"
#include "design/yarn.h"

namespace weftlight::design {

struct FieldFacts {
  const char* key;    // in the private section of a file, after the yarn's number
  const char* id;     // of its control, after "yarn."
  const char* label;  // of its control; show tr(label), tr(tip)
  const char* unit;   // "" for a fraction or a ratio
  int decimals;       // displayed
  float low, high;    // range; values outside are clamped
  float from, to;     // of the slider: usual yarns; the whole range can be typed
  bool logarithmic;   // the slider is logarithmic
  const char* tip;
  const char* source;     // of default and range; for the presets see yarn_presets.cpp
  bool optics = false;    // shown under Optics, as are all lobes
  bool optional = false;  // 0: not set, and not written to the file
};

template <class T>
struct YarnField {
  FieldFacts facts;
  float T::*member;
};

inline constexpr FieldFacts kPliesFacts{"Plies",
                                        "plies",
                                        base::mark("Plies"),
                                        "",
                                        0,
                                        1,
                                        8,
                                        1,
                                        8,
                                        false,
                                        base::mark("Number of singles plied together"),
                                        "weaving yarns are singles to four plies, cords up to eight"};

/// Not a parameter of its own but computed from others: fibre.h.
inline constexpr FieldFacts kLustreFacts{"",
                                         "lustre",
                                         base::mark("Lustre"),
                                         "",
                                         2,
                                         0,
                                         1,
                                         0,
                                         1,
                                         false,
                                         base::mark("Dull to bright; 0.5 is usual for the fibre"),
                                         "spread along the fibre and fibre layers of the yarns in docs/measured.md"};

inline constexpr std::array<YarnField<Yarn>, 10> kYarnFields{{
    {{"Diameter", "diameter_mm", base::mark("Thickness"), "mm", 2, 0, 50, 0.05f, 5, true,
      base::mark("Diameter, where the draft gives none"), "cotton Ne 8/2 rounded up; to 50 mm for rope"},
     &Yarn::diameter_mm},
    {{"Tex", "count", base::mark("Count"), "tex", 1, 0, 100'000, 0, 1000, false,
      base::mark("Weight per length; 0 (empty in the panel): follows from the thickness"),
      "grams per kilometre (ISO 1144); unset: densities and packing of fibre.cpp; to 100 g a metre for rope", false,
      true},
     &Yarn::tex},
    {{"Turns", "turns_per_m", base::mark("Twist"), "/m", 0, 0, 5000, 0, 2000, false,
      base::mark("Turns per metre: how steeply the fibres wind"),
      "41 degrees on 0.5 mm, so that twist is seen; crepe has 2000 to 4000"},
     &Yarn::turns_per_m},
    {{"Fibre", "fibre_um", base::mark("Fibre bundles"), "\xC2\xB5m", 0, 1, 2000, 5, 500, true,
      base::mark("Width of the fibre bundles between the grooves of the twist"),
      "VRST 2003, figure 3 (\"thickness\"): a few cotton fibres of 12 to 20 \xC2\xB5m; 2 mm is a slit film", true},
     &Yarn::fibre_um},
    {{"Grooves", "groove_depth", base::mark("Grooves"), "", 2, 0, 1, 0, 1, false,
      base::mark("Darkness of the grooves between the fibre bundles"), "VRST 2003, section 3.2; by eye", true},
     &Yarn::groove_depth},
    {{"Hairiness", "hairiness", base::mark("Hairiness"), "", 2, 0, 1, 0, 1, false,
      base::mark("Flyaway fibres; they add noise along the thread"),
      "rank of the Uster hairiness, wool 0.65 to filament 0.02"},
     &Yarn::hairiness},
    {{"Flattening", "flattening", base::mark("Roundness"), "", 2, 0.3f, 1, 0.3f, 1, false,
      base::mark("Height over width of the thread in the cloth; 1 is round"),
      "Peirce 1937: 0.6 to 0.8 in cotton cloth"},
     &Yarn::flattening},
    {{"Irregularity", "irregularity", base::mark("Variation"), "", 2, 0, 0.6f, 0, 0.4f, false,
      base::mark("Thickness variation from thread to thread"),
      "standard deviation over mean: filament 0.01, combed cotton 0.05, woollen 0.1, slub yarn 0.2 and more"},
     &Yarn::irregularity},
    {{"Unevenness", "unevenness", base::mark("Unevenness"), "%", 0, 0, 100, 0, 60, false,
      base::mark("Thick and thin places along the thread (Uster CVm); above 30 slubs"),
      "Uster Statistics: filament 1, combed cotton 12, carded and worsted 16, woollen 20, wet-spun linen 24; slub 40"},
     &Yarn::unevenness},
    {{"Melange", "melange", base::mark("Melange"), "", 2, 0, 1, 0, 1, false,
      base::mark("Fibres of different colours spun together: heather, flannel"), "0: dyed as yarn or piece; by eye"},
     &Yarn::melange},
}};

inline constexpr std::array<YarnField<Lobes>, 11> kLobeFields{{
    {{"Specular", "specular", base::mark("Specular"), "", 2, 0, 1, 0, 1, false,
      base::mark("Strength of the specular reflection along the fibres"), "1: the reflectance of Fresnel's equations"},
     &Lobes::specular},
    {{"IOR", "ior", base::mark("Refraction"), "", 2, 1, 3, 1, 3, false,
      base::mark("Index of refraction: cotton 1.53, silk 1.56, polyester 1.6"),
      "cellulose across the fibre; Morton and Hearle, chapter 24"},
     &Lobes::ior},
    {{"Along", "along_width", base::mark("Roughness along"), "", 2, 0, 4, 0.02f, 2, true,
      base::mark("RMS slope along the fibre: small is glossy, large is dull"),
      "Sadeghi et al. 2013: tangents of 2.5 to 18 degrees; from 4 on a surface is matt all over"},
     &Lobes::along_width},
    {{"Across", "across_width", base::mark("Roughness across"), "", 2, 0, 4, 0.02f, 2, true,
      base::mark("RMS slope across the fibre"), "spread of fibres within a thread's surface; range as along"},
     &Lobes::across_width},
    {{"Layers", "layers", base::mark("Fibre layers"), "", 1, 1, 16, 1, 10, false,
      base::mark("Layers of clear fibres that reflect, one below the other: more is brighter, untinted"),
      "Stokes 1862 (pile of plates); fitted to measured cloths, docs/measured.md"},
     &Lobes::layers},
    {{"Inner", "inner", base::mark("Internal scattering"), "", 2, 0, 1, 0, 1, false,
      base::mark("Fraction of the highlight that passed through the fibres and is tinted by the dye"),
      "Sadeghi et al. 2013 (volume scattering); fitted to measured cloths"},
     &Lobes::inner},
    {{"Inner Depth", "inner_depth", base::mark("Scatter depth"), "", 2, 0, 2, 0, 2, false,
      base::mark(
          "Path of the scattered light through the dye: 1 has the thread's colour, less is paler, more is deeper"),
      "Bouguer's law over the mean chord of the fibre (Cauchy: round 1, bean 0.76, slit film 0.3): the colour to that "
      "power, exact at 0.5, 1 and 2, within 0.02 between; below by up to 0.12 less, and no further than 0.25"},
     &Lobes::inner_depth},
    {{"Body", "body", base::mark("Diffuse"), "", 2, 0, 1, 0, 1, false,
      base::mark("Diffuse reflection in the thread's colour"), "1: the cloth has the colour that was picked"},
     &Lobes::body},
    {{"Fuzz", "fuzz", base::mark("Fuzz"), "", 2, 0, 1, 0, 1, false,
      base::mark("Protruding fibres, seen at grazing angles and at silhouettes"),
      "fraction of the area; by eye, wool 0.35 to filament 0.02"},
     &Lobes::fuzz},
    {{"Fuzz Width", "fuzz_width", base::mark("Fuzz spread"), "", 2, 0.05f, 1, 0.05f, 1, false,
      base::mark("Roughness of the fuzz"), "its square is the layer's optical depth (Koenderink and Pont 2003)"},
     &Lobes::fuzz_width},
    {{"Transmission", "transmission", base::mark("Translucency"), "", 2, 0, 1, 0, 1, false,
      base::mark("Fraction of the diffuse light that is transmitted from behind"),
      "by eye, in the order of the fibres' lustre"},
     &Lobes::transmission},
}};

/// By value of the enum Twist, as files name them.
inline constexpr std::array<const char*, 3> kTwistNames{"none", "S", "Z"};

/// The yarn with every parameter clamped to its range; NaN becomes the default.
Yarn clamped(Yarn yarn);
/// The same for the lobes alone.
Lobes clamped(Lobes lobes);

}  // namespace weftlight::design
