// Fibres on the surface of a thread that is seen near: their round sides, crevices between them, bundles, convolutions
// and stray fibres that lie across, as slopes of the surface, direction of the fibres, light and tone.
// GLSL 3.30 and C++20 (core/cloth/thread_texture.cpp takes the numbers from the yarn's fibre).
//
//   FibreDetail d = fibre_detail(pattern, along, turn, sample_size(...), length_mm)   in place of texture_at()
//   detail_normal(frame, pattern, d, ...)                                             plies and fibres in the normal
//   detail_lobes(lobes, d, relief), in methods.glsl                                   what the lobes keep
//   ply_light(frame, pattern, d, ...)                                                 plies shade each other
//
// Fibres run in lanes, parallel to the twist of their ply. Each has an offset and a depth of its own that change along
// it, so that neighbours overlap, dive and come up again; of three lanes the highest fibre is seen. Those that lie side
// by side wave together, the more the fibre is crimped. What a sample
// cannot resolve fades to its mean, and its slopes stay in the widths of the lobes: far away nothing is left of it.
//
// Based on: Zhao, Luan, Bala 2016 (migration of fibres in plies); Olano, Baker 2010, "LEAN mapping" (variance of the
// slopes split between what is resolved and the lobe); Khattar et al. 2024 (fibres of a ply by one-dimensional lanes).

#ifndef FORMULA
#define FORMULA
#endif

const float kFibreSpan = 0.64f;      // radius of a fibre in lanes: neighbours overlap
const float kSteepestFibre = 0.88f;  // sine of the steepest side of a fibre
const float kFibreDrift = 0.6f;      // lateral offset at disorder 1, in lanes
const float kFibreDive = 1.0f;       // depth to which a fibre dives at disorder 1, in lanes
const float kCrimp = 9.0f;           // lateral way of fibres that wave together, in lanes at disorder 1
const float kCrimpLanes = 14.0f;     // of which there are so many
const float kConvolutions = 3.0f;    // of a fibre, for each node of the pattern along
const float kBundleShift = 0.34f;    // of the border between two bundles, in bundles
const float kBundleSlope = 0.6f;     // at that border
const float kStrayLanes = 6.0f;      // lanes between stray fibres
const float kStrayWay = 0.7f;        // lateral way of a stray fibre, in its own lanes
const float kRoundPly = 1.6f;        // how much steeper a ply is at the furrow than the relief that maps hold
const float kSamplesOfPly = 5.0f;    // so many times finer are the samples that tell its shape
const float kPlyFurrow = 1.2f;       // twice the depth between plies over half their distance
const float kFibreGain = 0.72f;      // fitted: the mean over a thread stays
const float kPlyGain = 0.03f;
const float kTuftSpread = 5.0f;      // of the single fibres of a tuft, in bundles
const float kAcrossFibres = 0.28f;   // variance of the slopes across the fibres that are seen, at disorder 0.4

// What fibre_detail() found.
struct FibreDetail {
  Texel texel;
  vec2 slope;       // of the fibres' surface, around the thread and along it
  float fibre_tan;  // tangent of the angle from the axis to the fibre, towards +across
  vec2 resolved;    // variances of `slope` along the fibres and across them, which the lobes no longer hold
  float fade;       // 0: no single fibre is seen, 1: all of them
  float round_ply;  // 0: plies have the relief that maps hold, 1: they are round
};

// A fibre of a lane at a position along.
struct LaneFibre {
  float offset;  // from the lane's middle, -1 to 1
  float drift;   // its change in a period
  float depth;   // 0 to 1
  float shift;   // 0 to 1, of this fibre
  float tone;    // -1 to 1, of this fibre
};

// k modulo n, 0 to n - 1; k itself if n is 0.
FORMULA int wrapped(int k, int n) {
  if (n == 0) return k;
  int m = abs(n);
  int r = k - m * (k / m);
  return r < 0 ? r + m : r;
}

