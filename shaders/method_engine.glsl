// Method `engine`: what an engine shows of the exported glTF set, from its mips: one averaged normal, roughness and
// direction averaged as the images are, the fitted colours (core/light/engine_fit.h).

vec4 shade_engine(Side side, Lights x, Footprint f) {
  SystemData a = cloth.systems[side.face * 2];
  SystemData b = cloth.systems[side.face * 2 + 1];
  EngineData fit = cloth.engine[side.face];
  System warp = fetch_system(side, f, 0);
  System weft = fetch_system(side, f, 1);
  vec2 weight = vec2(warp.color.a, weft.color.a) + 1e-4;
  weight /= weight.x + weight.y;
  vec3 n = warp.n * weight.x + weft.n * weight.y;
  n = normalize(vec3(n.xy - n.z * fit.lean.xy, n.z));
  vec4 lobe = fit.lobes[0] * weight.x + fit.lobes[1] * weight.y;
  vec4 body = fit.body[0] * weight.x + fit.body[1] * weight.y;
  vec2 width = clamp(lobe.zw, vec2(0.0), vec2(1.0));  // of the linear fit through the images
  float narrow = width.x * width.x;
  vec3 color = thread_color(side, warp.color, weft.color);
  float gain = 0.98 / max(side.face == 0 ? cloth.front_sky : cloth.back_sky, 0.1);
  EngineMaterial m;
  m.base = min(color * body.rgb * fit.base.rgb, vec3(1.0));
  m.metal = body.w;
  m.sheen = min(sqrt(color) * ((a.yarn.fuzz * weight.x + b.yarn.fuzz * weight.y) * fit.sheen.rgb), vec3(1.0));
  m.sheen_roughness = fit.sheen.w;
  m.alpha = vec2(mix(narrow, 1.0, width.y * width.y), narrow);
  m.f0 = fit.gloss.rgb;
  m.f90 = fit.base.w;
  m.occlusion = min(textureLod(horizon_map, vec3(f.at, float(side.face) * (cloth.azimuths + 1.0) + cloth.azimuths), f.level - 1.0).r * gain, 1.0);
  Reflected e = engine_radiance(m, lobe_frame(n, vec3(lobe.xy, 0.0)), x.l, x.v);
  vec3 mirrored = from_side(side, reflect(-x.v, n));
  vec3 light = x.key * e.key + (e.diffuse * sky_diffuse(from_side(side, n)) + e.glossy * sky_radiance(mirrored, 0.8, 0.45)) * side.sky;
  // Opacity is that of the images: engines do not close gaps at a slant.
  return vec4(light, cloth.open < 0.5 ? 1.0 : min(warp.color.a + weft.color.a, 1.0));
}
