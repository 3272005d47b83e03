// Rung `yarn`: the thread on top where the eye's ray meets the cloth, its own frame and lobes, under the light
// that the horizon of its place leaves. The ray is followed through the heights, so that near threads hide far
// ones at grazing views.
//
// Based on: Policarpo, Oliveira, Comba 2005 (relief mapping: linear steps, then the secant).

float height_at(Side side, Footprint f, vec2 at) {
  return textureLod(height_map, vec3(at, float(side.face)), f.level).r * 2.0 - 1.0;
}

// Where the ray that leaves the cloth's middle plane at f.at towards v meets the surface.
vec2 met_at(Side side, Footprint f, vec3 v) {
  vec2 shift = v.xy * (cloth.relief.x / max(v.z, 0.04)) / cloth.size.xy;   // for a height of 1
  float yarns = length(shift * cloth.size.xy) / cloth.size.z;
#if defined(QUICK)
  return f.at + shift * height_at(side, f, f.at);
#else
  if (yarns < 0.04) return f.at + shift * height_at(side, f, f.at);
  float top = cloth.relief.y;
  int steps = int(clamp(ceil(yarns * top * 12.0), 4.0, 48.0));
  float down = 2.0 * top / float(steps);
  float z = top;
  float above = 1.0;
  for (int i = 0; i < steps; ++i) {
    float next = z - down;
    float below = next - height_at(side, f, f.at + shift * next);
    if (below <= 0.0) {
      float t = above / max(above - below, 1e-5);
      z -= down * t;
      // Once more inside the step.
      float miss = z - height_at(side, f, f.at + shift * z);
      z -= miss > 0.0 ? down * (1.0 - t) * miss / max(miss - below, 1e-5)
                      : -down * t * miss / min(miss - above, -1e-5);
      break;
    }
    above = below;
    z = next;
  }
  return f.at + shift * z;
#endif
}

vec3 shade_top(Side side, Lights x, Footprint f) {
  f.at = met_at(side, f, x.v);
  vec4 warp = fetch_color(side, f, 0);
  vec4 weft = fetch_color(side, f, 1);
  bool upper = warp.a >= weft.a;
  System top;
  top.color = upper ? warp : weft;
  fetch_relief(side, f, upper ? 0 : 1, top);
  SystemData data = cloth.systems[side.face * 2];
  if (!upper) data = cloth.systems[side.face * 2 + 1];
  float turn = data.widths.z;
  vec3 fibre = upper ? vec3(turn, 1.0, 0.0) : vec3(1.0, turn, 0.0);
  YarnLobes lobes = yarn_of(data.widths, data.weights, data.tint, data.extra, thread_color(side, warp, weft));
  vec2 open = thread_light(side, f, x.l);
  if (dot(top.n, x.l) < 0.0 && x.l.z > 0.0) {
    // Light from behind crosses this thread alone: what lies beyond it decides.
    Footprint entry = f;
    entry.at += x.l.xy * (0.6 * cloth.size.z / max(length(x.l.xy), 1e-4)) / cloth.size.xy;
    open.x = thread_light(side, entry, x.l).x;
  }
  Answer a = facet_answer(lobes, top.n, top.gather, fibre, vec3(top.variance.x, 0.0, top.variance.y), x.l, x.v);
  vec3 n_world = from_side(side, top.n);
  vec3 mirrored = from_side(side, reflect(-x.v, top.n));
  return x.key * a.key * open.x
       + (a.soft * sky_diffuse(n_world) + a.glossy * sky_radiance(mirrored, 0.8, 0.45)) * (side.sky * open.y);
}

// A long footprint is taken in parts, each about as long as it is wide.
vec3 shade_yarn(Side side, Lights x, Footprint f) {
#if defined(QUICK)
  return shade_top(side, x, f);
#else
  int parts = int(clamp(ceil(f.ratio * 0.8 - 0.4), 1.0, 5.0));
  vec2 middle = f.at;
  vec3 sum = vec3(0.0);
  f.level = min(f.level, f.level_near + log2(f.ratio / float(parts)));
  for (int i = 0; i < parts; ++i) {
    f.at = middle + f.axis * ((float(i) + 0.5) / float(parts) - 0.5);
    sum += shade_top(side, x, f);
  }
  return sum / float(parts);
#endif
}