// ply: which one at `along`; next_ply: which one continues it in the next period.
FORMULA LaneFibre lane_fibre(ThreadTexture x, uint ply, uint next_ply, int lane, float along) {
  uint own = mix_bits(x.seed ^ 0x7F4A7C15u, uint(wrapped(lane, x.lane_advance)));
  LaneFibre f;
  f.shift = float(own & 0xFFFFu) * 1.52587890625e-5f;
  f.tone = float(own >> 16) * 3.0517578125e-5f - 1.0f;
  // Fibres have their nodes at different positions, so that no line goes around the thread.
  float node_at = along * float(x.nodes) + f.shift;
  int node = int(node_at);
  float b = node_at - float(node);
  if (node >= x.nodes) {
    node -= x.nodes;
    lane -= x.lane_advance;
    ply = next_ply;
  }
  bool wraps = node + 1 == x.nodes;
  uint here = mix_bits(x.seed + uint(lane) * 0x632BE5ABu + ply, uint(node));
  uint next = mix_bits(x.seed + uint(wraps ? lane - x.lane_advance : lane) * 0x632BE5ABu + (wraps ? next_ply : ply), uint(wraps ? 0 : node + 1));
  float smooth_b = b * b * (3.0f - 2.0f * b);
  float offset = float(here & 0xFFFFu) * 3.0517578125e-5f - 1.0f;
  float next_offset = float(next & 0xFFFFu) * 3.0517578125e-5f - 1.0f;
  float depth = float(here >> 16) * 1.52587890625e-5f;
  f.offset = offset + smooth_b * (next_offset - offset);
  f.drift = (next_offset - offset) * 6.0f * b * (1.0f - b) * float(x.nodes);
  f.depth = depth + smooth_b * (float(next >> 16) * 1.52587890625e-5f - depth);
  return f;
}

// Turns of a fibre about its own axis, mean 0, variance 1/4: slope along it.
FORMULA float convolution(ThreadTexture x, LaneFibre f, float along) {
  float turns = kConvolutions * float(x.nodes);
  float at = 6.2831853f * (along * turns + 7.0f * f.shift);
  // Two waves, of whole numbers in the period.
  return 0.5f * (sin(at) + sin(at * 2.0f + 40.0f * f.tone));
}

// Coordinate across the fibres in lanes, and its change by turns around and by periods along.
struct Lanes {
  float at;
  float around;
  float along;
  uint ply;
  uint next_ply;
};

FORMULA Lanes lanes_at(ThreadTexture x, TexturePoint p, float along, float turn) {
  Lanes l;
  l.ply = 0u;
  l.next_ply = 0u;
  l.around = x.lanes;
  l.along = float(x.lane_advance);
  // The seam is below.
  l.at = x.lanes * (turn - floor(turn + 0.5f)) + l.along * along;
  if (x.plies > 1) {
    // On a round ply fibres are closer together towards the furrow.
    float ply_turn = p.ply_turn + x.ply_phase;
    float ply = floor(ply_turn);
    float q = 2.0f * (ply_turn - ply) - 1.0f;
    float q2 = q * q;
    float crowd = x.lanes / float(x.plies);   // lanes for q of -1 to 1 at the density of the ridge
    // The arc of a circle over its chord, nearly, and its derivative.
    float rise = crowd * (1.0f + q2 * (0.45f + q2));
    l.at = 0.5f * crowd * q * (1.0f + q2 * (0.15f + 0.2f * q2)) + l.along * along;
    l.around = rise * float(x.plies);
    l.along += rise * float(x.ply_advance);
    l.ply = uint(wrapped(int(ply), x.plies)) * 0x9E3779B1u;
    l.next_ply = uint(wrapped(int(ply) - x.ply_advance, x.plies)) * 0x9E3779B1u;
  }
  return l;
}

// Of four corners, smooth in both directions.
FORMULA float crimp_value(ThreadTexture x, Lanes l, int group, int node, int advance) {
  bool wraps = node == x.nodes;
  return unit_of(mix_bits((x.seed ^ 0x68E31DA4u) + uint(wraps ? group - advance : group) * 0x632BE5ABu + (wraps ? l.next_ply : l.ply), uint(wraps ? 0 : node))) - 0.5f;
}

// Crimped fibres wave, those that lie side by side together: the lanes of a point, moved.
FORMULA Lanes crimped(ThreadTexture x, Lanes l, float along) {
  float most = kCrimp * x.disorder * x.disorder;
  int advance = int(floor(float(x.lane_advance) / kCrimpLanes + 0.5f));
  float at = (l.at - float(x.lane_advance) * along) / kCrimpLanes + float(advance) * along;
  int group = int(floor(at));
  float a = at - float(group);
  float node_at = along * float(x.nodes);
  int node = min(int(node_at), x.nodes - 1);
  float b = clamp(node_at - float(node), 0.0f, 1.0f);
  float smooth_a = a * a * (3.0f - 2.0f * a);
  float smooth_b = b * b * (3.0f - 2.0f * b);
  float v00 = crimp_value(x, l, group, node, advance);
  float v10 = crimp_value(x, l, group + 1, node, advance);
  float v01 = crimp_value(x, l, group, node + 1, advance);
  float v11 = crimp_value(x, l, group + 1, node + 1, advance);
  float here = v00 + smooth_a * (v10 - v00);
  float next = v01 + smooth_a * (v11 - v01);
  float by_group = mix(v10 - v00, v11 - v01, smooth_b) * 6.0f * a * (1.0f - a);
  Lanes moved = l;
  moved.at += most * (here + smooth_b * (next - here));
  float stretched = 1.0f + most * by_group / kCrimpLanes;
  moved.around *= stretched;
  moved.along += most * ((next - here) * 6.0f * b * (1.0f - b) * float(x.nodes)
                         + by_group * ((l.along - float(x.lane_advance)) / kCrimpLanes + float(advance)));
  return moved;
}

