// The fine pattern on a thread: dark grooves that follow the fibres' twist, plies, and the uneven tone of
// stray fibres. GLSL 3.30 and C++20 (core/cloth/thread_texture.h makes ThreadTexture of a yarn).
//
// Based on: N. Adabala, N. Magnenat-Thalmann, G. Fei, Real-time Rendering of Woven Clothes, 2003, section 3.2
//   and figure 3 (twist tightness, thickness of the fibres, noise of stray fibres).
// Differs: the twist is a helix on a round thread with its pitch in millimetres, its phase is rounded so that
//   the tile closes, and a pattern finer than the samples fades to its mean.

#ifndef FORMULA
#define FORMULA
#endif

const float kStraySpacing = 2.5f;  // stray fibres are this much sparser around the thread than grooves
const float kThreadTone = 0.05f;   // tone contrast between threads
const float kFibreTone = 0.55f;    // contrasts at hairiness 1
const float kStrayTone = 0.35f;
const float kMelangeTone = 1.7f;     // contrasts at melange 1
const float kMelangeThread = 0.12f;   // of threads and of stretches along them, at melange 1
const float kTuftTone = 0.62f;       // of tufts, at melange 1
const float kTuftHue = 1.5f;
const float kStrayFraction = 0.35f;  // of the slots for a stray fibre, at hairiness 1
const float kWander = 1.3f;          // lateral wander of grooves, in grooves at hairiness 1
const int kFibresABundle = 4;
const float kTuft = 5.0f;            // bundles across a tuft of one colour
const float kTuftNodes = 5.0f;       // nodes of the tone along it

// Parameters of one thread's texture, computed once a thread.
struct ThreadTexture {
  float fibres;     // grooves once around
  int advance;      // grooves that pass in one period along; sign: direction of the twist
  float fibre_tan;  // tangent of the angle from the axis to the fibre, towards +across
  int plies;
  int ply_advance;
  float ply_relief_mm;   // depth of the furrow between plies
  float phase;
  float ply_phase;
  int lane_advance;   // like advance, of the single fibres in their ply
  int stray_advance;  // like advance, of the stray fibres
  int nodes;          // of the tone along one period
  float depth;
  float hairiness;
  float radius_mm;
  uint seed;
  float melange;         // contrast of colour between neighbouring fibres
  // Single fibres, for fibre_detail.glsl.
  float lanes;           // once around
  float disorder;        // 0 to 1: how unevenly they lie
  float bundling;        // 0 to 1: how far they stay together in bundles
  float convolution;     // slope along a fibre that turns about its own axis
};

// Position on the texture. `turn` counts grooves (fibres * angle / 2 pi + advance * s / length + wander).
struct TexturePoint {
  float turn;            // in grooves
  float ply_turn;        // in plies
  float stray_turn;
  int node;              // of the tone along, 0..nodes - 1
  float blend;           // to the next node
  float cycles;          // grooves that one sample spans
  float ply_fade;
};

struct Texel {
  float groove;  // factor; its mean over the thread does not depend on fade
  float tone;    // factor on the thread's colour, mean 1
  float ply;     // -1..1 across a ply: 0 at its ridge
  float hue;     // warmer above 0, cooler below; mean 0
};

FORMULA uint mix_bits(uint a, uint b) {
  uint h = (a * 0x9E3779B1u) ^ ((b + 0x7F4A7C15u) * 0x85EBCA77u);
  h ^= h >> 15;
  h *= 0x2C1B3C6Du;
  h ^= h >> 12;
  h *= 0x297A2D39u;
  return h ^ (h >> 15);
}

FORMULA float unit_of(uint h) { return float(h >> 8) * 5.9604644775390625e-8f; }

// One value a fibre and node.
FORMULA float fibre_value(uint seed, int fibre, int node) {
  return unit_of(mix_bits(seed + uint(fibre) * 0x632BE5ABu, uint(node)));
}

// Remaining contrast of a pattern when one sample spans `cycles` of it (0: full, 1: none).
FORMULA float contrast_left(float cycles) { return clamp(1.5f - 2.0f * cycles, 0.0f, 1.0f); }

