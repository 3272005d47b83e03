// Rungs `repeat` and `cloth`: the measured answer of each system (core/light/cloth_response.h); `repeat` weighs it
// by the colour and cover of the footprint, `cloth` by their means and so needs no map at all.

vec4 broad_at(int system, vec3 l, vec3 v) {
  vec2 i = response_coord(l);
  vec2 o = response_coord(v);
  vec2 at = vec2((i.x + 0.5) / 17.0, (float(system) * 8.0 + i.y + 0.5) / 32.0);
  vec2 cell = min(floor(o), vec2(15.0, 6.0));
  vec2 t = o - cell;
  float next = cell.x > 14.5 ? 0.0 : cell.x + 1.0;
  vec4 near = mix(textureLod(response_map, vec3(at, cell.y * 16.0 + cell.x), 0.0), textureLod(response_map, vec3(at, cell.y * 16.0 + next), 0.0), t.x);
  vec4 far = mix(textureLod(response_map, vec3(at, cell.y * 16.0 + 16.0 + cell.x), 0.0), textureLod(response_map, vec3(at, cell.y * 16.0 + 16.0 + next), 0.0), t.x);
  return mix(near, far, t.y);
}

Answer answer_from_afar(Side side, Lights x, int which, vec2 slopes, vec3 color) {
  int system = side.face * 2 + which;
  SystemData data = cloth.systems[system];
  vec2 d = vec2(textureLod(slopes_map, vec2(slopes.x, (float(system) * 2.0 + 0.5) / 8.0), 0.0).r,
                textureLod(slopes_map, vec2(slopes.y, (float(system) * 2.0 + 1.5) / 8.0), 0.0).r);
  YarnLobes y = yarn_of(data.widths, data.weights, data.tint, data.extra, color);
  float sky = side.face == 0 ? cloth.relief.z : cloth.relief.w;
  return system_answer(y, broad_at(system, x.l, x.v), d, data.mean.w, sky, x.l, x.v);
}

vec3 shade_mixed(Side side, Lights x, vec4 warp, vec4 weft) {
  SystemData warp_data = cloth.systems[side.face * 2];
  SystemData weft_data = cloth.systems[side.face * 2 + 1];
  vec2 h = half_slopes(x.l, x.v);
  vec2 slopes = vec2(slope_coord(h.x), slope_coord(h.y));
  vec2 relative = vec2(warp.a, weft.a) / max(vec2(warp_data.mean.w, weft_data.mean.w), 1e-3);
  Answer a = answer_from_afar(side, x, 0, slopes, system_color(warp, warp_data));
  Answer b = answer_from_afar(side, x, 1, slopes, system_color(weft, weft_data));
  Answer m = mixed_answer(a, b, relative, seen_shares(side.face, x.v));
  vec3 mirrored = from_side(side, reflect(-x.v, vec3(0.0, 0.0, 1.0)));
  return x.key * m.key + (m.soft * sky_diffuse(side.n) + m.glossy * sky_radiance(mirrored, 0.7, 0.35)) * side.sky;
}

vec3 shade_repeat(Side side, Lights x, Footprint f) {
  return shade_mixed(side, x, fetch_color(side, f, 0), fetch_color(side, f, 1));
}

vec3 shade_cloth(Side side, Lights x) {
  SystemData warp = cloth.systems[side.face * 2];
  SystemData weft = cloth.systems[side.face * 2 + 1];
  return shade_mixed(side, x, vec4(warp.mean.rgb, 1.0) * warp.mean.w, vec4(weft.mean.rgb, 1.0) * weft.mean.w);
}
