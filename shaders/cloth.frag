// The cloth, by method: METHOD is its name, SHADE its function (the loader puts them there).
#include "frame.glsl"
#include "cloth_fetch.glsl"
#include "rung_METHOD.glsl"

out vec4 out_color;

void main() {
  Side side = seen_side();
  Lights lights = seen_lights(side);
  Footprint f = footprint_here();
  vec4 color = SHADE(side, lights, f);   // radiance and cover
  out_color = leave(color.rgb, color.a);
}