// Lateral offset of a groove at a position along, in grooves.
FORMULA float wander(ThreadTexture x, int node, float blend) {
  float b = blend * blend * (3.0f - 2.0f * blend);
  float here = unit_of(mix_bits(x.seed ^ 0x5bd1e995u, uint(node))) - 0.5f;
  float next = unit_of(mix_bits(x.seed ^ 0x5bd1e995u, uint(node + 1 == x.nodes ? 0 : node + 1))) - 0.5f;
  return kWander * x.hairiness * (here + b * (next - here));
}

// The point `along` (0..1) the period and `turn` around the thread: 0 on its ridge, towards +across.
FORMULA TexturePoint texture_point(ThreadTexture x, float along, float turn, float cycles, float ply_fade) {
  TexturePoint p;
  float node = along * float(x.nodes);
  p.node = clamp(int(node), 0, x.nodes - 1);
  p.blend = clamp(node - float(p.node), 0.0f, 1.0f);
  p.turn = x.fibres * turn + float(x.advance) * along + wander(x, p.node, p.blend);
  p.ply_turn = float(x.plies) * turn + float(x.ply_advance) * along;
  p.stray_turn = x.fibres * turn / kStraySpacing + float(x.stray_advance) * along;
  p.cycles = cycles;
  p.ply_fade = ply_fade;
  return p;
}

// Fibres of different colours are never blended uniformly: tufts of one colour lie along the twist, lighter or darker
// (x) and, if dyed, warmer or cooler (y), some of them far more than the rest (neps).
FORMULA vec2 tuft_values(uint seed, int tuft, int node) {
  uint h = mix_bits(seed + uint(tuft) * 0x632BE5ABu, uint(node));
  float tone = float(h & 1023u) / 511.5f - 1.0f;
  float hue = float((h >> 10) & 1023u) / 511.5f - 1.0f;
  return (h >> 20) < 420u ? vec2(1.6f * tone, 2.0f * hue) : vec2(0.6f * tone, 0.35f * hue);
}

// Tone and hue of the tuft at a point, mean 0.
FORMULA vec2 tuft_at(ThreadTexture x, TexturePoint p) {
  int nodes = max(int(float(x.nodes) / kTuftNodes), 1);
  float along = (float(p.node) + p.blend) / float(x.nodes);
  int advance = int(floor(float(x.advance) / kTuft + 0.5f));
  float turn = (p.turn - float(x.advance) * along + x.phase) / kTuft + float(advance) * along;
  int tuft = int(floor(turn));
  // Tufts begin and end at different positions, so that no line goes around the thread.
  float node_at = along * float(nodes);
  int node = min(int(node_at), nodes - 1);
  bool wraps = node + 1 == nodes;
  float b = clamp(node_at - float(node), 0.0f, 1.0f);
  vec2 here = tuft_values(x.seed ^ 0x1B873593u, tuft, node);
  vec2 next = tuft_values(x.seed ^ 0x1B873593u, wraps ? tuft - advance : tuft, wraps ? 0 : node + 1);
  return mix(here, next, b * b * (3.0f - 2.0f * b));
}

// Factor of the pattern on the thread's colour. Grey has no hue to shift.
FORMULA vec3 fibre_tint(Texel t, vec3 colour) {
  float most = max(colour.x, max(colour.y, colour.z));
  float least = min(colour.x, min(colour.y, colour.z));
  float turned = t.hue * (1.0f - least / max(most, 1.0e-4f));
  return t.tone * max(vec3(1.0f) + vec3(0.6f, 0.1f, -0.8f) * turned, vec3(0.1f));
}

// Colour of a point on a thread of this colour.
FORMULA vec3 fibre_colour(Texel t, vec3 colour) { return min(colour * fibre_tint(t, colour), vec3(1.0f)); }

// The thread's own tone; grooves and plies at their mean.
FORMULA Texel mean_texel(ThreadTexture x) {
  Texel made;
  made.tone = 1.0f + (kThreadTone * x.hairiness + kMelangeThread * x.melange) * (2.0f * unit_of(mix_bits(x.seed, 3u)) - 1.0f);
  made.hue = 0.0f;
  made.groove = 1.0f - 0.2f * x.depth;
  made.ply = 0.0f;
  return made;
}

