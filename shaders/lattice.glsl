// Where rung `yarn` takes its samples in a pixel, and how many: rank-1 lattices of 1 to 34 points (Fibonacci's numbers),
// each enough up to a footprint that was measured (core/light/lod_table.h). GLSL 3.30 and C++20.
//
// Based on: Dammertz, Keller 2008 (image synthesis by rank-1 lattices); Roberts 2018 (R2: the shift of each pass, so
//   that passes fill in what the ones before left).

#ifndef FORMULA
#define FORMULA
#endif

const int kLattices = 8;            // of 1, 2, 3, 5, 8, 13, 21, 34 points
const int kMaxYarnSamples = 34;

// Points of lattice i, and the generator that spreads them most evenly.
FORMULA ivec2 lattice_of(int i) {
  int before = 1;
  int points = 1;
  for (int k = 1; k < kLattices; ++k) {
    int next = points + before;
    before = k <= i ? points : before;
    points = k <= i ? next : points;
  }
  return ivec2(points, points - before);
}

// Place of sample i in pass `pass`, -0.5 to 0.5 of a pixel. turn: shifts all of them, 0 to 1.
FORMULA vec2 lattice_point(ivec2 lattice, int i, int pass, float turn) {
  float n = float(lattice.x);
  vec2 shift = vec2(0.75487767f, 0.56984029f) * (float(pass) + turn);
  vec2 at = vec2((float(i) + 0.5f) / n, (float(i * lattice.y) + 0.5f) / n) + shift;
  return at - vec2(floor(at.x), floor(at.y)) - 0.5f;
}

// Which lattice a pixel of so many yarns (root of its area) takes. low, high: footprints from which on the next one is
// needed, rising; most: points at the most.
FORMULA int lattice_for(float yarns, vec4 low, vec4 high, int most) {
  int i = (yarns >= low.x ? 1 : 0) + (yarns >= low.y ? 1 : 0) + (yarns >= low.z ? 1 : 0) + (yarns >= low.w ? 1 : 0)
        + (yarns >= high.x ? 1 : 0) + (yarns >= high.y ? 1 : 0) + (yarns >= high.z ? 1 : 0);
  int held = 0;
  for (int k = 1; k < kLattices; ++k) held += lattice_of(k).x <= most ? 1 : 0;
  return min(i, held);
}
