// Rung `cell`: each system's mean facet in the footprint, its lobe widened by the spread of the normals, under
// mean and spread of the horizon; shares of the systems by what the eye sees of them.

Answer answer_of(Lights x, System system, SystemData data, vec3 fibre) {
  YarnLobes y = yarn_of(data.yarn, system_color(system.color, data));
  return facet_answer(y, system.n, system.gather, fibre, vec3(system.variance.x, 0.0, system.variance.y), x.l, x.v);
}

vec3 cell_light(Side side, Lights x, Footprint f) {
  SystemData warp_data = cloth.systems[side.face * 2];
  SystemData weft_data = cloth.systems[side.face * 2 + 1];
  System warp = fetch_system(side, f, 0);
  System weft = fetch_system(side, f, 1);
  vec2 open = thread_light(side, f, x.l);
  vec2 share = vec2(warp.color.a, weft.color.a) / max(vec2(warp_data.coverage, weft_data.coverage), 1e-3) * seen_systems(side.face, x.v).share + 1e-5;
  share /= share.x + share.y;
  Answer a = answer_of(x, warp, warp_data, vec3(warp_data.fibre_tan, 1.0, 0.0));
  Answer b = answer_of(x, weft, weft_data, vec3(1.0, weft_data.fibre_tan, 0.0));
  vec3 key = a.key * share.x + b.key * share.y;
  vec3 soft = a.soft * share.x + b.soft * share.y;
  vec3 glossy = a.glossy * share.x + b.glossy * share.y;
  vec3 n = normalize(warp.n * share.x + weft.n * share.y);
  vec3 mirrored = from_side(side, reflect(-x.v, n));
  return x.key * key * open.x
       + (soft * sky_diffuse(from_side(side, n)) + glossy * sky_radiance(mirrored, 0.7, 0.35)) * (side.sky * open.y);
}

vec4 shade_cell(Side side, Lights x, Footprint f) { return vec4(cell_light(side, x, f), cover_of(side, x, f)); }
