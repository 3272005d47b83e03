// Method `cloth`: the far-field reflectance of the whole period. It is in method_repeat.glsl, whose tables it reads.
#include "method_repeat.glsl"
