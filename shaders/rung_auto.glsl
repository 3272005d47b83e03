// Rung `auto`: at each pixel the rungs that hold the tolerance at its footprint; two where one gives way to the
// next. Those of no weight are not evaluated.

// Vermilion, yellow, bluish green, blue (Okabe, Ito 2008), light enough to show the cloth's shading.
vec3 rung_color(vec4 weight) {
  return vec3(0.84, 0.37, 0.0) * weight.x + vec3(0.94, 0.89, 0.26) * weight.y + vec3(0.0, 0.62, 0.45) * weight.z
       + vec3(0.0, 0.45, 0.70) * weight.w;
}

vec3 shade_auto(Side side, Lights x, Footprint f) {
#if defined(QUICK)
  // While the view moves: one rung for the whole picture, the nearer of two.
#if FINEST_RUNG < 2
  return shade_yarn(side, x, f);
#else
  return shade_repeat(side, x, f);
#endif
#else
  // One answer for all the cloth holds only where its pattern is no longer seen.
  vec3 edges = vec3(frame.rungs.xy, max(frame.rungs.z, cloth.even.x));
  vec4 weight = rung_weights(f.yarns, edges);
  vec3 color = vec3(0.0);
#if FINEST_RUNG < 1
  if (weight.x > 0.0) color += weight.x * shade_yarn(side, x, f);
#endif
#if FINEST_RUNG < 2
  if (weight.y > 0.0) color += weight.y * shade_cell(side, x, f);
#endif
#if FINEST_RUNG < 3
  if (weight.z > 0.0) color += weight.z * shade_repeat(side, x, f);
#endif
  if (weight.w > 0.0) color += weight.w * shade_cloth(side, x);
  if (frame.rungs.w > 0.5) color = rung_color(weight) * (0.15 + 0.85 * sqrt(dot(color, vec3(0.2126, 0.7152, 0.0722))));
  return color;
#endif
}
