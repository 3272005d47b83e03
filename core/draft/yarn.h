#pragma once
// A yarn: what a thread is spun from and how it meets the light. WIF has no place for
// these, so they live in its private sections. Every number has its default here and its
// range, unit, words and source in yarn_fields.h.

#include <cstdint>
#include <string>

#include "draft/draft.h"

namespace weftlight::draft {

enum class Twist : uint8_t { kNone, kS, kZ };

/// The ways light leaves a yarn (shaders/lobes.glsl holds the formulas).
struct Lobes {
  // Specular along the fibre: Gaussian of micro-slopes, RMS along and across the fibre. A yarn is a bundle: light that
  // passes one clear fibre is mirrored by those below it.
  float specular = 1.0f;       // scale of the Fresnel reflectance
  Rgb specular_tint{1, 1, 1};  // 1 for dielectrics; the metal's colour for metallic yarns
  float ior = 1.53f;           // index of refraction
  float along_width = 0.25f;   // RMS slope along the fibre
  float across_width = 0.45f;  // RMS slope across the fibre
  float layers = 1.0f;         // of fibres that mirror, untinted
  float inner = 0.0f;          // share of it that went through fibres and left near the same cone, dyed
  // Body: light that entered and came out diffusely; times the thread's colour.
  float body = 1.0f;
  // Fuzz: fibres that stand off the yarn, seen at grazing angles and silhouettes.
  float fuzz = 0.15f;       // share of the area
  float fuzz_width = 0.5f;  // roughness of the sheen
  // Transmission: light from behind through the body (gaps are apart, in coverage).
  float transmission = 0.1f;  // of the body part
  bool metallic = false;      // specular takes the thread's colour, no body
  // Further numbers stand here, at the end: the ready yarns give theirs in this order, and need not name them.
  float inner_depth = 1.0f;  // way of the inner glow through the dye, over that through a round fibre
  bool operator==(const Lobes&) const = default;
};

struct Yarn {
  std::string name = "Cotton";
  float diameter_mm = 0.5f;  // used where the draft gives no thickness
  Twist twist = Twist::kZ;
  float turns_per_m = 550.0f;  // twist tightness
  int plies = 1;
  float fibre_um = 60.0f;      // width of the fibre bundles seen as grooves
  float groove_depth = 0.45f;  // darkness of the grooves
  float hairiness = 0.35f;     // noise of stray fibres
  float flattening = 0.8f;     // height over width of the cross-section in the cloth
  float irregularity = 0;      // standard deviation of the thickness between threads, over its mean
  float unevenness = 0;        // coefficient of variation of its mass along it, %
  float melange = 0;           // how unlike the colours of neighbouring fibres are
  Lobes lobes;
  float tex = 0;  // count, grams a kilometre; 0: none is set, it follows from the thickness (tex_of() in fibre.h)
  bool operator==(const Yarn&) const = default;
};

/// The yarn with every number inside its range (yarn_fields.h); what is not a number becomes the default.
Yarn clamped(Yarn yarn);

}  // namespace weftlight::draft