// The highest of three fibres at a point.
struct SeenFibre {
  LaneFibre fibre;
  float side;    // -1 to 1 across it
  float height;  // in lanes, below 0 in a crevice
};

FORMULA SeenFibre seen_fibre(ThreadTexture x, Lanes l, float along) {
  SeenFibre seen;
  seen.height = -9.0f;
  int lane = int(floor(l.at));
  for (int k = -1; k <= 1; ++k) {
    LaneFibre f = lane_fibre(x, l.ply, l.next_ply, lane + k, along);
    float radius = kFibreSpan * (1.0f + 0.3f * x.disorder * f.tone);
    float side = (l.at - float(lane + k) - 0.5f - kFibreDrift * x.disorder * f.offset) / radius;
    float height = radius * sqrt(max(1.0f - side * side, 0.0f)) - 3.0f * max(abs(side) - 1.0f, 0.0f) - kFibreDive * x.disorder * f.depth;
    if (height > seen.height) {
      seen.fibre = f;
      seen.side = side;
      seen.height = height;
    }
  }
  return seen;
}

// Place in a bundle of unequal width, -1 to 1, and its number.
struct Bundle {
  float side;
  int index;
};

FORMULA float bundle_border(ThreadTexture x, TexturePoint p, int k, float blend) {
  bool wraps = p.node + 1 == x.nodes;
  float here = fibre_value(x.seed ^ 0xA511E9B3u, k, p.node);
  float next = fibre_value(x.seed ^ 0xA511E9B3u, wraps ? k - x.advance : k, wraps ? 0 : p.node + 1);
  return float(k) + kBundleShift * (2.0f * (here + blend * (next - here)) - 1.0f);
}

// turn: in bundles of the mean width.
FORMULA Bundle bundle_at(ThreadTexture x, TexturePoint p, float turn) {
  float blend = p.blend * p.blend * (3.0f - 2.0f * p.blend);
  int k = int(floor(turn + 0.5f));
  float middle = bundle_border(x, p, k, blend);
  // On one side of the border that is nearest, or nearly so.
  int other = turn < middle ? k - 1 : k + 1;
  float end = bundle_border(x, p, other, blend);
  Bundle b;
  b.index = min(k, other);
  b.side = clamp(2.0f * (turn - min(middle, end)) / abs(end - middle) - 1.0f, -1.0f, 1.0f);
  return b;
}

// A fibre that lies across the others: one node long, thin at both ends.
struct StrayOnTop {
  float side;      // -1 to 1 across it; beyond: not there
  float gradient;  // of the lanes' coordinate along, in a period, as it sees them
  float height;    // 0 to 1 along it
  float tone;
};

FORMULA StrayOnTop stray_on_top(ThreadTexture x, Lanes l, float along) {
  float advance = floor(float(x.lane_advance) / kStrayLanes + 0.5f);
  float turn = (l.at - float(x.lane_advance) * along) / kStrayLanes + advance * along;
  int lane = int(floor(turn));
  float node_at = along * float(x.nodes);
  int node = min(int(node_at), x.nodes - 1);
  uint h = mix_bits(x.seed + uint(lane) * 0x85EBCA77u + l.ply + 0xA341316Cu, uint(node));
  StrayOnTop s;
  s.side = 9.0f;
  s.gradient = l.along;
  s.height = 0.0f;
  s.tone = 0.0f;
  if (float(h & 255u) >= 255.0f * min(x.hairiness, 1.0f)) return s;
  float b = clamp(node_at - float(node), 0.0f, 1.0f);
  float from = float((h >> 8) & 255u) / 255.0f - 0.5f;
  float to = float((h >> 16) & 255u) / 255.0f - 0.5f;
  float middle = 0.5f + kStrayWay * mix(from, to, b * b * (3.0f - 2.0f * b));
  s.height = 4.0f * b * (1.0f - b);
  s.side = (turn - float(lane) - middle) * kStrayLanes / (kFibreSpan * (0.25f + 0.75f * s.height));
  s.gradient = l.along - float(x.lane_advance) + kStrayLanes * (advance - kStrayWay * (to - from) * 6.0f * b * (1.0f - b) * float(x.nodes));
  s.tone = float(h >> 24) / 127.5f - 1.0f;
  return s;
}

