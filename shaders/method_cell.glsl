// SampledMethod `cell`: each system's mean facet in the footprint, its lobe widened by the spread of the normals, under
// mean and spread of the horizon; shares of the systems by what the eye sees of them. Light from behind as it was measured:
// mean facets say nothing of the few places that no other thread hides.

Answer answer_of(Lights x, System system, SystemData data, vec3 fibre) {
  YarnLobes y = yarn_of(data.yarn, system_color(system.color, data));
  return facet_answer(y, system.n, system.gather, fibre, vec3(system.variance.x, 0.0, system.variance.y), x.l, x.v);
}

// A system's measured answer to light from behind: between the nodes of the light, of the view the one before or the one
// after by chance as it lies between them, which is one fetch.
vec4 behind_near(int system, vec3 l, vec3 v) {
  const float views = float(RESPONSE_VIEWS_AROUND);
  vec2 o = response_coord(v) * vec2(views, 1.0);
  float turn = pass_turn();
  vec2 node = floor(o + vec2(turn, fract(17.0 * turn)));
  vec2 at = transmission_coord(l) * vec2(float(BEHIND_AROUND), 1.0) + vec2(0.0, 4.0 * float(RESPONSE_ELEVATIONS) + float(system * BEHIND_ELEVATIONS));
  float layer = node.y * views + (node.x > views - 0.5 ? 0.0 : node.x);
  return textureLod(response_map, vec3((at + 0.5) / vec2(float(RESPONSE_WIDTH), float(RESPONSE_HEIGHT)), layer), 0.0);
}

vec3 through_cell(Side side, Lights x, System system, SystemData data, int which) {
  YarnLobes y = yarn_of(data.yarn, system_color(system.color, data));
  return key_far_field(y, behind_near(side.face * 2 + which, x.l, x.v), 1.0, x.l, x.v);
}

vec3 cell_light(Side side, Lights x, Footprint f) {
  SystemData warp_data = cloth.systems[side.face * 2];
  SystemData weft_data = cloth.systems[side.face * 2 + 1];
  System warp = fetch_system(side, f, 0);
  System weft = fetch_system(side, f, 1);
  vec2 open = thread_light(side, f, x.l);
  vec2 share = vec2(warp.color.a, weft.color.a) / max(vec2(warp_data.coverage, weft_data.coverage), 1e-3);
  vec2 seen = seen_systems(side.face, x.v).share;
  share *= 1.0 / (dot(share, seen) + 1e-5);
  vec3 through = through_cell(side, x, warp, warp_data, 0) * share.x + through_cell(side, x, weft, weft_data, 1) * share.y;
  share *= seen;
  Answer a = answer_of(x, warp, warp_data, vec3(warp_data.fibre_tan, 1.0, 0.0));
  Answer b = answer_of(x, weft, weft_data, vec3(1.0, weft_data.fibre_tan, 0.0));
  vec3 key = a.key * share.x + b.key * share.y;
  vec3 soft = a.soft * share.x + b.soft * share.y;
  vec3 glossy = a.glossy * share.x + b.glossy * share.y;
  vec3 n = normalize(warp.n * share.x + weft.n * share.y);
  vec3 mirrored = from_side(side, reflect(-x.v, n));
  return x.key * (x.l.z > 0.0 ? key * open.x : through)
       + (soft * sky_diffuse(from_side(side, n)) + glossy * sky_radiance(mirrored, 0.7, 0.35)) * (side.sky * open.y);
}

vec4 shade_cell(Side side, Lights x, Footprint f) { return vec4(cell_light(side, x, f), cover_of(side, x, f)); }
