// SampledMethod `auto`: at each pixel the rungs that hold the tolerance at its footprint; two where one gives way to the
// next. Those of no weight are not evaluated. METHODS: which the picture needs at all, by bits (yarn 1, cell 2,
// repeat 4, cloth 8).

#include "method_cell.glsl"
#include "method_colors.glsl"
#include "method_repeat.glsl"
#include "method_yarn.glsl"

vec3 methods_color(vec4 weight) {
  return method_color(0) * weight.x + method_color(1) * weight.y + method_color(2) * weight.z + method_color(3) * weight.w;
}

vec4 shade_auto(Side side, Lights x, Footprint f) {
  float cover = cover_of(side, x, f);   // of the prefiltered rungs
#if defined(QUICK)
  // While the view moves: one rung for the whole picture, the nearer of two.
#if (METHODS & 1) != 0
  return shade_yarn(side, x, f);
#elif (METHODS & 2) != 0
  return vec4(cell_light(side, x, f), cover);
#else
  return vec4(repeat_light(side, x, f), cover);
#endif
#else
  vec4 weight = lod_weights(f.yarns, frame.methods.xyz) * vec4(METHODS & 1, (METHODS >> 1) & 1, (METHODS >> 2) & 1, METHODS >> 3);
  weight /= max(weight.x + weight.y + weight.z + weight.w, 1.0e-6);
  vec4 color = vec4(0.0);   // weighted by cover
#if (METHODS & 1) != 0
  if (weight.x > 0.0) {
    vec4 near = shade_yarn(side, x, f);
    color += weight.x * vec4(near.rgb * near.a, near.a);
  }
#endif
  vec3 far = vec3(0.0);
#if (METHODS & 2) != 0
  if (weight.y > 0.0) far += weight.y * cell_light(side, x, f);
#endif
#if (METHODS & 4) != 0
  if (weight.z > 0.0) far += weight.z * repeat_light(side, x, f);
#endif
#if (METHODS & 8) != 0
  if (weight.w > 0.0) far += weight.w * cloth_light(side, x);
#endif
  color += vec4(far, weight.y + weight.z + weight.w) * cover;
  color.rgb /= max(color.a, 1.0e-4);
  if (frame.methods.w > 0.5) color.rgb = methods_color(weight) * (0.15 + 0.85 * sqrt(dot(color.rgb, vec3(0.2126, 0.7152, 0.0722))));
  return color;
#endif
}
