// Depth of the key light's occluders.
#include "frame.glsl"

in vec3 in_position;

void main() {
  vec4 at = frame.world_to_shadow * vec4(in_position, 1.0);
  gl_Position = vec4(at.xyz * 2.0 - 1.0, 1.0);
}
