// The threads as texels of four integers each: layout of the records, and unpacking. GLSL 3.30 and C++20
// (core/render_data/thread_block.h fills them from these same structs; interop.h has their sizes).
//
//   a head for each layer; the colours along threads, one a texel; the ends' records; the bins of the ends, four a
//   texel; the picks' records; theirs; the yarns' lobes

#include "interop.h"
#include "thread_texture.glsl"
#include "fibre_detail.glsl"
#include "thread_section.glsl"
#include "thread_thickness.glsl"

#ifndef FORMULA
#define FORMULA
#endif

struct ThreadHead {
  ivec2 count;          // ends, picks, of the layer
  ivec2 first;          // index of its first end, first pick
  vec2 period;          // mm
  float spacing;        // mean of both systems, mm
  float top;            // upper bound of the threads, mm
  ivec2 threads;        // first texels of the ends' records, of the picks'
  ivec2 bins;           // of their bins
  int yarns;            // first texel of the yarns
  int crossing_blocks;  // blocks of crossings in a row
  vec2 even;            // common spacing of the threads of each system, 0 if they differ
  float bottom;         // lower bound of the threads, mm
  float reach;          // height of the layer's weave above its own middle plane, mm
  int layers;           // of the cloth
  float aside;          // the furthest that washing moves a thread sideways, mm; 0: no thread is moved
};

struct ThreadRecord {
  uvec4 body;           // pack_section()
  vec3 color;           // linear
  int yarn;
  ThreadTexture pattern;
  ivec4 dye;            // first texel of its colours; their number, 0: `color` all along; its phase; its place in the draft
};

FORMULA ThreadHead thread_head(uvec4 a, uvec4 b, uvec4 c, uvec4 d, uvec4 e) {
  ThreadHead h;
  h.count = ivec2(int(a.x), int(a.y));
  h.first = ivec2(int(a.z), int(a.w));
  h.period = vec2(uintBitsToFloat(b.x), uintBitsToFloat(b.y));
  h.spacing = uintBitsToFloat(b.z);
  h.top = uintBitsToFloat(b.w);
  h.threads = ivec2(int(c.x), int(c.y));
  h.bins = ivec2(int(c.z), int(c.w));
  h.yarns = int(d.x);
  h.crossing_blocks = int(d.y);
  h.even = vec2(uintBitsToFloat(d.z), uintBitsToFloat(d.w));
  h.bottom = uintBitsToFloat(e.x);
  h.reach = uintBitsToFloat(e.y);
  h.layers = int(e.z);
  h.aside = uintBitsToFloat(e.w);
  return h;
}

// One layer's threads, for rays (threads.glsl).
struct ThreadGrid {
  int layers;   // of the cloth
  ivec2 count;  // ends, picks of the layer
  ivec2 first;  // index of the first ones in the cloth
  vec2 period;
  float spacing;  // mean
  float top;      // upper bound of the threads
  float bottom;   // lower bound
  float reach;    // height of its weave above its own middle plane
  float side;     // 1: the front; -1: the back, where heights change sign
  vec2 even;      // common spacing of the threads of each system, 0 if they differ
  float aside;    // the furthest that washing moves a thread sideways, 0: none is moved
  ivec2 slubs;    // thick and thin places along an end, along a pick
};

FORMULA ThreadGrid grid_of(ThreadHead h, float side) {
  ThreadGrid g;
  g.layers = h.layers;
  g.count = h.count;
  g.first = h.first;
  g.period = h.period;
  g.spacing = h.spacing;
  g.top = side > 0.0f ? h.top : -h.bottom;
  g.bottom = side > 0.0f ? h.bottom : -h.top;
  g.reach = h.reach;
  g.side = side;
  g.even = h.even;
  g.aside = h.aside;
  g.slubs = ivec2(slubs_in(h.period.y), slubs_in(h.period.x));
  return g;
}

const float kFillSteps = 16383.0f;         // of the root of width over room
const float kRoundnessSteps = 4096.0f;     // of height over width, below 4
const float kSquareSteps = 16.0f;          // of the squareness, below 1
const float kBorderSteps = 127.0f;         // of half the room

