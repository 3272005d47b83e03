// Rung `flat`: filtered thread colour under Lambert's law.

vec3 shade(Side side, Lights x, System warp, System weft) {
  vec3 light = x.key * (max(x.l.z, 0.0) / 3.14159265) + sky_diffuse(side.n) * side.sky;
  return thread_color(side, warp, weft) * light;
}
