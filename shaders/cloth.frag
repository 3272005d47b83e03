// The cloth, by method: METHOD is its name, SHADE its function (the loader puts them there).
#include "frame.glsl"
#include "cloth_fetch.glsl"
#include "method_METHOD.glsl"

out vec4 out_color;

void main() {
  Side side = seen_side();
  Footprint f = footprint_here();
#if defined(MORE_LIT)
  vec4 color = vec4(0.0);
  for (light_at = 0; light_at <= last_light(); ++light_at) {
    vec4 more = SHADE(side, seen_lights(side), f);
    color = vec4(color.rgb + more.rgb, more.a);
    if (frame.methods.w > 0.5) break;   // false colours
  }
#else
  Lights lights = seen_lights(side);
  vec4 color = SHADE(side, lights, f);   // radiance and cover
#endif
  out_color = leave(color.rgb, color.a);
}
