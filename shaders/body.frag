// The form under a drape.
#include "frame.glsl"

in vec3 position;
in vec3 normal;
in vec2 sky_visibility;
out vec4 out_color;

void main() {
  vec3 n = normalize(normal);
  vec3 light = sky_diffuse(n) * sky_visibility.x;
  for (light_index = 0; light_index <= last_light(); ++light_index)
    light += current_light_color() * (max(dot(n, current_light().xyz), 0.0) * key_visibility(position, n) / 3.14159265);
  out_color = encoded(FORM_REFLECTANCE * light, 1.0);
}