// Slope of a round fibre's side.
FORMULA float round_slope(float side) {
  float e = clamp(side, -1.0f, 1.0f) * kSteepestFibre;
  return -e * inversesqrt(1.0f - e * e);
}

// Crevices are dark: light by the height of the fibre that is seen, over its mean.
FORMULA float crevice_light(ThreadTexture x, SeenFibre s) {
  float sunk = clamp((kFibreSpan - s.height) / 1.2f, 0.0f, 1.0f);
  float edge = s.side * s.side;
  return 1.0f - (0.2f + 0.35f * x.depth) * sunk - 0.2f * x.depth * edge * edge;
}

// Its mean over a thread, by the number of disorder.
FORMULA float mean_crevice_light(ThreadTexture x) {
  float sunk = 0.06f + 0.43f * x.disorder;
  float edge = 0.07f + 0.14f * x.disorder;
  return 1.0f - (0.2f + 0.35f * x.depth) * sunk - 0.2f * x.depth * edge;
}

// Variance of the slopes across the fibres; fitted, as the mean above.
FORMULA float slopes_across(ThreadTexture x) { return 0.225f + 0.32f * x.disorder * x.disorder; }

// Sizes of a sample in turns around the thread and in periods along it: `size`.
FORMULA FibreDetail fibre_detail(ThreadTexture x, float along, float turn, vec2 size, float length_mm) {
  float bundle_cycles = max(x.fibres * size.x, abs(float(x.advance)) * size.y);
  float ply_cycles = max(float(x.plies) * size.x, abs(float(x.ply_advance)) * size.y);
  float lane_cycles = max(x.lanes * size.x, abs(float(x.lane_advance)) * size.y);
  TexturePoint p = texture_point(x, along, turn, bundle_cycles, contrast_left(ply_cycles));
  FibreDetail d;
  d.slope = vec2(0.0f);
  d.resolved = vec2(0.0f);
  d.fibre_tan = x.fibre_tan;
  d.fade = contrast_left(lane_cycles);
  d.round_ply = contrast_left(kSamplesOfPly * ply_cycles);
  d.texel = mean_texel(x);
  float bundles = contrast_left(bundle_cycles);
  if (bundles > 0.0f) {
    float to_mm = 1.0f / (6.2831853f * x.radius_mm);
    // Bundles, where the fibre has them; otherwise they dissolve into single fibres.
    Bundle b = bundle_at(x, p, p.turn + x.phase);
    float bound = bundles * mix(1.0f, x.bundling, d.fade);
    float s2 = b.side * b.side;
    bool wraps = p.node + 1 == x.nodes;
    float here = fibre_value(x.seed, b.index, p.node);
    float next = fibre_value(x.seed, wraps ? b.index - x.advance : b.index, wraps ? 0 : p.node + 1);
    float tone = here + p.blend * p.blend * (3.0f - 2.0f * p.blend) * (next - here) - 0.5f;
    d.texel.groove -= x.depth * bound * (s2 * s2 - 0.2f);
    d.texel.tone += bundles * (kFibreTone * x.hairiness + kMelangeTone * x.melange) * (1.0f - 0.5f * d.fade) * tone;
    float steep = -bound * x.bundling * kBundleSlope * b.side * s2;
    vec2 bundle_gradient = vec2(x.fibres * to_mm, float(x.advance) / length_mm);
    vec2 slope = normalize(bundle_gradient) * steep;
    float variance = bound * bound * x.bundling * x.bundling * kBundleSlope * kBundleSlope / 7.0f;
    if (d.fade > 0.0f) {
      Lanes l = crimped(x, lanes_at(x, p, along, turn), along);
      SeenFibre f = seen_fibre(x, l, along);
      vec2 gradient = vec2(l.around * to_mm, (l.along - kFibreDrift * x.disorder * f.fibre.drift) / length_mm);
      float side = f.side;
      float lean = convolution(x, f.fibre, along);
      float light = crevice_light(x, f) / mean_crevice_light(x);
      float tone_of = f.fibre.tone;
      StrayOnTop top = stray_on_top(x, l, along);
      if (abs(top.side) < 1.0f) {
        gradient.y = top.gradient / length_mm;
        side = top.side;
        lean = 0.0f;
        light = 1.0f / mean_crevice_light(x);
        tone_of = top.tone;
      } else if (abs(top.side) < 3.0f) {
        light *= 1.0f - 0.2f * top.height * (1.5f - 0.5f * abs(top.side));   // its shade
      }
      vec2 across = normalize(gradient);
      slope += (across * round_slope(side) + vec2(-across.y, across.x) * (x.convolution * lean)) * d.fade;
      d.fibre_tan = mix(x.fibre_tan, clamp(-gradient.y / gradient.x, -3.0f, 3.0f), d.fade);
      variance += d.fade * d.fade * slopes_across(x);
      d.resolved.x = d.fade * d.fade * 0.25f * x.convolution * x.convolution;
      d.texel.groove *= mix(1.0f, light, d.fade);
      p.turn += kTuftSpread * d.fade * tone_of;
      d.texel.tone += d.fade * (0.06f + 0.1f * x.hairiness + 0.5f * x.melange) * tone_of;
    }
    d.slope = slope;
    d.resolved.y = variance;
  }
  d.texel = finished_texel(x, p, d.texel);
  // Single fibres of a colour stand out less than a tuft of them: light passes through them to their neighbours.
  d.texel.hue *= 1.0f - 0.4f * d.fade;
  return d;
}

