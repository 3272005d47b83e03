// Rung `engine`: what an engine shows of the exported glTF set, from its mips: one averaged normal, roughness and direction
// averaged as the images hold them, the fitted colours (core/light/engine_fit.h).

// Lobes of one system as the images hold them.
struct EngineLobe {
  vec2 direction;    // of the wider axis
  float roughness;   // of the narrow one
  float strength;    // of the anisotropy
};

EngineLobe engine_lobe(SystemData data, vec3 fibre, vec2 spread) {
  vec2 d = normalize(fibre.xy);
  float along = data.yarn.along_width * data.yarn.along_width;
  float across = data.yarn.across_width * data.yarn.across_width;
  vec2 variance = vec2(along * d.x * d.x + across * d.y * d.y, along * d.y * d.y + across * d.x * d.x) + spread;
  vec2 alpha = min(sqrt(2.0 * variance), vec2(1.0));
  EngineLobe e;
  e.direction = alpha.x >= alpha.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
  float wide = max(alpha.x, alpha.y);
  float narrow = min(alpha.x, alpha.y);
  e.roughness = sqrt(narrow);
  e.strength = narrow < 1.0 ? sqrt((wide - narrow) / (1.0 - narrow)) : 0.0;
  return e;
}

vec4 shade_engine(Side side, Lights x, Footprint f) {
  SystemData a = cloth.systems[side.face * 2];
  SystemData b = cloth.systems[side.face * 2 + 1];
  vec4 fit = side.face == 0 ? cloth.front_engine_base : cloth.back_engine_base;
  vec4 fuzz = side.face == 0 ? cloth.front_engine_sheen : cloth.back_engine_sheen;
  System warp = fetch_system(side, f, 0);
  System weft = fetch_system(side, f, 1);
  vec2 share = vec2(warp.color.a, weft.color.a) + 1e-4;
  share /= share.x + share.y;
  vec3 n = normalize(warp.n * share.x + weft.n * share.y);
  EngineLobe p = engine_lobe(a, vec3(a.fibre_tan, 1.0, 0.0), fuzz.zw);
  EngineLobe q = engine_lobe(b, vec3(1.0, b.fibre_tan, 0.0), fuzz.zw);
  vec2 direction = p.direction * share.x + q.direction * share.y;
  float roughness = p.roughness * share.x + q.roughness * share.y;
  float strength = p.strength * share.x + q.strength * share.y;
  float narrow = roughness * roughness;
  vec3 color = thread_color(side, warp.color, weft.color);
  float gain = 0.98 / max(side.face == 0 ? cloth.front_sky : cloth.back_sky, 0.1);
  EngineMaterial m;
  m.base = min(color * (mix(a.yarn.body, 1.0, a.yarn.tint.w) * share.x + mix(b.yarn.body, 1.0, b.yarn.tint.w) * share.y) * fit.rgb, vec3(1.0));
  m.metal = a.yarn.tint.w * share.x + b.yarn.tint.w * share.y;
  m.sheen = min(sqrt(color) * ((a.yarn.fuzz * share.x + b.yarn.fuzz * share.y) * fuzz.x), vec3(1.0));
  m.sheen_roughness = fuzz.y;
  m.alpha = vec2(mix(narrow, 1.0, strength * strength), narrow);
  m.specular = fit.w;
  m.occlusion = min(textureLod(horizon_map, vec3(f.at, float(side.face) * (cloth.azimuths + 1.0) + cloth.azimuths), f.level - 1.0).r * gain, 1.0);
  Answer e = engine_answer(m, lobe_frame(n, vec3(direction, 0.0)), x.l, x.v);
  vec3 mirrored = from_side(side, reflect(-x.v, n));
  vec3 light = x.key * e.key + (e.soft * sky_diffuse(from_side(side, n)) + e.glossy * sky_radiance(mirrored, 0.8, 0.45)) * side.sky;
  return vec4(light, cover_of(side, x, f));
}
