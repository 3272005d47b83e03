// The draped cloth. Texture coordinates become repeats of the tile here: the mesh's uv are millimetres from its own
// corner, so that a cloth far from the origin of its uv keeps its precision.
#include "frame.glsl"

in vec3 in_position;
in vec3 in_normal;
in vec3 in_tangent;
in vec2 in_uv_mm;
in vec2 in_sky;

out vec3 position;
out vec3 normal;
centroid out vec3 normal_inside;
centroid out vec3 tangent;
out vec2 tile;
out vec2 sky_visibility;

void main() {
  position = in_position;
  normal = in_normal;
  normal_inside = in_normal;
  tangent = in_tangent;
  tile = in_uv_mm * frame.tile.xy + frame.tile.zw;
  sky_visibility = in_sky;
  gl_Position = frame.world_to_clip * vec4(in_position, 1.0);
}
