// Rung `engine`: what an engine shows of the exported texture set: one averaged normal, anisotropic GGX, sheen.

vec2 micro_variance(SystemData data, vec3 fibre) {
  vec2 d = normalize(fibre.xy);
  float along = data.yarn.along_width * data.yarn.along_width;
  float across = data.yarn.across_width * data.yarn.across_width;
  return vec2(along * d.x * d.x + across * d.y * d.y, along * d.y * d.y + across * d.x * d.x);
}

vec4 shade_engine(Side side, Lights x, Footprint f) {
  SystemData a = cloth.systems[side.face * 2];
  SystemData b = cloth.systems[side.face * 2 + 1];
  System warp = fetch_system(side, f, 0);
  System weft = fetch_system(side, f, 1);
  vec2 share = vec2(warp.color.a, weft.color.a) + 1e-4;
  share /= share.x + share.y;
  vec3 n = normalize(warp.n * share.x + weft.n * share.y);
  vec2 slope = n.xy / max(n.z, 0.1);
  vec2 da = warp.n.xy / max(warp.n.z, 0.1) - slope;
  vec2 db = weft.n.xy / max(weft.n.z, 0.1) - slope;
  vec2 variance = (warp.variance + micro_variance(a, vec3(a.fibre_tan, 1.0, 0.0)) + da * da) * share.x
                + (weft.variance + micro_variance(b, vec3(1.0, b.fibre_tan, 0.0)) + db * db) * share.y;
  EngineMaterial m;
  // What the mirrored light takes of the colour an engine asks of its base.
  m.base = thread_color(side, warp.color, weft.color)
         * (mix(a.yarn.body, 1.0, a.yarn.tint.w) * share.x + mix(b.yarn.body, 1.0, b.yarn.tint.w) * share.y);
  m.metal = a.yarn.tint.w * share.x + b.yarn.tint.w * share.y;
  m.sheen = sqrt(thread_color(side, warp.color, weft.color)) * (a.yarn.fuzz * share.x + b.yarn.fuzz * share.y);
  m.sheen_roughness = a.yarn.fuzz_width * share.x + b.yarn.fuzz_width * share.y;
  m.alpha = sqrt(2.0 * variance);
  m.occlusion = textureLod(horizon_map, vec3(f.at, float(side.face) * (cloth.azimuths + 1.0) + cloth.azimuths), f.level - 1.0).r;
  Answer e = engine_answer(m, lobe_frame(n, vec3(1.0, 0.0, 0.0)), x.l, x.v);
  vec3 mirrored = from_side(side, reflect(-x.v, n));
  vec3 light = x.key * e.key + (e.soft * sky_diffuse(from_side(side, n)) + e.glossy * sky_radiance(mirrored, 0.8, 0.45)) * side.sky;
  return vec4(light, cover_of(side, x, f));
}
