#include <algorithm>

#include "weaves/families.h"

namespace weftlight::weaves {

std::vector<int> network_threading(const std::vector<int>& initial, const std::vector<int>& line, int shafts) {
  const int rows = static_cast<int>(initial.size());
  std::vector<int> threading;
  if (rows == 0 || shafts < 1) return threading;
  for (size_t end = 0; end < line.size(); ++end) {
    // For this end the network has every `rows`-th shaft; takes the first at or above the line, cyclically.
    const int base = initial[end % initial.size()] % rows;
    const int height = std::max(line[end], 0);
    int shaft = height - height % rows + base;
    if (shaft < height) shaft += rows;
    threading.push_back(shaft % shafts);
  }
  return threading;
}

}  // namespace weftlight::weaves