// Size of a sample in turns around the thread and in periods along it. normal_z: z of the thread's normal.
FORMULA vec2 sample_size(ThreadTexture x, float sample_mm, float normal_z, float length_mm) {
  return vec2(sample_mm / (6.2831853f * x.radius_mm * max(abs(normal_z), 0.1f)), sample_mm / length_mm);
}

// A point of the thread's section without plies and fibres.
struct SurfaceFrame {
  vec3 normal;
  vec3 axis;
  vec3 around;  // along the section, towards +across
};

// Normal with the relief of plies. ply: Texel.ply.
FORMULA vec3 plied_normal(SurfaceFrame f, ThreadTexture x, float ply, float length_mm) {
  float slant = 4.0f * x.ply_relief_mm * ply;
  return normalize(f.normal + f.around * (slant * float(x.plies) / (6.2831853f * x.radius_mm))
                            + f.axis * (slant * float(x.ply_advance) / length_mm));
}

// Fraction of the fibres' slopes for lobes of this variance across them: the sides of fibres are as round as the lobe is
// wide. A nap (0..1) hides those of the threads.
FORMULA float fibre_relief(float across, float nap) {
  return clamp(sqrt(across / kAcrossFibres), 0.2f, 1.0f) * (1.0f - 0.7f * nap);
}

// Normal with the plies and fibres that are seen, towards the eye at v.
FORMULA vec3 detail_normal(SurfaceFrame f, ThreadTexture x, FibreDetail d, float relief, float length_mm, vec3 v) {
  vec3 n = f.normal;
  float ply = d.texel.ply;
  if (x.plies > 1) n = plied_normal(f, x, ply * (1.0f + kRoundPly * d.round_ply * ply * ply), length_mm);
  if (dot(n, v) <= 0.0f) n = f.normal;
  vec3 bent = normalize(n - (f.around * d.slope.x + f.axis * d.slope.y) * relief);
  return normalize(bent + v * max(min(dot(n, v), 0.05f) - dot(bent, v), 0.0f));
}

// What bent normals lose on average, though the sides of fibres and plies send it to each other: factor on the light.
FORMULA float detail_gain(ThreadTexture x, FibreDetail d, float relief) {
  float gain = sqrt(1.0f + kFibreGain * d.resolved.y * relief);
  return x.plies > 1 ? gain * (1.0f + kPlyGain * d.round_ply) : gain;
}

// Light from l between two plies, which the next one may hide: tangents to a parabola. 1 for light from behind.
FORMULA float ply_light(SurfaceFrame f, ThreadTexture x, FibreDetail d, float length_mm, vec3 l) {
  if (x.plies < 2) return 1.0f;
  float ply = d.texel.ply * d.round_ply;
  vec3 way = normalize(f.around * (float(x.plies) / (6.2831853f * x.radius_mm)) + f.axis * (float(x.ply_advance) / length_mm));
  float towards = dot(l, way);
  float u = clamp(towards < 0.0f ? -ply : ply, 0.0f, 1.0f);
  float horizon = kPlyFurrow * (2.0f - u - 2.0f * sqrt(1.0f - u)) * abs(towards);
  float height = dot(l, f.normal);
  if (height <= 0.0f || horizon <= 0.0f) return 1.0f;
  return clamp(0.5f * height / horizon, 0.0f, 1.0f);
}
