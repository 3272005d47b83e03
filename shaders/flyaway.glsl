// Stray fibres: how many a yarn's fuzz lets stand off, how long they are, and what light they scatter.
// GLSL 3.30 and C++20.
//
// A fuzz of share f and optical depth d (lobes.glsl) covers f d of the area under it. Here the share says how many
// fibres stand off and the depth how long they are: number times length times width is that same cover.
//
// Based on: Barella 1983, "Yarn hairiness" (lengths of standing fibres fall off exponentially); Kajiya, Kay 1989
//   (a fibre meets light by the sine of the angle between them); Henyey, Greenstein 1941 (turns of light).
// Differs: from Kajiya and Kay: no mirrored cone; light is turned back, as off a matt fibre, or goes on, as
//   through a clear one, so that a rim against the light glows.

#ifndef FORMULA
#define FORMULA
#endif

const float kFlyawayWidth = 0.02f;       // mm, of wool and cotton fibres: 12 to 25 micrometres
const float kFlyawayLength = 1.4f;       // mm, mean for an optical depth of 1
const float kFlyawayCover = 0.56f;       // mean over width times length, of what is seen: it tapers and it leans
const float kFlyawaysPerMm2 = 1.0f / (kFlyawayLength * kFlyawayWidth * kFlyawayCover);  // on one side of the cloth, for a share of 1
const float kFlyawaysBound = 0.03f;      // share of fuzz that lies along the thread: what filament yarns have

const float kFlyawayCrowd = 0.4f;        // share of what a fibre sees that is other fibres

// Share of the area whose fibres stand off far enough to be seen one by one.
FORMULA float hair_share(float fuzz) { return max(fuzz - kFlyawaysBound, 0.0f); }

// Density over the sphere of the cosine of a turn whose mean is g; integrates to 1.
FORMULA float turn_density(float cosine, float g) {
  float x = 1.0f + g * g - 2.0f * g * cosine;
  return (1.0f - g * g) / (x * sqrt(x)) * 0.07957747f;
}

// Light that leaves a fibre, per steradian, by the cosine of its turn; integrates to 1.
FORMULA float hair_phase(float cosine) {
  return 0.55f * turn_density(cosine, -0.35f) + 0.45f * turn_density(cosine, 0.6f);
}

// Light that a fibre sends out, with what its neighbours send it of the same light.
FORMULA vec3 hair_gathered(vec3 colour) { return colour / (1.0f - kFlyawayCrowd * colour); }

// Radiance of a fibre along `fibre` for a unit of the key light's irradiance at right angles. colour: albedo
// of the fibre; body: share that the cloth beneath sends back; n: the cloth's normal on its side.
FORMULA vec3 hair_key(vec3 colour, vec3 body, vec3 fibre, vec3 n, vec3 l, vec3 v) {
  float along = dot(fibre, l);
  float sine = sqrt(max(1.0f - along * along, 0.0f));
  float met = sine * 1.2732395f;      // over its mean, pi / 4
  float beneath = max(dot(n, l), 0.0f) * 0.15915494f;   // half a sphere of the cloth's radiance
  return hair_gathered(colour) * (vec3(met * hair_phase(-dot(l, v))) + body * (beneath * (1.0f - kFlyawayCrowd)));
}

// Share of the sky's mean radiance: half of what is not fibres is sky, half the cloth.
FORMULA vec3 hair_soft(vec3 colour, vec3 body) {
  return hair_gathered(colour) * (0.5f + body * 0.5f) * (1.0f - kFlyawayCrowd);
}
