// What the cloth hangs on.
#include "frame.glsl"

in vec3 in_position;
in vec3 in_normal;
in vec2 in_sky;

out vec3 position;
out vec3 normal;
out vec2 sky_seen;

void main() {
  position = in_position;
  normal = in_normal;
  sky_seen = in_sky;
  // Drawn a little thinner, so that it never shows through the cloth that lies on it.
  gl_Position = frame.world_to_clip * vec4(in_position - in_normal * (frame.ground.y * 0.0022), 1.0);
}
