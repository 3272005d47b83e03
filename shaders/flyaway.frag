in vec4 leaving;
out vec4 out_color;

// A pixel's middle may lie beyond the strip, where what is interpolated runs on.
void main() { out_color = vec4(max(leaving.rgb, vec3(0.0)), clamp(leaving.a, 0.0, 1.0)); }
