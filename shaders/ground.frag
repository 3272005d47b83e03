// Darkens the backdrop by the light that the cloth takes away: key light through the shadow map, sky through
// the map of what each point of the ground sees.
#include "frame.glsl"

uniform sampler2D ground_sky_map;

in vec3 position;
in vec2 across;
out vec4 out_color;

const vec3 kGround = vec3(0.0, 1.0, 0.0);

void main() {
  float sky = texture(ground_sky_map, across * 0.5 + 0.5).r;
  float open = smoothstep(1.0, 0.75, length(across));  // ends before the map does
  float key = max(frame.light.y, 0.0) * dot(frame.light_color.rgb, vec3(0.3333)) / 3.14159265;
  float soft = dot(sky_diffuse(kGround), vec3(0.3333));
  float lit = 1.0 - frame.shadow.w * (1.0 - sun_seen(position, kGround));
  float left = (key * lit + soft * sky) / max(key + soft, 1e-4);
  out_color = vec4(0.0, 0.0, 0.0, (1.0 - left) * 0.62 * open);
}
