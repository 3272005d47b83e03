// The cloth, by rung: METHOD_FLAT, METHOD_VRST03 or METHOD_YARN.
#include "frame.glsl"
#include "cloth_fetch.glsl"

#if defined(METHOD_FLAT)
#include "rung_flat.glsl"
#elif defined(METHOD_VRST03)
#include "rung_vrst03.glsl"
#else
#include "rung_yarn.glsl"
#endif

out vec4 out_color;

void main() {
  Side side = seen_side();
  Lights lights = seen_lights(side);
  System warp = fetch_system(side, 0);
  System weft = fetch_system(side, 1);
  float coverage = min(warp.color.a + weft.color.a, 1.0);
  vec3 color = shade(side, lights, warp, weft);
  float alpha = coverage;
  if (cloth.gaps.w > 0.5) alpha = coverage_by_view(coverage, cloth.gaps.xy, cloth.gaps.z, lights.v);
  out_color = leave(color, alpha);
}
