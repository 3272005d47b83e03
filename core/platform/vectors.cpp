#include "platform/vectors.h"

namespace weftlight::platform {

Vectors widest_vectors() {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(_WIN32)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return Vectors::kAvx2;
#endif
  return Vectors::kBaseline;
}

}  // namespace weftlight::platform
