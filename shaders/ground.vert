// The ground: a square around the cloth, visible only by its shadow.
#include "frame.glsl"

out vec3 position;
out vec2 across;

void main() {
  across = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, gl_VertexID < 2 ? -1.0 : 1.0);
  position = vec3(frame.ground.z + across.x * frame.ground.y, frame.ground.x, frame.ground.w + across.y * frame.ground.y);
  gl_Position = frame.world_to_clip * vec4(position, 1.0);
}
