// What a pixel's footprint sees of a cloth: gaps and systems of threads by view, rungs by footprint.
// GLSL 3.30 and C++20. Frame: x along the weft, y along the warp, z the cloth's normal; lengths in mm.
//
// Based on: Smith 1967 (masking among uncorrelated heights); Castano 2010 (coverage through mips);
//   Heitz et al. 2016 (visible share of a mixture of slope distributions).

#ifndef FORMULA
#define FORMULA
#endif

const float kMinFilterCosine = 1.0e-3f;

// 1 - openness, smooth: what is left of a gap of width `gap` between round threads of height `rim` seen under an
// angle of tangent `slope`: their outlines are wider by rim * (secant - 1).
FORMULA float gap_left(float gap, float rim, float slope) {
  float g = max(gap, 1.0e-6f);
  float x = 1.0f - rim * (sqrt(1.0f + slope * slope) - 1.0f) / g;
  // Threads are round and lie unevenly: a gap closes over a range, not at once.
  float soft = 0.08f;
  float open = 0.5f * (x + sqrt(x * x + soft * soft));
  return clamp(open / (0.5f * (1.0f + sqrt(1.0f + soft * soft))), 0.0f, 1.0f);
}

// Coverage seen along w of cloth that covers `coverage` at normal view. gap_mm: mean gap along x and
// along y; rim_mm: height of the threads at its rim.
FORMULA float coverage_by_view(float coverage, vec2 gap_mm, float rim_mm, vec3 w) {
  float z = max(abs(w.z), kMinFilterCosine);
  float open = gap_left(gap_mm.x, rim_mm, abs(w.x) / z) * gap_left(gap_mm.y, rim_mm, abs(w.y) / z);
  return 1.0f - (1.0f - clamp(coverage, 0.0f, 1.0f)) * open;
}

// How much of each system (x warp, y weft) is seen along w, over its area at normal view: the
// mean over both by area is 1. share: areas at normal view, sum 1; areas: projected areas of their facets
// along w (gaussian_area of cosine and slope deviation along w); lift: mean height of warp over weft,
// signed, in units of the spacing of threads.
// A ray that leaves the lower system climbs `lift` while it runs lift * tangent across the threads of
// the upper one, and meets one with the chance of their share.
FORMULA vec2 system_masking(vec2 share, vec2 areas, float lift, vec3 w) {
  float z = max(abs(w.z), kMinFilterCosine);
  float over_warp = exp(-min(max(-lift, 0.0f) * share.y * abs(w.y) / z, 40.0f));  // wefts stop moves along y
  float over_weft = exp(-min(max(lift, 0.0f) * share.x * abs(w.x) / z, 40.0f));
  vec2 seen = vec2(areas.x * over_warp, areas.y * over_weft);
  float total = share.x * seen.x + share.y * seen.y;
  return seen / max(total, 1.0e-6f);
}

// Yarns under a pixel, along the longer axis of its footprint. dx, dy: cloth coordinates' change (mm)
// over one pixel in x and in y; spacing_mm: mean spacing of yarns.
FORMULA float footprint_yarns(vec2 dx, vec2 dy, float spacing_mm) {
  return sqrt(max(dot(dx, dx), dot(dy, dy))) / max(spacing_mm, 1.0e-6f);
}

// Weights (sum 1) of the rungs yarn, cell, repeat, cloth at a footprint in yarns a pixel. edges: where
// one rung has given way to the next, none below the one before (equal: a rung is left out). Each blend takes the half
// octave before, so that no seam shows: there the next one is a little less true than it must be, but only a part of what
// is seen, and where it is true enough alone nothing finer is paid for.
FORMULA vec4 lod_weights(float yarns, vec3 edges) {
  float x = log2(max(yarns, 1.0e-6f));
  float cell = smoothstep(-0.5f, 0.0f, x - log2(max(edges.x, 1.0e-6f)));
  float repeat = smoothstep(-0.5f, 0.0f, x - log2(max(edges.y, 1.0e-6f)));
  float cloth = smoothstep(-0.5f, 0.0f, x - log2(max(edges.z, 1.0e-6f)));
  return vec4(1.0f - cell, cell - repeat, repeat - cloth, cloth);
}
