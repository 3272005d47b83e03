// Flyaway fibres: how many there are for a yarn's fuzz, how long they are, and how they scatter light.
// GLSL 3.30 and C++20.
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
