// GLSL only: the tables of lobes.glsl as textures (core/light/tables.h fills them). Linear filter, clamped to the
// edge; a table of n entries has coordinate 0 at the centre of its first texel and 1 at the centre of its last.

uniform sampler3D albedo_texture;       // RGBA float: opening, along, across
uniform sampler2D albedo_mean_texture;  // RG float: major, minor
uniform sampler2D fuzz_texture;         // RGBA float: opening, depth

vec4 albedo_table(float opening, float along, float across) {
  vec3 n = vec3(textureSize(albedo_texture, 0));
  vec3 at = clamp(vec3(opening, along, across), 0.0, 1.0);
  return textureLod(albedo_texture, (at * (n - 1.0) + 0.5) / n, 0.0);
}

vec2 albedo_mean_table(float major, float minor) {
  vec2 n = vec2(textureSize(albedo_mean_texture, 0));
  vec2 at = clamp(vec2(major, minor), 0.0, 1.0);
  return textureLod(albedo_mean_texture, (at * (n - 1.0) + 0.5) / n, 0.0).xy;
}

vec4 fuzz_table(float opening, float depth) {
  vec2 n = vec2(textureSize(fuzz_texture, 0));
  vec2 at = clamp(vec2(opening, depth), 0.0, 1.0);
  return textureLod(fuzz_texture, (at * (n - 1.0) + 0.5) / n, 0.0);
}
