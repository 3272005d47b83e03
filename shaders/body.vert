// The form under the cloth.
#include "frame.glsl"

in vec3 in_position;
in vec3 in_normal;
in vec2 in_sky;

out vec3 position;
out vec3 normal;
out vec2 sky_visibility;

void main() {
  position = in_position;
  normal = in_normal;
  sky_visibility = in_sky;
  gl_Position = frame.world_to_clip * vec4(in_position, 1.0);
}
