// A seamless studio backdrop: the background colour, brighter behind the cloth, darker towards the edges.
#include "frame.glsl"

uniform sampler2D environment_map;

in vec2 at;
out vec4 out_color;

// The environment map along a direction; its centre lies at -z.
vec3 surroundings(vec3 d) {
  vec2 turn = vec2(frame.camera_rays[0].w, frame.camera_rays[1].w);
  vec3 p = vec3(d.x * turn.x - d.z * turn.y, d.y, d.z * turn.x + d.x * turn.y);
  vec2 uv = vec2(atan(p.x, -p.z) * 0.15915494 + 0.5, acos(clamp(p.y, -1.0, 1.0)) * 0.31830989);
  return textureLod(environment_map, uv, 0.0).rgb;
}

void main() {
  if (frame.camera_rays[2].w > 0.5) {
    out_color = encoded(surroundings(normalize(frame.camera_rays[0].xyz * at.x + frame.camera_rays[1].xyz * at.y + frame.camera_rays[2].xyz)), 1.0);
    return;
  }
  vec2 d = vec2(at.x * 0.75, at.y * 0.9 - 0.12);
  float fall = dot(d, d);
  vec3 c = frame.background.rgb * mix(1.03, 0.70, smoothstep(0.0, 1.7, fall));
  // Noise below one grey level prevents banding of the gradient.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  out_color = vec4(min(c * (1.0 + noise * 0.012), vec3(1.0)), 1.0);
}
