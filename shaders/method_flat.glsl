// SampledMethod `flat`: filtered thread colour under Lambert's law.

vec4 shade_flat(Side side, Lights x, Footprint f) {
  vec3 light = x.key * (max(x.l.z, 0.0) / 3.14159265) + sky_diffuse(side.n) * side.sky;
  return vec4(thread_color(side, fetch_color(side, f, 0), fetch_color(side, f, 1)) * light, cover_of(side, x, f));
}
