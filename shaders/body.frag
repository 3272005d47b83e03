// Matt plaster: quiet beside any cloth.
#include "frame.glsl"

in vec3 position;
in vec3 normal;
in vec2 sky_seen;
out vec4 out_color;

const vec3 kPlaster = vec3(0.46, 0.44, 0.415);

void main() {
  vec3 n = normalize(normal);
  vec3 light = sky_diffuse(n) * sky_seen.x;
  for (light_at = 0; light_at <= last_light(); ++light_at)
    light += light_color_here() * (max(dot(n, light_here().xyz), 0.0) * sun_seen(position, n) / 3.14159265);
  out_color = leave(kPlaster * light, 1.0);
}
