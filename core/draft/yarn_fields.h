#pragma once
// The one table of a yarn's numbers: what each is called, its unit, its range and where the figures come from. The
// file's private section, the yarn panel, the bounds of the lobes and docs/yarns.md read it; defaults stand in yarn.h.

#include <array>

#include "draft/yarn.h"

namespace weftlight::draft {

struct FieldFacts {
  const char* key;    // in the file's private section, after the yarn's number
  const char* id;     // of its control, after "yarn."
  const char* label;  // on its control
  const char* unit;   // "" for a share or a ratio
  int decimals;       // shown
  float low, high;    // range: what lies outside is held at its ends
  float from, to;     // of the slider's track: the yarns that are woven with; a figure can be typed to the whole range
  bool logarithmic;   // the track
  const char* tip;
  const char* source;     // of default and range; the ready yarns' figures are in yarn_presets.cpp
  bool optics = false;    // one fold below what a weaver turns, as are all lobes
  bool optional = false;  // 0: not set; then the file does not name it
};

template <class T>
struct YarnField {
  FieldFacts facts;
  float T::*member;
};

inline constexpr FieldFacts kPliesFacts{"Plies",
                                        "plies",
                                        "Plies",
                                        "",
                                        0,
                                        1,
                                        8,
                                        1,
                                        8,
                                        false,
                                        "Singles twisted together into the thread",
                                        "weaving yarns are singles to four plies, cords up to eight"};

/// Of no number of its own: fibre.h.
inline constexpr FieldFacts kLustreFacts{"",
                                         "lustre",
                                         "Lustre",
                                         "",
                                         2,
                                         0,
                                         1,
                                         0,
                                         1,
                                         false,
                                         "From dull to bright; in the middle as such a fibre is",
                                         "spread along the fibre and layers, of docs/measured.md's yarns"};

inline constexpr std::array<YarnField<Yarn>, 10> kYarnFields{{
    {{"Diameter", "diameter_mm", "Thickness", "mm", 2, 0, 50, 0.05f, 5, true,
      "Diameter, where the draft itself gives none", "cotton Ne 8/2 rounded up; to 50 mm for rope"},
     &Yarn::diameter_mm},
    {{"Tex", "count", "Count", "tex", 1, 0, 100'000, 0, 1000, false,
      "How heavy it is; 0, or nothing in the panel: not set, follows from the thickness",
      "grams a kilometre (ISO 1144); unset: fibre.cpp's densities and shares of fibre; to 100 g a metre for rope",
      false, true},
     &Yarn::tex},
    {{"Turns", "turns_per_m", "Twist", "/m", 0, 0, 5000, 0, 2000, false, "Turns in a metre: how steep the fibres wind",
      "41 degrees on 0.5 mm, so that twist is seen; crepe has 2000 to 4000"},
     &Yarn::turns_per_m},
    {{"Fibre", "fibre_um", "Fibre bundles", "\xC2\xB5m", 0, 1, 2000, 5, 500, true,
      "Width of the bundles seen between the grooves of the twist",
      "VRST 2003, figure 3 (\"thickness\"): a few cotton fibres of 12 to 20 \xC2\xB5m; 2 mm is a slit film", true},
     &Yarn::fibre_um},
    {{"Grooves", "groove_depth", "Grooves", "", 2, 0, 1, 0, 1, false, "How dark the grooves between the fibres are",
      "VRST 2003, section 3.2; by eye", true},
     &Yarn::groove_depth},
    {{"Hairiness", "hairiness", "Hairiness", "", 2, 0, 1, 0, 1, false, "Stray fibres: noise along the thread",
      "rank of the Uster hairiness, wool 0.65 to filament 0.02"},
     &Yarn::hairiness},
    {{"Flattening", "flattening", "Roundness", "", 2, 0.3f, 1, 0.3f, 1, false,
      "Height over width of the thread in the cloth: 1 is round", "Peirce 1937: 0.6 to 0.8 in cotton cloth"},
     &Yarn::flattening},
    {{"Irregularity", "irregularity", "Thick and thin", "", 2, 0, 0.6f, 0, 0.4f, false,
      "How unevenly the yarn is spun: spread of the threads' thickness",
      "standard deviation over mean: filament 0.01, combed cotton 0.05, woollen 0.1, slub yarn 0.2 and more"},
     &Yarn::irregularity},
    {{"Unevenness", "unevenness", "Slubs", "%", 0, 0, 100, 0, 60, false,
      "Thick and thin places along the thread: coefficient of variation of its mass (Uster CVm)",
      "Uster Statistics: filament 1, combed cotton 12, carded and worsted 16, woollen 20, wet-spun linen 24; slub 40"},
     &Yarn::unevenness},
    {{"Melange", "melange", "Melange", "", 2, 0, 1, 0, 1, false,
      "Fibres of unlike colours spun together: heather and flannel", "0: dyed as yarn or piece; by eye"},
     &Yarn::melange},
}};

inline constexpr std::array<YarnField<Lobes>, 11> kLobeFields{{
    {{"Specular", "specular", "Shine", "", 2, 0, 1, 0, 1, false, "Strength of the light mirrored along the fibres",
      "1: all that Fresnel's equations mirror"},
     &Lobes::specular},
    {{"IOR", "ior", "Refraction", "", 2, 1, 3, 1, 3, false,
      "Index of refraction: cotton 1.53, silk 1.56, polyester 1.6",
      "cellulose across the fibre; Morton and Hearle, chapter 24"},
     &Lobes::ior},
    {{"Along", "along_width", "Spread along", "", 2, 0, 4, 0.02f, 2, true,
      "RMS slope along the fibre: small is glossy, large is dull",
      "Sadeghi et al. 2013: tangents of 2.5 to 18 degrees; from 4 on a surface is matt all over"},
     &Lobes::along_width},
    {{"Across", "across_width", "Spread across", "", 2, 0, 4, 0.02f, 2, true, "RMS slope across the fibre",
      "spread of fibres within a thread's surface; range as along"},
     &Lobes::across_width},
    {{"Layers", "layers", "Fibre layers", "", 1, 1, 16, 1, 10, false,
      "Layers of clear fibres that mirror, one below the other: more is brighter, without colour",
      "Stokes 1862 (pile of plates); fitted to measured cloths, docs/measured.md"},
     &Lobes::layers},
    {{"Inner", "inner", "Inner glow", "", 2, 0, 1, 0, 1, false,
      "Share of the shine that went through the fibres and has the thread's colour",
      "Sadeghi et al. 2013 (volume scattering); fitted to measured cloths"},
     &Lobes::inner},
    {{"Inner Depth", "inner_depth", "Inner colour", "", 2, 0, 2, 0, 2, false,
      "How far through the dye the inner glow went: 1 has the thread's colour, less is paler, more is deeper",
      "Bouguer's law over the mean chord of the fibre (Cauchy: round 1, bean 0.76, slit film 0.3): the colour to that "
      "power, exact at 0.5, 1 and 2, within 0.02 between; below by up to 0.12 less, and no further than 0.25"},
     &Lobes::inner_depth},
    {{"Body", "body", "Body", "", 2, 0, 1, 0, 1, false,
      "Light that entered the thread and leaves it in the thread's colour", "1: the colour picked is what is seen"},
     &Lobes::body},
    {{"Fuzz", "fuzz", "Fuzz", "", 2, 0, 1, 0, 1, false, "Fibres that stand off, seen at grazing angles and at the edge",
      "share of the area; by eye, wool 0.35 to filament 0.02"},
     &Lobes::fuzz},
    {{"Fuzz Width", "fuzz_width", "Fuzz spread", "", 2, 0.05f, 1, 0.05f, 1, false, "Roughness of the fuzz",
      "its square is the layer's optical depth (Koenderink and Pont 2003)"},
     &Lobes::fuzz_width},
    {{"Transmission", "transmission", "Translucence", "", 2, 0, 1, 0, 1, false,
      "Share of the body's light that passes through from behind", "by eye, in the order of the fibres' lustre"},
     &Lobes::transmission},
}};

/// By value of the enum Twist, as the file says it.
inline constexpr std::array<const char*, 3> kTwistNames{"none", "S", "Z"};

/// As clamped(Yarn) in yarn.h, of the lobes alone.
Lobes clamped(Lobes lobes);

}  // namespace weftlight::draft
