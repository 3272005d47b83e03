in vec4 strip_color;
out vec4 out_color;

// A pixel's centre may lie outside the strip, where interpolated values extrapolate.
void main() { out_color = vec4(max(strip_color.rgb, vec3(0.0)), clamp(strip_color.a, 0.0, 1.0)); }
