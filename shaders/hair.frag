in vec4 leaving;
out vec4 out_color;

void main() { out_color = leaving; }
