// Flyaway fibres: how many there are for a yarn's fuzz, how long they are, and how they scatter light.
// GLSL 3.30 and C++20.
//
//   flyaway.vert                                     fibres at the silhouettes of a cloth, as strips
//   face_flyaway(), flyaway_at()                     fibres that lie over its face, for method `yarn`
//
// Fuzz of fraction f and optical depth d (lobes.glsl) covers f d of the area under it. Here the fraction gives the
// number of fibres and the depth their length: number times length times width is the same coverage.
//
// Based on: Barella 1983, "Yarn hairiness" (lengths of standing fibres fall off exponentially); Kajiya, Kay 1989
// (light on a fibre goes with the sine of the angle between them); Henyey, Greenstein 1941 (phase function).
// Differs: from Kajiya and Kay: no specular cone; light scatters backwards, as from a matt fibre, or forwards, as
// through a clear one, so that a backlit silhouette glows.

#ifndef FORMULA
#define FORMULA
#endif

const float kFlyawayWidth = 0.02f;       // mm, of wool and cotton fibres: 12 to 25 micrometres
const float kFlyawayLength = 1.4f;       // mm, mean for an optical depth of 1
const float kFlyawayCover = 0.56f;       // mean visible area over width times length: a fibre tapers and leans
const float kFlyawaysPerMm2 = 1.0f / (kFlyawayLength * kFlyawayWidth * kFlyawayCover);  // on one side of the cloth, for a fraction of 1
const float kFlyawaysBound = 0.03f;      // fraction of fuzz that lies along the thread, as in filament yarns

const float kFlyawayCrowd = 0.4f;        // fraction of a fibre's surroundings that is other fibres

// Fraction of the area whose fibres stand off far enough to be visible one by one.
FORMULA float flyaway_fraction(float fuzz) { return max(fuzz - kFlyawaysBound, 0.0f); }

// How much of fuzz of this fraction is a raised nap, whose fibres lie over the threads in all directions, 0..1.
FORMULA float nap_of(float fuzz) { return smoothstep(0.65f, 0.9f, fuzz); }

// Henyey-Greenstein phase function: density over the sphere by the cosine of the scattering angle, with mean cosine g;
// integrates to 1.
FORMULA float turn_density(float cosine, float g) {
  float x = 1.0f + g * g - 2.0f * g * cosine;
  return (1.0f - g * g) / (x * sqrt(x)) * 0.07957747f;
}

// Phase function of a fibre, 1/sr; integrates to 1.
FORMULA float flyaway_phase(float cosine) {
  return 0.55f * turn_density(cosine, -0.35f) + 0.45f * turn_density(cosine, 0.6f);
}

// Albedo of a fibre including the light of the same source that its neighbours scatter to it.
FORMULA vec3 flyaway_scattered(vec3 colour) { return colour / (1.0f - kFlyawayCrowd * colour); }

// Radiance of a fibre along `fibre` for unit irradiance of the key light at normal incidence. colour: albedo of the
// fibre; body: albedo of the cloth beneath; n: the cloth's normal on its side.
FORMULA vec3 flyaway_key(vec3 colour, vec3 body, vec3 fibre, vec3 n, vec3 l, vec3 v) {
  float along = dot(fibre, l);
  float sine = sqrt(max(1.0f - along * along, 0.0f));
  float met = sine * 1.2732395f;      // over its mean, pi / 4
  float beneath = max(dot(n, l), 0.0f) * 0.15915494f;   // half a sphere of the cloth's radiance
  return flyaway_scattered(colour) * (vec3(met * flyaway_phase(-dot(l, v))) + body * (beneath * (1.0f - kFlyawayCrowd)));
}

// Reflected fraction of the sky's mean radiance: half of the surroundings other than fibres is sky, half the cloth.
FORMULA vec3 flyaway_sky(vec3 colour, vec3 body) {
  return flyaway_scattered(colour) * (0.5f + body * 0.5f) * (1.0f - kFlyawayCrowd);
}

// A fibre over the face of the cloth, as seen from above; mm.
struct FaceFlyaway {
  vec2 middle;    // from the corner of its cell
  vec2 way;       // of its chord, unit
  float reach;    // half its chord
  float bend;     // lateral way of its ends, over the reach
  float wave;
  float height;   // over the highest threads, as a fraction of their height
  float present;  // 0 to 1: there if the fraction of fuzz is larger
};

const float kFaceWidth = 0.013f;       // mm
const float kFaceOpacity = 0.8f;       // of a clear fibre
const float kMaxFaceFlyaways = 12.0f;  // in a cell
const float kMaxNapFlyaways = 48.0f;   // in a cell of a nap, which holds longer ones
const float kFaceFlyawaysPerMm2 = 1.5f * kFlyawaysPerMm2;  // they are thinner than drawn at the silhouette
const float kFaceLight = 0.85f;        // of the light on them: threads and fibres around hide some
const float kFaceFrom = 0.12f;         // yarns a pixel from which on fibres over the face are left to the fuzz
const float kFaceTo = 0.3f;

// Fraction of them that is drawn one by one.
FORMULA float face_flyaways_drawn(float yarns) { return clamp((kFaceTo - yarns) / (kFaceTo - kFaceFrom), 0.0f, 1.0f); }

