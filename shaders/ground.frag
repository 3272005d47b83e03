// Darkens the backdrop by the light that the cloth blocks from the ground.
uniform sampler2D ground_map;

in vec3 position;
in vec2 across;
out vec4 out_color;

void main() {
  float open = smoothstep(1.0, 0.7, length(across));  // ends before the map does
  out_color = vec4(0.0, 0.0, 0.0, (1.0 - texture(ground_map, across * 0.5 + 0.5).r) * open);
}
