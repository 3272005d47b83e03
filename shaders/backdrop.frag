// A seamless studio sweep: the background's colour, a pool of light behind the cloth, darker to the edges.
#include "frame.glsl"

in vec2 at;
out vec4 out_color;

void main() {
  vec2 d = vec2(at.x * 0.75, at.y * 0.9 - 0.12);
  float fall = dot(d, d);
  vec3 c = frame.background.rgb * mix(1.03, 0.70, smoothstep(0.0, 1.7, fall));
  // A step of noise below one grey level keeps the gradient from banding.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  out_color = vec4(min(c * (1.0 + noise * 0.012), vec3(1.0)), 1.0);
}