// From THREAD_BODY: centre and half spacing as floats; width over room, squareness and height over width; a byte for
// each offset of a border and for each sway.
FORMULA ThreadSection record_body(uvec4 a) {
  ThreadSection s;
  s.centre = uintBitsToFloat(a.x);
  s.half_room = uintBitsToFloat(a.y);
  vec2 aside = vec2(float(a.w & 255u), float((a.w >> 8u) & 255u)) - 128.0f;
  vec2 sway = vec2(float((a.w >> 16u) & 255u), float(a.w >> 24u)) * 0.5f;
  s.aside = aside * (s.half_room / kBorderSteps);
  s.sway = sway * (s.half_room / kBorderSteps);
  float fill = float(a.z >> 18u) / kFillSteps;
  s.half_width = fill * fill * (s.half_room + 0.5f * (s.aside.y - s.aside.x));
  s.half_height = s.half_width * (float(a.z & 16383u) / kRoundnessSteps);
  s.squareness = float((a.z >> 14u) & 15u) / kSquareSteps;
  return s;
}

FORMULA uvec4 pack_section(ThreadSection s) {
  float per_room = kBorderSteps / max(s.half_room, 1.0e-9f);
  uvec2 aside = uvec2(clamp(s.aside * per_room + 128.5f, 0.0f, 255.0f));
  uvec2 sway = uvec2(clamp(s.sway * (2.0f * per_room) + 0.5f, 0.0f, 255.0f));
  float room = s.half_room + 0.5f * (s.aside.y - s.aside.x);
  float fill = sqrt(clamp(s.half_width / max(room, 1.0e-9f), 0.0f, 1.0f));
  float roundness = s.half_width > 0.0f ? clamp(s.half_height / s.half_width, 0.0f, 3.99f) : 0.0f;
  return uvec4(floatBitsToUint(s.centre), floatBitsToUint(s.half_room),
               (uint(fill * kFillSteps + 0.5f) << 18u) | (uint(s.squareness * kSquareSteps + 0.5f) << 14u) |
                 uint(roundness * kRoundnessSteps + 0.5f),
               aside.x | (aside.y << 8u) | (sway.x << 16u) | (sway.y << 24u));
}

// From THREAD_COLOR: linear colour; its yarn in w.
FORMULA vec4 record_color(uvec4 a) {
  return vec4(uintBitsToFloat(a.x), uintBitsToFloat(a.y), uintBitsToFloat(a.z), float(int(a.w)));
}

// From THREAD_PATTERN.
FORMULA ThreadTexture record_pattern(uvec4 a, uvec4 b, uvec4 c, uvec4 d, uvec4 e) {
  ThreadTexture x;
  x.fibres = uintBitsToFloat(a.x);
  x.advance = int(a.y);
  x.fibre_tan = uintBitsToFloat(a.z);
  x.plies = int(a.w);
  x.ply_advance = int(b.x);
  x.ply_relief_mm = uintBitsToFloat(b.y);
  x.phase = uintBitsToFloat(b.z);
  x.ply_phase = uintBitsToFloat(b.w);
  x.lane_advance = int(c.x);
  x.stray_advance = int(c.y);
  x.nodes = int(c.z);
  x.depth = uintBitsToFloat(c.w);
  x.hairiness = uintBitsToFloat(d.x);
  x.radius_mm = uintBitsToFloat(d.y);
  x.seed = d.z;
  x.melange = uintBitsToFloat(d.w);
  x.lanes = uintBitsToFloat(e.x);
  x.disorder = uintBitsToFloat(e.y);
  x.bundling = uintBitsToFloat(e.z);
  x.convolution = uintBitsToFloat(e.w);
  return x;
}

// The same thread on the back: that is mapped as the front and seen mirrored, so its twist is reversed, to be the same
// in space. side: 1 front, -1 back.
FORMULA ThreadTexture pattern_on(ThreadTexture x, float side) {
  int mirror = side < 0.0f ? -1 : 1;
  x.advance *= mirror;
  x.fibre_tan *= side;
  x.ply_advance *= mirror;
  x.stray_advance *= mirror;
  x.lane_advance *= mirror;
  return x;
}

FORMULA YarnData record_yarn(uvec4 a, uvec4 b, uvec4 c, uvec4 d) {
  YarnData y;
  y.along_width = uintBitsToFloat(a.x);
  y.across_width = uintBitsToFloat(a.y);
  y.specular = uintBitsToFloat(a.z);
  y.body = uintBitsToFloat(a.w);
  y.fuzz = uintBitsToFloat(b.x);
  y.fuzz_width = uintBitsToFloat(b.y);
  y.fuzz_depth = uintBitsToFloat(b.z);
  y.transmission = uintBitsToFloat(b.w);
  y.tint = uintBitsToFloat(c);
  y.reflectance = uintBitsToFloat(d.x);
  y.fibre_layers = uintBitsToFloat(d.y);
  y.inner_halvings = uintBitsToFloat(d.z);
  y.spare_c = uintBitsToFloat(d.w);
  return y;
}