// Side of the cells that hold them, for fuzz of this fraction and optical depth: as long as the fibres, or shorter where
// these are many, which are shorter, too. In a nap they reach from thread to thread, so that it hides the weave.
FORMULA float face_cell(float fraction, float depth, float spacing) {
  float crowded = sqrt(kMaxFaceFlyaways / max(flyaway_fraction(fraction) * kFaceFlyawaysPerMm2, 1.0e-3f));
  return max(min(2.0f * kFlyawayLength * depth, crowded), mix(0.6f, 1.2f, nap_of(fraction)) * spacing);
}

// The most fibres that are drawn in a cell, for fuzz of this fraction; and the number that belong to one of this area.
FORMULA float max_face_flyaways(float fraction) { return mix(kMaxFaceFlyaways, kMaxNapFlyaways, nap_of(fraction)); }
FORMULA float face_flyaways_in(float fraction, float area) { return flyaway_fraction(fraction) * kFaceFlyawaysPerMm2 * area; }

// Fuzz that remains in the lobe where fibres over the face are drawn one by one.
FORMULA float fuzz_left(float fraction, float area, float drawn) {
  float shown = min(max_face_flyaways(fraction) / max(face_flyaways_in(fraction, area), 1.0e-3f), 1.0f);
  return fraction - flyaway_fraction(fraction) * shown * drawn;
}

FORMULA uint flyaway_bits(uint a, uint b) {
  uint h = (a + 0x9E3779B9u) * 0x85EBCA6Bu + b;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return h ^ (h >> 15);
}

// Its middle, by its bits: flyaway_bits(cell, number in it).
FORMULA vec2 flyaway_middle(uint bits, vec2 size) {
  return vec2(float(bits & 0xFFFFu), float(bits >> 16)) * 1.52587890625e-5f * size;
}
// The longest reach, for cells of this size.
FORMULA float flyaway_reach(vec2 size) { return 0.45f * min(size.x, size.y); }

// Fraction of the light that reaches the threads between those drawn one by one, for a mean length in cells of this
// size. Single fibres scatter as much light as they take, a crowd does not. With it the brightness stays where they
// appear: to 7 % in flannel, which was up to 24 % brighter, and to 3 % in tweed (8 %).
FORMULA float face_flyaways_pass(float fraction, float length, vec2 size, float drawn) {
  const float each = 0.5f * kFaceWidth * kFaceOpacity;  // area of a fibre, which tapers, per length
  const float single = 0.05f;                           // cover of fibres that hardly shade each other
  float area = size.x * size.y;
  float count = min(face_flyaways_in(fraction, area), max_face_flyaways(fraction));
  float cover = 1.0f - exp(-count * each * min(length, 2.0f * flyaway_reach(size)) / area);
  return 1.0f - drawn * cover * cover / (cover + single);
}

// The fibre of these bits; size: of its cell; length: mean.
FORMULA FaceFlyaway face_flyaway(uint bits, vec2 size, float length) {
  uint b = flyaway_bits(bits, 1u);
  uint c = flyaway_bits(bits, 2u);
  FaceFlyaway f;
  f.middle = flyaway_middle(bits, size);
  float turn = float(b & 0xFFFFu) * 9.587379924e-5f;
  f.way = vec2(cos(turn), sin(turn));
  // Lengths fall off exponentially; half the cell holds any.
  float long_one = -log(1.0f - 0.98f * float(b >> 16) * 1.52587890625e-5f);
  f.reach = min(0.5f * length * (0.3f + 0.7f * long_one), flyaway_reach(size));
  f.bend = float(c & 0xFFu) / 127.5f - 1.0f;
  f.wave = float((c >> 8) & 0xFFu) / 127.5f - 1.0f;
  f.height = float((c >> 16) & 0xFFu) / 255.0f;
  f.present = float(c >> 24) / 255.0f;
  return f;
}

// Cover of a pixel by a fibre, at `p` from its cell's corner, and the tangent of the angle from its chord. dx, dy: sides
// of the pixel. A fibre finer than the pixel is drawn as wide as it, and fainter.
FORMULA vec2 flyaway_at(FaceFlyaway f, vec2 p, vec2 dx, vec2 dy) {
  vec2 off = p - f.middle;
  float u = dot(off, f.way) / f.reach;
  if (abs(u) >= 1.0f) return vec2(0.0f);
  float v = (off.y * f.way.x - off.x * f.way.y) / f.reach;
  float slope = 0.5f * f.bend * u + 0.9f * f.wave * (u * u - 0.33f);
  float aside = v - 0.25f * f.bend * (u * u - 0.5f) - 0.3f * f.wave * u * (u * u - 1.0f);
  float lean = inversesqrt(1.0f + slope * slope);
  vec2 normal = vec2(-f.way.y - slope * f.way.x, f.way.x - slope * f.way.y) * lean;
  float pixel = max(length(vec2(dot(normal, dx), dot(normal, dy))), 1.0e-6f);
  float width = kFaceWidth * (1.0f - 0.4f * u * u);
  float drawn = max(width, pixel);
  float cover = clamp(0.5f + (0.5f * drawn - abs(aside) * f.reach * lean) / pixel, 0.0f, 1.0f);
  // Its ends go in between the threads.
  float ends = 1.0f - u * u;
  return vec2(kFaceOpacity * cover * width / drawn * min(3.0f * ends, 1.0f), slope);
}
