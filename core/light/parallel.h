#pragma once
// A loop over 0..count-1 on a few threads, interleaved. The body must not depend on the order.

#include <thread>
#include <vector>

#include "light/names.h"

namespace weftlight::light {

template <class Body>
void in_parallel(int count, int threads, const Body& body) {
  const int stride = threads > 1 ? threads : 1;
  std::vector<std::thread> crew;
  for (int k = 1; k < stride; ++k)
    crew.emplace_back([&body, k, count, stride] {
      for (int i = k; i < count; i += stride) body(i);
    });
  for (int i = 0; i < count; i += stride) body(i);
  for (std::thread& t : crew) t.join();
}

}  // namespace weftlight::light
