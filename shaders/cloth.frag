// The cloth. METHOD is the name of the shading method, SHADE its function (the loader defines them).
#include "frame.glsl"
#include "cloth_fetch.glsl"
#include "method_METHOD.glsl"

out vec4 out_color;

void main() {
  Side side = viewed_side();
  Footprint f = footprint_here();
#if defined(MORE_LIT)
  vec4 color = vec4(0.0);
  for (light_index = 0; light_index <= last_light(); ++light_index) {
    vec4 more = SHADE(side, side_lights(side), f);
    color = vec4(color.rgb + more.rgb, more.a);
    if (frame.methods.w > 0.5) break;   // false colours
  }
#else
  Lights lights = side_lights(side);
  vec4 color = SHADE(side, lights, f);   // radiance and cover
#endif
  out_color = encoded(color.rgb, color.a);
}
