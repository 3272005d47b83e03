#include "cloth/layers.h"

#include <algorithm>

namespace weftlight::cloth {

Cloth one_layer(const Cloth& cloth, int i) {
  if (cloth.layers.empty()) return cloth;
  const ClothLayer& l = cloth.layers[static_cast<size_t>(i)];
  Cloth one;
  one.width_mm = cloth.width_mm, one.depth_mm = cloth.depth_mm, one.yarns = cloth.yarns, one.dyes = cloth.dyes;
  one.ends.assign(cloth.ends.begin() + l.first_end, cloth.ends.begin() + l.first_end + l.ends);
  one.picks.assign(cloth.picks.begin() + l.first_pick, cloth.picks.begin() + l.first_pick + l.picks);
  one.first_end = l.first_end, one.first_pick = l.first_pick;
  one.up = BitMatrix(l.picks, l.ends);
  for (int p = 0; p < l.picks; ++p) {
    for (int e = 0; e < l.ends; ++e) one.up.set(p, e, cloth.up.get(l.first_pick + p, l.first_end + e));
    if (cloth.warp_level_mm.empty()) continue;
    const auto from = static_cast<std::ptrdiff_t>(l.first_pick + p) * cloth.up.cols() + l.first_end;
    const auto add = [&](std::vector<float>& to, const std::vector<float>& row) {
      to.insert(to.end(), row.begin() + from, row.begin() + from + l.ends);
    };
    add(one.warp_level_mm, cloth.warp_level_mm), add(one.weft_level_mm, cloth.weft_level_mm);
  }
  return one;
}

std::vector<Cloth> layers_apart(const Cloth& cloth) {
  std::vector<Cloth> out;
  for (size_t i = 0; i < cloth.layers.size(); ++i) out.push_back(one_layer(cloth, static_cast<int>(i)));
  return out;
}

int front_layer(const Cloth& cloth) {
  int front = 0;
  double highest = 0;
  for (int i = 0; i < static_cast<int>(cloth.layers.size()); ++i) {
    const ClothLayer& l = cloth.layers[static_cast<size_t>(i)];
    double sum = 0;
    for (int p = l.first_pick; p < l.first_pick + l.picks; ++p)
      for (int e = l.first_end; e < l.first_end + l.ends; ++e)
        sum += static_cast<double>(cloth.weft_level_mm[static_cast<size_t>(p) * static_cast<size_t>(cloth.up.cols()) +
                                                       static_cast<size_t>(e)]);
    const double mean = sum / (static_cast<double>(l.ends) * l.picks);
    if (i == 0 || mean > highest) highest = mean, front = i;
  }
  return front;
}

int layer_of(const Cloth& cloth, System system, int thread) {
  int layer = 0;
  while (layer + 1 < static_cast<int>(cloth.layers.size())) {
    const ClothLayer& next = cloth.layers[static_cast<size_t>(layer) + 1];
    if (thread < (system == System::kWarp ? next.first_end : next.first_pick)) break;
    ++layer;
  }
  return layer;
}

}  // namespace weftlight::cloth
