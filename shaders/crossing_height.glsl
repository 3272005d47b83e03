// Heights of the threads where they cross, over the middle plane of the cloth. GLSL 3.30 and C++20
// (core/cloth/centre_line.cpp). Millimetres.
//
// Based on: F. T. Peirce, The Geometry of Cloth Structure, 1937 (the crimp heights of warp and weft add up to the sum of
// the two thicknesses), and N. Adabala, N. Magnenat-Thalmann, G. Fei, Real-time Rendering of Woven Clothes, 2003, section
// 3.4 (a facet rises with its float's length up to a bound). The slope: E. Catmull, R. Rom, A Class of Local
// Interpolating Splines, 1974, with tension.

#ifndef FORMULA
#define FORMULA
#endif

// A float's height depends on its ends up to this many threads away; further away it has reached the bound of the
// weave's tightness.
const int kFloatCells = 4;
// An unconstrained float rises by at most this fraction of its thickness in an open cloth; touching neighbours hold it
// down (no source; by eye against macro photographs of satin).
const float kRise = 0.36f;
const float kHeldByNeighbours = 0.45f;
const float kTension = 0.75f;   // 1: Catmull and Rom's spline; smaller values bulge less
// Least fraction of the crimp that the stiffer system takes. Small, since a thick thread cannot bend around fine ones
// that lie closer than its own radius.
const float kMinCrimpFraction = 0.02f;
const float kMinStep_mm = 2.0e-6f;   // between the threads before and after a crossing

// Relative rise of a float at a crossing with `before` and `after` more crossings to its ends: 0 for a float of one,
// 1 far from the ends.
FORMULA float rise_of(int before, int after) {
  float a = float(before) + 0.5f;
  float b = float(after) + 0.5f;
  return 1.0f - exp(-1.1f * (a * b / (a + b) - 0.25f));
}

// By how much the longest float of a thread of this section rises.
FORMULA float longest_rise(float width, float height, float spacing) {
  float tightness = min(1.0f, width / max(spacing, 1.0e-6f));
  return kRise * height * (1.0f - kHeldByNeighbours * tightness);
}

// Bending stiffness over span cubed. Stiffness goes with the diameter squared, since the fibres of a spun yarn slide;
// for a solid rod it would be the fourth power.
FORMULA float bending_stiffness(float width, float height, float span) {
  return width * height / (span * span * span);
}

// Fraction of the crimp that the warp takes.
FORMULA float crimp_fraction(float warp_stiffness, float weft_stiffness) {
  float sum = warp_stiffness + weft_stiffness;
  return sum > 0.0f ? clamp(weft_stiffness / sum, kMinCrimpFraction, 1.0f - kMinCrimpFraction) : 0.5f;
}

// Slope of a centre line at a crossing, from the heights of the crossings before and after and their distance.
FORMULA float centre_slope(float before, float after, float distance_between) {
  return kTension * (after - before) / distance_between;
}
