// Rungs `repeat` and `cloth`: the measured answer of each system (core/light/cloth_response.h). `repeat` weighs it by
// the colour and cover of the footprint and leans it with the footprint's facets; `cloth` takes the means of the
// period and so needs no map at all.

// Of the system's answer (table 0) or of how it leans (table 1), between the nodes.
vec4 response_at(int table, int system, vec3 l, vec3 v) {
  vec2 o = response_coord(v);
  const float views = float(RESPONSE_VIEWS_AROUND);
  const float up = float(RESPONSE_ELEVATIONS);
  const vec2 size = vec2(float(RESPONSE_WIDTH), float(RESPONSE_HEIGHT));
  vec2 before = response_coord(l) * vec2(float(RESPONSE_LIGHTS_AROUND), 1.0) + vec2(float(table * (RESPONSE_LIGHTS_AROUND + 1)), float(system) * up);
  vec2 behind = transmission_coord(l) * vec2(float(BEHIND_AROUND), 1.0) + vec2(0.0, 4.0 * up + float((table * 4 + system) * BEHIND_ELEVATIONS));
  vec2 at = ((l.z > 0.0 ? before : behind) + 0.5) / size;
  o.x *= views;
  vec2 cell = min(floor(o), vec2(views - 1.0, up - 2.0));
  vec2 t = o - cell;
  float layer = cell.y * views + cell.x;
  float next = cell.x > views - 1.5 ? cell.y * views : layer + 1.0;
  // Over the half of the cell that it lies in, by three of its corners.
  float corner = t.x + t.y < 1.0 ? layer : next + views;
  vec2 side = t.x + t.y < 1.0 ? t : 1.0 - t.yx;
  return textureLod(response_map, vec3(at, corner), 0.0) * (1.0 - side.x - side.y)
       + textureLod(response_map, vec3(at, next), 0.0) * side.x + textureLod(response_map, vec3(at, layer + views), 0.0) * side.y;
}

Answer far_field_of(Side side, Lights x, int which, vec2 slopes, vec3 color) {
  int system = side.face * 2 + which;
  SystemData data = cloth.systems[system];
  vec2 d = vec2(textureLod(slopes_map, vec2(slopes.x, (float(system) * 2.0 + 0.5) / 8.0), 0.0).r,
                textureLod(slopes_map, vec2(slopes.y, (float(system) * 2.0 + 1.5) / 8.0), 0.0).r);
  YarnLobes y = yarn_of(data.yarn, color);
  vec4 broad = response_at(0, system, x.l, x.v);
  return system_answer(y, broad, d, data.share, seen_along(side.face, 1 + which, x.v), x.l, x.v);
}

vec2 half_slope_coords(Lights x) {
  vec2 h = half_slopes(x.l, x.v);
  return vec2(slope_coord(h.x), slope_coord(h.y));
}

vec3 mixed_light(Side side, Lights x, Answer m) {
  vec4 from = seen_along(side.face, 3, x.v);
  vec2 along = x.v.xy * inversesqrt(max(dot(x.v.xy, x.v.xy), 1e-8));
  vec3 sky = m.soft * sky_about(from_side(side, vec3(along * from.x, from.y)))
           + m.glossy * sky_about(from_side(side, vec3(along * from.z, from.w)));
  return x.key * m.key + sky * side.sky;
}

// One system in the footprint.
struct Local {
  vec4 color;    // premultiplied by coverage
  vec4 facets;   // means of the unit normal's x, y and of their squares
  float around;  // coverage of some eight yarns about each place, and more
};

