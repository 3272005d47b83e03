#include <algorithm>
#include <cmath>

#include "weaves/families.h"

namespace weftlight::weaves {

std::vector<int> pattern_line(std::string_view form, int ends, int height) {
  std::vector<int> line;
  for (int e = 0; e < ends; ++e) {
    const double t = static_cast<double>(e) / std::max(ends, 1);
    if (form != "points" && form != "saw") {
      line.push_back(wave_at(t, height));
      continue;
    }
    line.push_back(static_cast<int>(std::lround(height * (form == "saw" ? t : 1 - std::abs(2 * t - 1)))));
  }
  return line;
}

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
