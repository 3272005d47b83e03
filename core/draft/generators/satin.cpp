#include <numeric>

#include "draft/generators/families.h"

namespace weftlight::draft {

std::vector<int> satin_steps(int shafts) {
  std::vector<int> steps;
  for (int s = 2; s < shafts - 1; ++s)
    if (std::gcd(s, shafts) == 1) steps.push_back(s);
  return steps;
}

}  // namespace weftlight::draft
