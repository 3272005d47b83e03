// Methods `repeat` and `cloth`: the far-field response of each system (core/light/cloth_response.h). `repeat` weights
// it by the colour and coverage of the footprint and corrects it by the footprint's facets; `cloth` uses the means of
// the period and so needs no map at all.

// The system's response (table 0) or its gradient (table 1), interpolated between nodes.
vec4 response_at(int table, int system, vec3 l, vec3 v) {
  vec2 o = response_coord(v);
  const float views = float(RESPONSE_VIEWS_AROUND);
  const float up = float(RESPONSE_ELEVATIONS);
  const vec2 size = vec2(float(RESPONSE_WIDTH), float(RESPONSE_HEIGHT));
  vec2 from_front = response_coord(l) * vec2(float(RESPONSE_LIGHTS_AROUND), 1.0) + vec2(float(table * (RESPONSE_LIGHTS_AROUND + 1)), float(system) * up);
  vec2 from_behind = transmission_coord(l) * vec2(float(TRANSMISSION_LIGHTS_AROUND), 1.0) + vec2(0.0, 4.0 * up + float((table * 4 + system) * TRANSMISSION_ELEVATIONS));
  vec2 at = ((l.z > 0.0 ? from_front : from_behind) + 0.5) / size;
  o.x *= views;
  vec2 cell = min(floor(o), vec2(views - 1.0, up - 2.0));
  vec2 t = o - cell;
  float layer = cell.y * views + cell.x;
  float next = cell.x > views - 1.5 ? cell.y * views : layer + 1.0;
  // Linear over the triangle of the cell that it lies in, from three of its corners.
  float corner = t.x + t.y < 1.0 ? layer : next + views;
  vec2 side = t.x + t.y < 1.0 ? t : 1.0 - t.yx;
  return textureLod(response_map, vec3(at, corner), 0.0) * (1.0 - side.x - side.y)
       + textureLod(response_map, vec3(at, next), 0.0) * side.x + textureLod(response_map, vec3(at, layer + views), 0.0) * side.y;
}

Reflected far_field_of(Side side, Lights x, int which, vec2 slopes, vec3 color) {
  int system = side.face * 2 + which;
  SystemData data = cloth.systems[system];
  const float edge = 0.5 / float(RESPONSE_SLOPES);  // between the tables of two systems
  float d = textureLod(slopes_map, vec2(slopes.x, (float(system) + clamp(slopes.y, edge, 1.0 - edge)) / 4.0), 0.0).r;
  YarnLobes y = yarn_of(data.yarn, color);
  vec4 reflected = response_at(0, system, x.l, x.v);
  if (x.l.z > 0.0) reflected.y = mirror_of(reflected.y);
  return system_radiance(y, reflected, d, data.fraction, view_table(side.face, 1 + which, x.v), x.l, x.v);
}

vec2 half_slope_coords(Lights x) {
  vec2 h = half_slopes(x.l, x.v);
  return vec2(slope_coord(h.x), slope_coord(h.y));
}

vec3 mixed_light(Side side, Lights x, Reflected m) {
  vec4 from = view_table(side.face, 3, x.v);
  vec2 along = x.v.xy * inversesqrt(max(dot(x.v.xy, x.v.xy), 1e-8));
  vec3 sky = m.diffuse * sky_about(from_side(side, vec3(along * from.x, from.y)))
           + m.glossy * sky_about(from_side(side, vec3(along * from.z, from.w)));
  return x.key * m.key + sky * side.sky;
}

// One system in the footprint.
struct LocalSystem {
  vec4 color;    // premultiplied by coverage
  vec4 facets;   // means of the unit normal's x, y and of their squares
  float around;  // coverage of about eight yarns around
};

// Four samples a pixel: two by two in a square pixel, a row in a long one (a zigzag between), each at the mip level of
// their spacing; one level coarser where a pixel holds more than the period of the weave, which would alias to moire.
// at: the centre of the pixel, on the tile.
LocalSystem fetch_local(Side s, Footprint f, int which, vec2 at) {
  LocalSystem y;
  y.color = vec4(0.0);
  vec4 sum = vec4(0.0);
  vec2 texels = vec2(textureSize(color_map, 0).xy);
  vec2 x_side = f.dx * texels;
  vec2 y_side = f.dy * texels;
  float squares = dot(x_side, x_side) / max(dot(y_side, y_side), 1e-12);
  vec2 longer = squares > 1.0 ? f.dx : f.dy;
  vec2 shorter = squares > 1.0 ? f.dy : f.dx;
  float row = min(0.25 * abs(log2(max(squares, 1e-6))), 1.0);   // 1 where the pixel is four times as long as wide
  vec2 aside = shorter * (0.25 - 0.25 * row);
  int system = s.face * 2 + which;
  float level = f.level - 1.0 - row + clamp(log2(max(f.yarns, 1e-3) / cloth.half_period), 0.0, 1.0);
  for (int i = 0; i < 4; ++i) {
    float half_side = i < 2 ? -0.25 : 0.25;
    float turn = i == 0 || i == 2 ? -1.0 : 1.0;
    vec3 p = vec3(at + longer * (half_side + turn * 0.125 * row) + aside * turn, float(system));
    y.color += 0.25 * textureLod(color_map, p, level);
    sum += 0.25 * textureLod(relief_map, p, level);
  }
  // Mip level of four yarns, interpolated between texels.
  float wide = log2(4.0 * texels.x * cloth.spacing_mm / cloth.width_mm);
  y.around = wide > level ? textureLod(color_map, vec3(at, float(system)), floor(wide + 0.5)).a : y.color.a;
  y.facets = (sum + cloth.systems[system].facets * 0.004) / (y.color.a + 0.004);
  return y;
}

