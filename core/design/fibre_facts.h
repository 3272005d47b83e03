#pragma once
// The fibres that a yarn is spun or thrown of, in numbers: what the traced fibres are made from.

#include "design/yarn.h"

namespace weftlight::design {

struct FibreFacts {
  double density_g_cm3 = 1.5;
  float fineness_dtex = 1.7f;  // g / 10 km of one fibre
  float spread = 0;            // standard deviation of a fibre's radius, over its mean
  float along_rad = 0.1f;      // RMS angle by which light leaves the cone of a smooth cylinder
  float across_rad = 0.15f;    // scale of the spread around it, of its section
  int in_bundle = 1;           // fibres that stay together, as the technical fibres of flax
  float disorder = 0.5f;       // wandering of a fibre, in mean distances between fibres
  float migration = 0.1f;      // part of its distance from the ply's axis that a fibre gives up on its way inwards
  float migrations = 1;        // ways in and out in a turn of the twist
  float hair_mm = 0.7f;        // mean length of a hair
  float hair_curl = 0.5f;      // bend of a hair, 1/mm
  bool metallic = false;
  float turbidity = 0;  // fraction of the light inside that delustrant, voids and fibrils scatter
};

/// Those of the yarn's fibre, with its section, lustre and dullness where the yarn's own differ.
FibreFacts fibre_facts(const Yarn& yarn);

/// Hair, in mm for each mm of yarn (Uster's H), by the yarn's hairiness; loops are counted beside it.
float hair_per_mm(const Yarn& yarn);

/// Radius of a round fibre of this fineness, mm.
float fibre_radius_mm(const FibreFacts& facts);

}  // namespace weftlight::design
