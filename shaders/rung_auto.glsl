// Rung `auto`: at each pixel the rungs that hold the tolerance at its footprint; two where one gives way to the
// next. Those of no weight are not evaluated.

// Vermilion, yellow, bluish green, blue (Okabe, Ito 2008), light enough to show the cloth's shading.
vec3 rung_color(vec4 weight) {
  return vec3(0.84, 0.37, 0.0) * weight.x + vec3(0.94, 0.89, 0.26) * weight.y + vec3(0.0, 0.62, 0.45) * weight.z
       + vec3(0.0, 0.45, 0.70) * weight.w;
}

// cover: of the prefiltered rungs.
vec4 shade_auto(Side side, Lights x, Footprint f, float cover) {
#if defined(QUICK)
  // While the view moves: one rung for the whole picture, the nearer of two.
#if FINEST_RUNG < 1
  return shade_yarn(side, x, f);
#elif FINEST_RUNG < 2
  return vec4(shade_cell(side, x, f), cover);
#else
  return vec4(shade_repeat(side, x, f), cover);
#endif
#else
  // One answer for all the cloth holds only where its pattern is no longer seen.
  vec3 edges = vec3(frame.rungs.xy, max(frame.rungs.z, cloth.even.x));
  vec4 weight = rung_weights(f.yarns, edges);
  vec4 color = vec4(0.0);   // weighted by cover
#if FINEST_RUNG < 1
  if (weight.x > 0.0) {
    vec4 near = shade_yarn(side, x, f);
    color += weight.x * vec4(near.rgb * near.a, near.a);
  }
#endif
  vec3 far = vec3(0.0);
#if FINEST_RUNG < 2
  if (weight.y > 0.0) far += weight.y * shade_cell(side, x, f);
#endif
#if FINEST_RUNG < 3
  if (weight.z > 0.0) far += weight.z * shade_repeat(side, x, f);
#endif
  if (weight.w > 0.0) far += weight.w * shade_cloth(side, x);
  color += vec4(far, weight.y + weight.z + weight.w) * cover;
  color.rgb /= max(color.a, 1.0e-4);
  if (frame.rungs.w > 0.5) color.rgb = rung_color(weight) * (0.15 + 0.85 * sqrt(dot(color.rgb, vec3(0.2126, 0.7152, 0.0722))));
  return color;
#endif
}