// Four samples a pixel: two by two in a square one, a row in a long one (zigzag between), each read where the mips are
// about as wide as they lie apart. at: the pixel's middle, on the tile.
Local fetch_local(Side s, Footprint f, int which, vec2 at) {
  Local y;
  y.color = vec4(0.0);
  vec4 sum = vec4(0.0);
  vec2 texels = vec2(textureSize(color_map, 0).xy);
  vec2 x_side = f.dx * texels;
  vec2 y_side = f.dy * texels;
  float squares = dot(x_side, x_side) / max(dot(y_side, y_side), 1e-12);
  vec2 longer = squares > 1.0 ? f.dx : f.dy;
  vec2 shorter = squares > 1.0 ? f.dy : f.dx;
  float row = min(0.25 * abs(log2(max(squares, 1e-6))), 1.0);   // 1 where four times as long as wide
  vec2 aside = shorter * (0.25 - 0.25 * row);
  int system = s.face * 2 + which;
  float level = f.level - 1.0 - row;
  for (int i = 0; i < 4; ++i) {
    float half_side = i < 2 ? -0.25 : 0.25;
    float turn = i == 0 || i == 2 ? -1.0 : 1.0;
    vec3 p = vec3(at + longer * (half_side + turn * 0.125 * row) + aside * turn, float(system));
    y.color += 0.25 * textureLod(color_map, p, level);
    sum += 0.25 * textureLod(relief_map, p, level);
  }
  // Mips of four yarns, read between texels.
  float wide = log2(4.0 * texels.x * cloth.spacing_mm / cloth.width_mm);
  y.around = wide > level ? textureLod(color_map, vec3(at, float(system)), floor(wide + 0.5)).a : y.color.a;
  y.facets = (sum + cloth.systems[system].facets * 0.004) / (y.color.a + 0.004);
  return y;
}

// A system's answer where its facets lie otherwise than its mean ones.
Answer leaned_answer(Side side, Lights x, Local y, int which, vec2 slopes) {
  int system = side.face * 2 + which;
  SystemData data = cloth.systems[system];
  Answer a = far_field_of(side, x, which, slopes, system_color(y.color, data));
  a.key *= lean_factor(response_at(1, system, x.l, x.v), y.facets, data.facets);
  return a;
}

vec3 repeat_light(Side side, Lights x, Footprint f) {
  Seen seen = seen_systems(side.face, x.v);
  // What stands above the middle plane is seen nearer to the eye than the pixel's place on it.
  vec2 towards = x.v.xy / (x.v.z * vec2(cloth.width_mm, cloth.depth_mm));
  Local warp = fetch_local(side, f, 0, f.at + towards * seen.height.x);
  Local weft = fetch_local(side, f, 1, f.at + towards * seen.height.y);
  vec2 share = vec2(cloth.systems[side.face * 2].share, cloth.systems[side.face * 2 + 1].share);
  vec2 cover = vec2(cloth.systems[side.face * 2].coverage, cloth.systems[side.face * 2 + 1].coverage);
  vec2 relative = vec2(warp.color.a, weft.color.a) / max(cover, vec2(1e-3));
  vec2 region = vec2(warp.around, weft.around) * (cover.x + cover.y) / max(cover * (warp.around + weft.around), vec2(1e-3));
  vec2 rise = seen.rise * share / max(seen.share, vec2(1e-3)) - 1.0;
  relative *= vec2(region_factor(rise.x, region.x), region_factor(rise.y, region.y));
  vec2 slopes = half_slope_coords(x);
  Answer a = leaned_answer(side, x, warp, 0, slopes);
  Answer b = leaned_answer(side, x, weft, 1, slopes);
  return mixed_light(side, x, mixed_answer(a, b, relative, seen.share));
}

vec3 cloth_light(Side side, Lights x) {
  vec2 slopes = half_slope_coords(x);
  Answer a = far_field_of(side, x, 0, slopes, cloth.systems[side.face * 2].color.rgb);
  Answer b = far_field_of(side, x, 1, slopes, cloth.systems[side.face * 2 + 1].color.rgb);
  return mixed_light(side, x, mixed_answer(a, b, vec2(1.0), vec2(0.5)));
}

vec4 shade_repeat(Side side, Lights x, Footprint f) { return vec4(repeat_light(side, x, f), cover_of(side, x, f)); }
vec4 shade_cloth(Side side, Lights x, Footprint f) { return vec4(cloth_light(side, x), cover_of(side, x, f)); }
