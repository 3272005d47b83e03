// Blends one picture into a mean of pictures, or copies the mean back (editor/gl/average.h). The card decodes and
// encodes sRGB.
in vec2 at;
out vec4 out_color;

uniform sampler2D pass_map;

void main() { out_color = texelFetch(pass_map, ivec2(gl_FragCoord.xy), 0); }
