in vec4 strip_color;
out vec4 out_color;

// A pixel's middle may lie beyond the strip, where what is interpolated runs on.
void main() { out_color = vec4(max(strip_color.rgb, vec3(0.0)), clamp(strip_color.a, 0.0, 1.0)); }
