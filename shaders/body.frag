// Matt plaster: quiet beside any cloth.
#include "frame.glsl"

in vec3 position;
in vec3 normal;
in vec2 sky_seen;
out vec4 out_color;

const vec3 kPlaster = vec3(0.46, 0.44, 0.415);

void main() {
  vec3 n = normalize(normal);
  float facing = max(dot(n, frame.light.xyz), 0.0);
  vec3 light = frame.light_color.rgb * (facing * sun_seen(position, n) / 3.14159265);
  out_color = leave(kPlaster * (light + sky_diffuse(n) * sky_seen.x), 1.0);
}
