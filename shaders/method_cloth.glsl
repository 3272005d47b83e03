// SampledMethod `cloth`: the answer of the whole period; it stands beside that of `repeat`, whose tables it reads.
#include "method_repeat.glsl"
