// Rung `yarn`: the lobes of each thread system in the frame of its fibres, shadows and masking of thread on thread.
// Where a pixel holds many threads, mean and spread of their normals widen the lobe, so that the same formulas
// serve near and far.

#include "tables.glsl"
#include "lobes.glsl"

// What one system sends to the eye, without its share of the pixel.
struct Sent {
  vec3 key;     // a unit of the key light's irradiance at right angles
  vec3 sky;
};

YarnLobes lobes_of(SystemData s, vec3 color) {
  YarnLobes y;
  float metal = s.tint.w;
  y.slope_cov = vec3(s.widths.x * s.widths.x, 0.0, s.widths.y * s.widths.y);
  y.f90 = s.weights.x;
  y.f0 = s.tint.rgb * s.weights.x * mix(vec3(s.extra.x), color, metal);
  vec3 body = color * (s.weights.y * (1.0 - metal));
  y.body = body * (1.0 - s.weights.w);
  y.through = body * s.weights.w;
  y.fuzz_colour = sqrt(color);
  y.fuzz = s.weights.z;
  y.fuzz_depth = s.extra.z;
  return y;
}

Sent send(Side side, Lights x, System system, SystemData data, vec3 axis, vec3 across) {
  vec3 color = (system.color.rgb + data.mean.rgb * 0.004) / (system.color.a + 0.004);
  vec3 n = normalize(system.n);
  LobeFrame frame_here = lobe_frame(n, axis + across * data.widths.z);
  vec2 slopes = system.variance / max(n.z * n.z, 0.05);
  YarnLobes y = yarn_widen(lobes_of(data, min(color, vec3(1.0))), lobe_covariance(frame_here, vec3(slopes.x, 0.0, slopes.y)));
  LobeShared shared_part = lobe_shared(y);
  vec3 wo = lobe_local(frame_here, x.v);
  wo = normalize(vec3(wo.xy, max(wo.z, 0.03)));
  vec3 wi = lobe_local(frame_here, vec3(x.l.xy, abs(x.l.z)));
  float facing = max(wi.z, 0.0);
  LobeSide o = lobe_side(y, shared_part, wo);
  LobeSide i = lobe_side(y, shared_part, vec3(wi.xy, max(wi.z, 1e-3)));
  Sent sent;
  sent.key = x.l.z > 0.0 ? lobe_reflect(y, shared_part, i, o, wi, wo) : lobe_transmit(y, shared_part, i, o);
  sent.key *= facing;
  vec3 n_world = from_side(side, n);
  vec3 mirrored = from_side(side, reflect(-x.v, n));
  vec3 soft = sky_diffuse(n_world);
  vec3 glossy = sky_radiance(mirrored, 0.8, 0.45);
  sent.sky = lobe_albedo(y, shared_part, o) * soft + max(1.0 - o.enters, vec3(0.0)) * (glossy - soft);
  return sent;
}

// Projected area of a system's facets towards the eye.
float facet_area(System system, vec3 v) {
  vec3 n = normalize(system.n);
  vec2 slopes = system.variance / max(n.z * n.z, 0.05);
  return gaussian_area(max(dot(n, v), 0.02), sqrt(dot(slopes, v.xy * v.xy)));
}

vec3 shade(Side side, Lights x, System warp, System weft) {
  SystemData warp_data = cloth.systems[side.face * 2];
  SystemData weft_data = cloth.systems[side.face * 2 + 1];
  vec2 open = thread_light(side, vec3(x.l.xy, abs(x.l.z)));
  vec2 share = vec2(warp.color.a, weft.color.a) + 1e-4;
  share /= share.x + share.y;
  vec2 seen = share * system_masking(share, vec2(facet_area(warp, x.v), facet_area(weft, x.v)), warp_data.extra.w, x.v);
#if defined(QUICK)
  // While the view moves: the lobes of the system that holds most of the pixel, in the colour of both.
  bool upper = seen.x >= seen.y;
  System most;
  most.color = vec4(thread_color(side, warp, weft), 1.0);
  most.n = upper ? warp.n : weft.n;
  most.variance = upper ? warp.variance : weft.variance;
  SystemData data = warp_data;
  if (!upper) data = weft_data;
  Sent a = send(side, x, most, data, upper ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0),
                upper ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0));
  return x.key * a.key * open.x + a.sky * (side.sky * open.y);
#else
  Sent a = send(side, x, warp, warp_data, vec3(0.0, 1.0, 0.0), vec3(1.0, 0.0, 0.0));
  Sent b = send(side, x, weft, weft_data, vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
  return x.key * (a.key * seen.x + b.key * seen.y) * open.x + (a.sky * seen.x + b.sky * seen.y) * (side.sky * open.y);
#endif
}
