// One picture on its way into a mean of pictures, or the mean out of it (editor/gl/average.h).
in vec2 at;
out vec4 out_color;

uniform sampler2D pass_map;
uniform int encoded;   // 1: the picture holds sRGB-encoded values

float decode(float c) { return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4); }

void main() {
  vec4 c = texelFetch(pass_map, ivec2(gl_FragCoord.xy), 0);
  out_color = encoded == 1 ? vec4(decode(c.r), decode(c.g), decode(c.b), c.a) : c;
}