// Mean of gradient_factor() over footprints like this one, 1 or more: it is held at 0 where the facets would give less,
// which at steep gradients (light and view low and opposite) made near cloth too bright. Deviations are taken as logistic;
// resolved: fraction of the facets' variance that is between footprints. Its square agrees better, since means over a
// footprint have no long tails.
float held_mean(vec4 gradient, vec4 facets, vec4 mean_facets) {
  const float squares = 0.8;        // variance of a round thread's squared slant over its squared mean
  const float logistic = 0.551329;  // scale of the distribution over its standard deviation
  vec2 all = max(mean_facets.zw - mean_facets.xy * mean_facets.xy, vec2(1e-4));
  vec2 resolved = clamp(1.0 - (facets.zw - facets.xy * facets.xy) / all, 0.0, 1.0);
  vec2 counts = resolved * resolved;
  vec4 variance = vec4(all, squares * mean_facets.zw * mean_facets.zw) * vec4(counts, counts);
  float scale = max(logistic * sqrt(dot(gradient * gradient, variance)), 1e-3);
  return 1.0 + scale * log(1.0 + exp(-1.0 / scale));
}

// A system's radiance, corrected by the facets of the footprint.
Reflected local_radiance(Side side, Lights x, LocalSystem y, int which, vec2 slopes) {
  int system = side.face * 2 + which;
  SystemData data = cloth.systems[system];
  Reflected a = far_field_of(side, x, which, slopes, system_color(y.color, data));
  vec4 gradient = response_at(1, system, x.l, x.v);
  a.key *= gradient_factor(gradient, y.facets, data.facets) / held_mean(gradient, y.facets, data.facets);
  return a;
}

vec3 repeat_light(Side side, Lights x, Footprint f) {
  VisibleSystems seen = visible_systems(side.face, x.v);
  // Points above the middle plane appear nearer to the eye than the pixel's position on it.
  vec2 towards = x.v.xy / (x.v.z * vec2(cloth.width_mm, cloth.depth_mm));
  LocalSystem warp = fetch_local(side, f, 0, f.at + towards * seen.height.x);
  LocalSystem weft = fetch_local(side, f, 1, f.at + towards * seen.height.y);
  vec2 fraction = vec2(cloth.systems[side.face * 2].fraction, cloth.systems[side.face * 2 + 1].fraction);
  vec2 cover = vec2(cloth.systems[side.face * 2].coverage, cloth.systems[side.face * 2 + 1].coverage);
  vec2 relative = vec2(warp.color.a, weft.color.a) / max(cover, vec2(1e-3));
  vec2 region = vec2(warp.around, weft.around) * (cover.x + cover.y) / max(cover * (warp.around + weft.around), vec2(1e-3));
  vec2 rise = seen.rise * fraction / max(seen.fraction, vec2(1e-3)) - 1.0;
  relative *= vec2(region_factor(rise.x, region.x), region_factor(rise.y, region.y));
  vec2 slopes = half_slope_coords(x);
  Reflected a = local_radiance(side, x, warp, 0, slopes);
  Reflected b = local_radiance(side, x, weft, 1, slopes);
  return mixed_light(side, x, mixed_radiance(a, b, relative, seen.fraction));
}

vec3 cloth_light(Side side, Lights x) {
  vec2 slopes = half_slope_coords(x);
  Reflected a = far_field_of(side, x, 0, slopes, cloth.systems[side.face * 2].color.rgb);
  Reflected b = far_field_of(side, x, 1, slopes, cloth.systems[side.face * 2 + 1].color.rgb);
  return mixed_light(side, x, mixed_radiance(a, b, vec2(1.0), vec2(0.5)));
}

vec4 shade_repeat(Side side, Lights x, Footprint f) { return vec4(repeat_light(side, x, f), cover_of(side, x, f)); }
vec4 shade_cloth(Side side, Lights x, Footprint f) { return vec4(cloth_light(side, x), cover_of(side, x, f)); }