// With the tufts of a melange and the plies, within bounds.
FORMULA Texel finished_texel(ThreadTexture x, TexturePoint p, Texel made) {
  float tufts = x.melange > 0.0f ? x.melange * contrast_left(p.cycles / kTuft) : 0.0f;
  if (tufts > 0.0f) {
    vec2 tuft = tuft_at(x, p);
    made.tone += kTuftTone * tufts * tuft.x;
    made.hue = kTuftHue * x.melange * tufts * tuft.y;
  }
  if (x.plies > 1) {
    float ply_turn = p.ply_turn + x.ply_phase;
    made.ply = 2.0f * (ply_turn - floor(ply_turn)) - 1.0f;
    float furrow = made.ply * made.ply * made.ply * made.ply * made.ply * made.ply;  // mean 1/7
    made.groove *= 1.0f - x.depth * (1.0f / 7.0f + p.ply_fade * (furrow - 1.0f / 7.0f));
    made.ply *= p.ply_fade;
  }
  made.tone = max(made.tone, 0.05f);
  made.groove = clamp(made.groove, 0.0f, 1.0f);
  return made;
}

// Whether texture_at() depends on the turns of a point.
FORMULA bool shows_turn(ThreadTexture x, float cycles) {
  return x.plies > 1 || contrast_left(cycles) > 0.0f || (x.melange > 0.0f && contrast_left(cycles / kTuft) > 0.0f);
}

FORMULA Texel texture_at(ThreadTexture x, TexturePoint p) {
  Texel made = mean_texel(x);
  float fade = contrast_left(p.cycles);
  if (fade > 0.0f) {
    float turn = p.turn + x.phase;
    float fibre = floor(turn);
    // Interpolated along; across the tile's border fibre k continues as k - advance.
    int k = int(fibre);
    bool wraps = p.node + 1 == x.nodes;
    float b = p.blend * p.blend * (3.0f - 2.0f * p.blend);
    float here = fibre_value(x.seed, k, p.node);
    float next = fibre_value(x.seed, wraps ? k - x.advance : k, wraps ? 0 : p.node + 1);
    float tone = here + b * (next - here) - 0.5f;
    // Groove: 1 between fibres, 0 on their ridge; the fourth power has the mean 1/5.
    float across = 2.0f * (turn - fibre) - 1.0f;
    float groove = across * across * across * across;
    made.groove -= x.depth * fade * (groove * (1.0f + 1.6f * x.hairiness * tone) - 0.2f);
    // A stray fibre: thin, light, one node long, tapering to both ends.
    float stray_turn = p.stray_turn + x.phase;
    float stray_fibre = floor(stray_turn);
    float density = kStrayFraction * x.hairiness;
    float aside = 5.0f * (2.0f * (stray_turn - stray_fibre) - 1.0f);
    float stray = 0.0f;
    if (abs(aside) < 1.0f && fibre_value(x.seed ^ 0xA341316Cu, int(stray_fibre), p.node) < density) {
      stray = (1.0f - aside * aside) * 4.0f * p.blend * (1.0f - p.blend);
    }
    const float kMeanOfStray = 2.0f / 15.0f * 2.0f / 3.0f;
    made.tone += fade * ((kFibreTone * x.hairiness + kMelangeTone * x.melange) * tone + kStrayTone * (stray - density * kMeanOfStray));
    // The single fibres of a bundle, each of its own tone.
    float fine = contrast_left(float(kFibresABundle) * p.cycles);
    if (fine > 0.0f) {
      float single = turn * float(kFibresABundle);
      float index = floor(single);
      // The same fibre again after a period, so that the tile closes.
      int own = int(index);
      int singles = abs(x.advance) * kFibresABundle;
      if (singles > 0) own -= int(floor(index / float(singles))) * singles;
      float rounded_off = 2.0f * (single - index) - 1.0f;  // darker towards its sides; the square's mean is 1/3
      float own_tone = fibre_value(x.seed ^ 0xC2B2AE35u, own, 0) - 0.5f;
      made.tone += fine * (0.06f + 0.3f * x.hairiness + 0.6f * x.melange) * (0.7f * own_tone + 1.0f / 3.0f - rounded_off * rounded_off);
    }
  }
  return finished_texel(x, p, made);
}
